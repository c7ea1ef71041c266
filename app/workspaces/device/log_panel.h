#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

#include <map>
#include <string>

namespace halbench::widgets {
class LogView;
}

namespace halbench::app {

/// What board, link, procedures and window said and what happened to the actuator, newest last; bounded.
class LogPanel : public QWidget {
    Q_OBJECT

public:
    explicit LogPanel(Workbench& bench, QWidget* parent = nullptr);
    QString text() const;

Q_SIGNALS:
    /// What was added last.
    void said(halbench::app::MessageLevel level, const QString& text);

private:
    void add(MessageLevel level, const QString& source, const QString& words);
    void note(const QString& source, const QString& words);
    void onReport();
    void onProcedure();
    void onDrive();
    void addEnd(const QString& procedure);
    void onRecording();
    void onDevice();
    void onValues();

    Workbench& m_bench;
    bool m_wasArmed = false;
    bool m_wasLatched = false;
    bool m_wasRecording = false;
    QString m_procedure;                    ///< that runs
    QString m_motion;                       ///< that runs by hand
    std::map<std::string, double> m_values; ///< on the device, as it was told last
    widgets::LogView* m_view = nullptr;
};

} // namespace halbench::app
