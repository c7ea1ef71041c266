#include "app/window/dock_layout.h"
#include "app/workspaces/monitor_panel.h"
#include "tests/gui/screenshots/photographer.h"

namespace halbench::app {

bool Photographer::takeMonitor() {
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
    view.plots = {{{"reference", "position"}, {}, {}}, {{"speed"}, {}, {}}, {{"current_command"}, {}, {}}};
    view.trigger = {true, "speed", control::TriggerMode::Normal, control::TriggerSlope::Rising, 0.0, 0.5, 1.0,
                    0.25, 0.0};
    view.derived = {{"field", "sqrt(hall.a^2 + hall.b^2)", ""}};
    auto* monitor = static_cast<MonitorPanel*>(m_window.docks().panel("monitor"));
    monitor->setView(view);
    takePanel("monitor");
    trigger(*monitor, "S");
    takePanel("derived");
    return m_isSaved;
}

} // namespace halbench::app
