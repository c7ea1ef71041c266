#pragma once

#include "app/window/main_window.h"
#include "app/window/preferences/preferences.h"
#include "widgets/figure/figure_view.h"

#include <QPoint>
#include <QSize>
#include <QString>
#include <QtTest/QTest>

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

class MonitorPanel;

/// Goes through the window as its user would and takes pictures of what is seen, light and dark.
class Photographer {
public:
    Photographer(QString folder, QString language, QSize size);
    /// The Monitor in its typical uses: a motor that turns, XY, cursors with statistics, a plot with its own
    /// time axis, columns with a second Monitor, spectrum and spectrogram, one event that was caught.
    bool takeMonitor();
    /// Pages of the help: the first one, pictures, a panel's section, one that is in English only.
    bool takeHelp();
    /// A calibration with its pictures, as fast as possible: a busy machine would be stopped on the way.
    bool takeCalibrationOnly();
    /// Calibration, then the relay experiment to the gains that are proposed from it.
    bool takeRelay();
    /// Tune alone, for a motor that is known.
    bool takeTune();
    /// The crossover is dragged through the Bode plot, then the margin; the pictures follow.
    bool takeDragging();
    /// Those of the folder "recordings" beside the pictures: laid over each other, their results, one that is
    /// played.
    bool takeRecordings();
    bool takeAll();
    /// Where it is watched: its signals, and its field and pose, after a while of any motion of its own.
    bool takeDevice(const QString& uri);

private:
    static constexpr int Patience_ms = 120000;
    static constexpr int DataTime_ms = 9500; ///< until a plot has something to show
    static constexpr int Settling_ms = 400;

    static Preferences dressed(const QString& language);
    static void wear(ThemeChoice choice);
    DeviceSession& session() { return m_window.bench().session(); }
    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }
    void front(const char* panel);
    /// A panel in front, when it has seen enough.
    void takePanel(const char* panel, const char* scene);
    /// What the key does in the panel.
    static void trigger(const QWidget& panel, const char* key);
    /// A motor that follows a reference for longer than the pictures take.
    void startMotion(const char* reference);
    bool endMotion();
    MonitorPanel& monitor();
    widgets::LivePlotStack& plots();
    void takeCursors();
    void takeOwnAxis();
    void takeColumns();
    void takeFurther();
    bool takeTrigger();
    void take(const QString& scene) { take(scene, m_window); }
    void take(const QString& scene, QWidget& shown);
    widgets::FigureView& openLoop();
    void mouse(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons);
    void hold(int handle);
    void pull(const QPoint& way);
    void letGo() { mouse(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton); }
    void takePerspectives(const QString& prefix);
    /// The main button of the panel's visible page.
    bool press(const char* panel, const char* context, const char* text);
    bool takeCalibration();
    bool takeIdentification();
    /// Designs kept beside each other, as a table and in the pictures.
    bool takeDesigns();
    bool takeFilters();
    bool takeTuning();

    QString m_folder;
    QString m_language;
    MainWindow m_window;
    QPoint m_hand; ///< in the picture of the open loop
    bool m_isSaved = true;
};

} // namespace halbench::app
