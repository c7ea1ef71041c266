#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <chrono>
#include <thread>

namespace halbench::app {
namespace {

/// No event is handled meanwhile, so that no other timer can bring the samples.
TEST_F(BenchTest, aFrameOfTheMonitorShowsWhatHasArrivedUntilIt) {
    MonitorPanel panel(bench());
    panel.resize(1200, 800);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return bench().history().range().has_value(); }));
    auto* stack = panel.findChild<widgets::LivePlotStack*>();
    const double before_s = bench().history().range()->end_s;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (bench().history().range()->end_s == before_s && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::yield();
        stack->refresh();
    }
    EXPECT_GT(bench().history().range()->end_s, before_s);
}

} // namespace
} // namespace halbench::app
