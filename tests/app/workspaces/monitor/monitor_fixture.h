#pragma once

#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/monitor/five_plots.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <memory>

namespace halbench::app {

/// The Monitor alone, on the screen, driven through its widgets.
class MonitorTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<MonitorPanel>(bench());
        panel->setView(fivePlots());
        panel->resize(1200, 900);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    widgets::LivePlotStack& stack() { return *panel->findChild<widgets::LivePlotStack*>(); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        auto* plot = panel->findChild<widgets::LivePlot*>();
        plot->setFocus();
        QTest::keyClick(plot, key, modifiers);
    }

    std::unique_ptr<MonitorPanel> panel;
};

} // namespace halbench::app
