// The Monitor in its typical uses, as resources/help/monitor.md tells them.
#include "app/window/docks/dock_layout.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/gui/screenshots/photographer.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>

namespace halbench::app {

using Command = widgets::LivePlotStack::Command;

bool Photographer::takeMonitor() {
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    startMotion("sine,amplitude_deg=100,period_s=2");
    front("monitor");
    QTest::qWait(DataTime_ms);
    takeCursors();
    takeOwnAxis();
    takeColumns();
    takeFurther();
    takePanel("spectrum", "spectrum");
    QWidget& spectrum = *m_window.docks().panel("spectrum");
    trigger(spectrum, "O");
    QTest::qWait(Settling_ms);
    take(QStringLiteral("monitor-spectrogram"));
    trigger(spectrum, "O");
    if (!takeTrigger() || !endMotion()) {
        return false;
    }
    monitor().setView(MonitorView());
    startMotion("ramp,rate_deg_s=720");
    takePanel("monitor", "watch"); // a motor that turns
    takePanel("xy", "xy");         // its two Hall sensors, with the ellipse
    return m_isSaved;
}

/// Two pairs, one of which measures, with the statistics between its cursors.
void Photographer::takeCursors() {
    widgets::LivePlotStack& stack = plots();
    MonitorView view;
    view.plots = {{{"reference", "position"}, {}, {}}, {{"speed"}, {}, {}}, {{"current_command"}, {}, {}}};
    view.derived = {{"field", "sqrt(hall.a^2 + hall.b^2)", ""}};
    monitor().setView(view);
    QTest::qWait(DataTime_ms / 5);
    stack.setPaused(true);
    const double end_s = stack.timeRange().end_s;
    widgets::CursorPairs pairs({{QStringLiteral("fall"), end_s - 8.4, end_s - 7.4},
                                {QStringLiteral("rise"), end_s - 3.2, end_s - 2.2}},
                               1);
    pairs.setVisible(true);
    stack.setCursorPairs(pairs);
    trigger(monitor(), "S");
    QTest::qWait(Settling_ms);
    take(QStringLiteral("monitor-cursors"));
    trigger(monitor(), "S");
    stack.setCursorsVisible(false);
    stack.setPaused(false);
}

/// A second of the speed over ten of the angle.
void Photographer::takeOwnAxis() {
    plots().setOwnTime(1, widgets::OwnTime{1.0, true});
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("monitor-own-axis"));
    plots().setOwnTime(1, std::nullopt);
}

/// Beside each other, while cursors measure and without them.
void Photographer::takeColumns() {
    widgets::LivePlotStack& stack = plots();
    monitor().setView(MonitorView());
    stack.movePlot(3, 1);
    stack.movePlot(3, 1);
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("monitor-columns"));
    stack.setCursorsVisible(true);
    QTest::qWait(Settling_ms);
    take(QStringLiteral("monitor-columns-cursors"));
    stack.setCursorsVisible(false);
    monitor().setView(MonitorView());
}

/// Columns of other widths with a second Monitor below them, then that one afloat.
void Photographer::takeFurther() {
    MonitorView view;
    view.plots = {{{"position", "reference"}, {}, {}}, {{"speed"}, {}, {}}, {{"hall.a", "hall.b"}, {}, {}}};
    view.plots[0].height_ratio = 1.3;
    view.plots[1].height_ratio = 0.7;
    view.plots[0].width_ratio = 1.1;
    view.plots[2].column = 1;
    view.plots[2].width_ratio = 0.9;
    monitor().setView(view);
    ads::CDockWidget* first = m_window.docks().docks().value(QStringLiteral("monitor"));
    ads::CDockWidget* second = m_window.docks().docks().value(QStringLiteral("monitor2"));
    second->toggleView(true);
    second->dockManager()->addDockWidget(ads::BottomDockWidgetArea, second, first->dockAreaWidget());
    view.plots = {{{"current_command", "current.a"}, {}, {}}, {{"coil_temperature.a"}, {}, {}}};
    view.plots[1].column = 1;
    view.span_s = 4.0;
    static_cast<MonitorPanel*>(second->widget())->setView(view);
    front("monitor");
    QTest::qWait(DataTime_ms / 2);
    take(QStringLiteral("monitor-two"));
    second->setFloating();
    second->floatingDockContainer()->resize(m_window.size() * 2 / 3);
    QTest::qWait(Settling_ms);
    take(QStringLiteral("monitor-afloat"), *second->floatingDockContainer());
    second->toggleView(false);
    monitor().setView(MonitorView());
}

/// One event is caught and stands.
bool Photographer::takeTrigger() {
    MonitorView view = monitor().view();
    view.trigger = {true, "speed", control::TriggerMode::Single, control::TriggerSlope::Rising, 0.0, 0.5, 1.0,
                    0.25, 0.0};
    monitor().setView(view);
    front("monitor");
    if (!wait([this] { return plots().event_s().has_value(); })) {
        return false;
    }
    QTest::qWait(Settling_ms);
    take(QStringLiteral("monitor-trigger"));
    return true;
}

MonitorPanel& Photographer::monitor() {
    return *static_cast<MonitorPanel*>(m_window.docks().panel("monitor"));
}

widgets::LivePlotStack& Photographer::plots() {
    return *monitor().findChild<widgets::LivePlotStack*>();
}

} // namespace halbench::app
