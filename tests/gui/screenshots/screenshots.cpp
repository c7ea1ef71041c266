#include "app/procedures/move_procedure.h"
#include "app/window/dock_layout.h"
#include "app/window/help_window.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "app/window/window_application.h"
#include "app/workspaces/design_names.h"
#include "app/workspaces/loop_view.h"
#include "app/workspaces/monitor_panel.h"
#include "app/workspaces/page_chooser.h"
#include "app/workspaces/tune_form.h"
#include "tests/app/workspaces/published_motor.h"
#include "widgets/figure_view.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QMouseEvent>
#include <QPixmap>
#include <QPushButton>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QtTest/QTest>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string_view>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Patience_ms = 120000;
constexpr int DataTime_ms = 9500;
constexpr int Settling_ms = 400;

/// Goes through the window as its user would and takes pictures of what is seen, light and dark.
class Photographer {
public:
    Photographer(QString folder, QString language, QSize size)
        : m_folder(std::move(folder)), m_language(std::move(language)), m_window(dressed(m_language)) {
        m_window.resize(size);
        m_window.show();
    }

    /// The Monitor in its other uses: trigger, spectrum, XY, statistics with derived signals.
    bool takeMonitor() {
        m_window.connectDevice(QStringLiteral("sim:htm"));
        if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
            return false;
        }
        startMotion("ramp,rate_deg_s=720");
        takePanel("xy");
        session().abortProcedure();
        if (!wait([this] { return session().procedure().isEmpty(); })) {
            return false;
        }
        session().request([](devices::Device& device) { return device.clearStop(); }, [](Result<void>) {});
        startMotion("sine,amplitude_deg=100,period_s=2");
        takePanel("spectrum");
        QWidget& spectrum = *m_window.docks().panel("spectrum");
        trigger(spectrum, "O");
        QTest::qWait(Settling_ms);
        take(QStringLiteral("monitor-spectrogram"));
        trigger(spectrum, "O");
        MonitorView view;
        view.plots = {
            {{"reference", "position"}, {}, {}}, {{"speed"}, {}, {}}, {{"current_command"}, {}, {}}};
        view.trigger = {
            true, "speed", control::TriggerMode::Normal, control::TriggerSlope::Rising, 0.0, 0.5, 1.0,
            0.25, 0.0};
        view.derived = {{"field", "sqrt(hall.a^2 + hall.b^2)", ""}};
        auto* monitor = static_cast<MonitorPanel*>(m_window.docks().panel("monitor"));
        monitor->setView(view);
        takePanel("monitor");
        trigger(*monitor, "S");
        takePanel("derived");
        return m_isSaved;
    }

    /// Pages of the help: the first one, pictures, a panel's section, one that is in English only.
    bool takeHelp() {
        const std::pair<const char*, const char*> pages[] = {
            {"help-index", "index.md"},         {"help-monitor", "monitor.md"},
            {"help-drive", "monitor.md#drive"}, {"help-field", "monitor.md#field"},
            {"help-tune", "tuning.md#margins"}, {"help-english", "protocol.md"}};
        for (const auto& [scene, address] : pages) {
            HelpWindow help(address, &m_window);
            help.show();
            take(QString::fromLatin1(scene), help);
        }
        return m_isSaved;
    }

    /// A calibration with its pictures, as fast as possible: a busy machine would be stopped on the way.
    bool takeCalibrationOnly() {
        m_window.connectDevice(QStringLiteral("sim:htm"));
        if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
            return false;
        }
        session().setPace({0.0});
        return takeCalibration() && m_isSaved;
    }

    /// Tune alone, for a motor that is known.
    bool takeTune() {
        m_window.connectDevice(QStringLiteral("sim:htm"));
        if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
            return false;
        }
        m_window.bench().setIdentification(publishedMotor());
        return takeTuning() && m_isSaved;
    }

    /// The crossover is dragged through the Bode plot, then the margin; the pictures follow.
    bool takeDragging() {
        m_window.connectDevice(QStringLiteral("sim:htm"));
        if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
            return false;
        }
        m_window.bench().setIdentification(publishedMotor());
        m_window.docks().setPerspective(Perspective::Tune);
        if (!wait([this] { return m_window.bench().design().has_value(); })) {
            return false;
        }
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("drag-1-before"));
        hold(0);
        pull({-28, 0});
        take(QStringLiteral("drag-2-slower"));
        pull({70, 0});
        take(QStringLiteral("drag-3-faster"));
        pull({160, 0});
        take(QStringLiteral("drag-4-beyond-reach"));
        pull({-188, 0});
        letGo();
        QTest::qWait(Settling_ms); // who looks for the other handle
        hold(1);
        pull({0, -14});
        take(QStringLiteral("drag-5-margin"));
        letGo();
        if (!wait([this] { return m_window.bench().design()->method == "edited"; })) {
            return false;
        }
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("drag-6-released"));
        return m_isSaved;
    }

    /// Those of the folder "recordings" beside the pictures: laid over each other, their results, one that is
    /// played.
    bool takeRecordings() {
        m_window.bench().recording().setFolder(QDir(m_folder).filePath(QStringLiteral("recordings")));
        m_window.docks().setPerspective(Perspective::Record);
        QTest::qWait(Settling_ms);
        QWidget* panel = m_window.docks().panel("recordings");
        const QList<QTableView*> tables = panel->findChildren<QTableView*>(); // others are of items
        QTableView* table = *std::find_if(tables.begin(), tables.end(), [](const QTableView* one) {
            return qobject_cast<const QTableWidget*>(one) == nullptr;
        });
        if (!wait([table] { return table->model()->rowCount() > 0; })) {
            return false;
        }
        table->selectAll();
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("recordings-overlay"));
        auto* tabs = panel->findChild<QTabWidget*>();
        tabs->setCurrentIndex(1);
        take(QStringLiteral("recordings-results"));
        tabs->setCurrentIndex(0);
        table->selectRow(0);
        press("recordings", "halbench::app::RecordingsPanel", "Play");
        QTest::qWait(DataTime_ms / 2);
        take(QStringLiteral("recordings-played"));
        return m_isSaved;
    }

    bool takeAll() {
        takePerspectives(QStringLiteral("empty-"));
        m_window.connectDevice(QStringLiteral("sim:htm"));
        if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
            return false;
        }
        startMotion("sine,amplitude_deg=100,period_s=2");
        QTest::qWait(DataTime_ms);
        takePerspectives({});
        session().abortProcedure();
        if (!wait([this] { return session().procedure().isEmpty(); })) {
            return false;
        }
        session().request([](devices::Device& device) { return device.clearStop(); }, [](Result<void>) {});
        return takeCalibration() && takeIdentification() && takeTuning() && m_isSaved;
    }

private:
    static Preferences dressed(const QString& language) {
        wear(ThemeChoice::Light);
        Preferences preferences;
        preferences.theme = ThemeChoice::Light;
        preferences.language = language;
        return preferences;
    }

    static void wear(ThemeChoice choice) {
        if (const Result<widgets::Theme> theme = widgets::loadTheme(themeName(choice).toStdString())) {
            widgets::applyTheme(*qApp, *theme, {QLocale(), widgets::Dress().fontSize_pt});
        }
    }

    DeviceSession& session() { return m_window.bench().session(); }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    /// A panel in front, when it has seen enough.
    void takePanel(const char* panel) {
        for (ads::CDockWidget* dock : m_window.docks().docks()) {
            if (dock->objectName() == QLatin1String(panel)) {
                dock->setAsCurrentTab();
            }
        }
        QTest::qWait(DataTime_ms);
        take(QStringLiteral("monitor-") + QLatin1String(panel));
    }

    /// What the key does in the panel.
    static void trigger(const QWidget& panel, const char* key) {
        for (QAction* action : panel.actions()) {
            if (action->shortcut() == QKeySequence(QLatin1String(key))) {
                action->trigger();
            }
        }
    }

    /// A motor that follows a reference for longer than the pictures take.
    void startMotion(const char* reference) {
        session().runProcedure(
            QCoreApplication::translate("Panels", "Drive"),
            [reference](devices::Device& device, const ProcedureObserver& observer) {
                MoveConfig config;
                config.reference = *parseMoveReference(reference);
                config.duration_s = 60.0;
                return runMove(device, config, observer);
            },
            [](Result<MoveResult>) {});
    }

    void take(const QString& scene) { take(scene, m_window); }

    void take(const QString& scene, QWidget& shown) {
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            wear(choice);
            QTest::qWait(Settling_ms);
            const QString file = QStringLiteral("%1-%2-%3-%4x.png")
                                     .arg(scene, themeName(choice), m_language)
                                     .arg(shown.devicePixelRatioF());
            m_isSaved = shown.grab().save(QDir(m_folder).filePath(file)) && m_isSaved;
        }
    }

    widgets::FigureView& openLoop() {
        return m_window.docks().panel("tune")->findChild<LoopView*>()->picture();
    }

    void mouse(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(m_hand), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(&openLoop(), &event);
    }

    void hold(int handle) {
        m_hand = openLoop().handlePlace(handle).value_or(QPoint());
        mouse(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    }

    void pull(const QPoint& way) {
        m_hand += way;
        mouse(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
    }

    void letGo() { mouse(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton); }

    void takePerspectives(const QString& prefix) {
        for (const Perspective perspective : AllPerspectives) {
            m_window.docks().setPerspective(perspective);
            take(prefix + perspectiveId(perspective));
        }
    }

    /// The main button of the panel's visible page.
    bool press(const char* panel, const char* context, const char* text) {
        QTest::qWait(Settling_ms);
        const QString words = QCoreApplication::translate(context, text);
        for (auto* button : m_window.docks().panel(panel)->findChildren<QPushButton*>()) {
            if (button->text() == words && wait([&] { return button->isEnabled(); })) {
                button->click();
                return true;
            }
        }
        return false;
    }

    bool takeCalibration() {
        m_window.docks().setPerspective(Perspective::Identify);
        for (ads::CDockWidget* dock : m_window.docks().docks()) {
            if (dock->objectName() == QStringLiteral("calibrate")) {
                dock->setAsCurrentTab();
            }
        }
        take(QStringLiteral("calibrate"));
        if (!press("calibrate", "halbench::app::CalibratePanel", "Start calibration")) {
            return false;
        }
        QTest::qWait(DataTime_ms);
        take(QStringLiteral("calibrate-run"));
        session().setPace({0.0}); // as fast as possible
        const bool isDone = wait([this] { return session().procedure().isEmpty(); });
        QTest::qWait(Settling_ms);
        auto* pictures = m_window.docks().panel("calibrate")->findChild<QTabWidget*>();
        for (int page = 0; page < pictures->count(); ++page) {
            pictures->setCurrentIndex(page);
            take(QStringLiteral("calibrate-result%1").arg(page + 1));
        }
        return isDone && press("calibrate", "halbench::app::CalibratePanel", "Apply");
    }

    bool takeIdentification() {
        for (ads::CDockWidget* dock : m_window.docks().docks()) {
            if (dock->objectName() == QStringLiteral("identify")) {
                dock->setAsCurrentTab();
            }
        }
        session().setPace({10.0});
        if (!press("identify", "halbench::app::IdentifyPanel", "Start identification")) {
            return false;
        }
        QTest::qWait(DataTime_ms);
        take(QStringLiteral("identify-run"));
        session().setPace({0.0});
        if (!wait([this] { return m_window.bench().identification().has_value(); })) {
            return false;
        }
        session().setPace({1.0});
        for (auto* tabs : m_window.docks().panel("identify")->findChildren<QTabWidget*>()) {
            for (int page = 0; page < tabs->count(); ++page) {
                tabs->setCurrentIndex(page);
                take(QStringLiteral("identify-result%1").arg(page + 1));
            }
        }
        return true;
    }

    /// Designs kept beside each other, as a table and in the pictures.
    bool takeDesigns() {
        QWidget& tune = *m_window.docks().panel("tune");
        auto* origin = tune.findChild<TuneForm*>()->findChild<QComboBox*>();
        if (!press("tune", "halbench::app::TunePanel", "Designs")) {
            return false;
        }
        for (const char* method : {"lambda", "lqr", "recommended"}) {
            for (int i = 0; i < origin->count(); ++i) {
                if (origin->itemText(i).endsWith(designTitle(method))) {
                    origin->setCurrentIndex(i);
                    break;
                }
            }
            const bool isLast = method == std::string_view("recommended");
            if (!wait([&] { return m_window.bench().design()->method == method; }) ||
                !(isLast || press("tune", "halbench::app::DesignTable", "Keep this design"))) {
                return false;
            }
        }
        tune.findChild<QTableWidget*>("designs")->setCurrentCell(1, 0);
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("tune-designs"));
        tune.findChild<PageChooser*>()->findChild<QPushButton*>()->click();
        take(QStringLiteral("tune-compared"));
        auto* views = tune.findChild<LoopView*>();
        const std::pair<LoopView::View, const char*> scenes[] = {
            {LoopView::View::Nyquist, "tune-nyquist"},
            {LoopView::View::Nichols, "tune-nichols"},
            {LoopView::View::Sensitivity, "tune-sensitivity"},
            {LoopView::View::RootLocus, "tune-root-locus"}};
        for (const auto& [view, scene] : scenes) {
            views->setView(view);
            take(QLatin1String(scene));
        }
        views->setView(LoopView::View::Bode);
        return true;
    }

    bool takeTuning() {
        m_window.docks().setPerspective(Perspective::Tune);
        if (!wait([this] { return m_window.bench().design().has_value(); })) {
            return false;
        }
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("tune-design"));
        if (!takeDesigns()) {
            return false;
        }
        session().setPace({0.0});
        if (!press("tune", "halbench::app::TunePanel", "Apply and verify")) {
            return false;
        }
        const bool isDone = wait([this] { return session().procedure().isEmpty(); });
        QTest::qWait(DataTime_ms / 5);
        take(QStringLiteral("tune-verified"));
        return isDone;
    }

    QString m_folder;
    QString m_language;
    MainWindow m_window;
    QPoint m_hand; ///< in the picture of the open loop
    bool m_isSaved = true;
};

} // namespace

} // namespace halbench::app

int main(int count, char** words) {
    using namespace halbench::app;
    const std::map<QByteArray, bool (Photographer::*)()> subjects = {
        {"", &Photographer::takeAll},
        {"monitor", &Photographer::takeMonitor},
        {"help", &Photographer::takeHelp},
        {"recordings", &Photographer::takeRecordings},
        {"calibration", &Photographer::takeCalibrationOnly},
        {"tune", &Photographer::takeTune},
        {"dragging", &Photographer::takeDragging}};
    const auto subject = subjects.find(count == 6 ? QByteArray(words[5]) : QByteArray(""));
    if (count < 5 || count > 6 || subject == subjects.end()) {
        std::fprintf(stderr, "usage: halbench_screenshots FOLDER LANGUAGE WIDTH HEIGHT "
                             "[monitor|help|recordings|calibration|tune|dragging]\n");
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QStandardPaths::setTestModeEnabled(true);
    const QString folder = QString::fromLocal8Bit(words[1]);
    const QString language = chosenLanguage(QString::fromLocal8Bit(words[2]), {});
    const QSize size(QByteArray(words[3]).toInt(), QByteArray(words[4]).toInt());
    WindowApplication application(count, words);
    speak(application, language);
    QDir().mkpath(folder);
    Photographer photographer(folder, language, size);
    return (photographer.*subject->second)() ? 0 : 1;
}
