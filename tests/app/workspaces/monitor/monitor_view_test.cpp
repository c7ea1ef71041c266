// What the Monitor shows, taken and given back: as a project keeps it.
#include "app/workspaces/monitor/monitor_view.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"

#include <QAction>

namespace halbench::app {
namespace {

using MonitorViewTest = MonitorTest;

TEST_F(MonitorViewTest, aViewIsShownAgainToTheDigitOnceTheDeviceIsThere) {
    MonitorView view;
    view.plots = {{{"speed", "truth.speed"}, widgets::ValueRange{-12.3, 45.6}, "r/min"},
                  {{"hall.b"}, {}, {}}};
    view.span_s = 2.5;
    panel->setView(view);
    EXPECT_EQ(panel->view(), view); // it waits for a device and is not lost meanwhile
    connectTo("sim:htm", 5.0);
    ASSERT_EQ(stack().plots().size(), 2U);
    EXPECT_EQ(stack().plots()[0].curves.size(), 2U);
    EXPECT_EQ(stack().valueRange(0), (widgets::ValueRange{-12.3, 45.6}));
    EXPECT_TRUE(stack().isFollowing());
    EXPECT_EQ(panel->view(), view);
}

TEST_F(MonitorViewTest, aRightAxisIsPartOfTheView) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(stack().moveCurve(2, "speed", 1));
    const MonitorView kept = panel->view();
    EXPECT_EQ(kept.plots[1].rightNames, (std::vector<std::string>{"speed"}));
    EXPECT_EQ(kept.plots[1].signalNames, (std::vector<std::string>{"position", "reference"}));
    panel->setView(MonitorView());
    EXPECT_FALSE(widgets::hasRightAxis(stack().plots()[1]));
    panel->setView(kept);
    ASSERT_TRUE(widgets::hasRightAxis(stack().plots()[1]));
    EXPECT_EQ(stack().plots()[1].right.unit, "r/min");
    EXPECT_EQ(panel->view(), kept);
    // Other units: each axis has its own.
    DisplayUnits units;
    units.speed = SpeedUnit::RadiansPerSecond;
    bench().setDisplayUnits(units);
    EXPECT_EQ(stack().plots()[1].right.unit, "rad/s");
    EXPECT_EQ(stack().plots()[1].unit, QString::fromUtf8("\u00b0"));
}

TEST_F(MonitorViewTest, anAxisHeldInAnotherUnitIsLetGo) {
    MonitorView view;
    view.plots = {{{"hall.a"}, widgets::ValueRange{0.0, 1.0}, "T"}};
    panel->setView(view);
    connectTo("sim:htm", 5.0);
    ASSERT_EQ(stack().plots().size(), 1U);
    EXPECT_FALSE(stack().heldRange(0));
}

TEST_F(MonitorViewTest, aTimeAxisOfItsOwnIsPartOfTheView) {
    connectTo("sim:htm", 5.0);
    stack().setOwnTime(1, widgets::OwnTime{2.5, true});
    stack().setOwnTime(2, widgets::OwnTime{4.0, false});
    const MonitorView kept = panel->view();
    EXPECT_FALSE(kept.plots[0].ownTime);
    EXPECT_EQ(kept.plots[1].ownTime, (widgets::OwnTime{2.5, true}));
    EXPECT_EQ(kept.plots[2].ownTime, (widgets::OwnTime{4.0, false}));
    panel->setView(MonitorView());
    EXPECT_FALSE(stack().hasOwnTimes());
    panel->setView(kept);
    EXPECT_EQ(panel->view(), kept);
    bench().setDisplayUnits({{}, SpeedUnit::RadiansPerSecond}); // the axis stays
    EXPECT_EQ(panel->view().plots[2].ownTime, (widgets::OwnTime{4.0, false}));
    stack().setOwnTime(1, widgets::OwnTime{1e-4, false}); // as far as one can zoom
    EXPECT_NEAR(panel->view().plots[1].ownTime->span_s, 1e-4, 1e-9) << "a project refuses nothing";
}

TEST_F(MonitorViewTest, columnsArePartOfTheViewWithoutThoseThatShowNothing) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(stack().movePlot(3, 1));
    stack().openBeside(0, {}); // an empty plot in a column between
    ASSERT_TRUE(stack().separateBeside(0, "hall.a"));
    const MonitorView kept = panel->view();
    const auto columnsOf = [](const MonitorView& view) {
        std::vector<int> columns;
        for (const PlotChoice& plot : view.plots) {
            columns.push_back(plot.column);
        }
        return columns;
    };
    EXPECT_EQ(columnsOf(kept), (std::vector<int>{0, 0, 0, 0, 1, 2}));
    EXPECT_EQ(kept.plots[4].signalNames, std::vector<std::string>{"hall.a"});
    panel->setView(MonitorView());
    EXPECT_EQ(stack().columnCount(), 1);
    panel->setView(kept);
    EXPECT_EQ(panel->view(), kept);
    EXPECT_EQ(stack().columnCount(), 3);
}

TEST_F(MonitorViewTest, sizesArePartOfTheViewToTheDigitInAnyWindow) {
    connectTo("sim:htm", 5.0);
    MonitorView view = panel->view();
    view.plots[0].height_ratio = 1.73;
    view.plots[3].column = 1;
    view.plots[4].column = 1;
    view.plots[3].width_ratio = 0.62;
    panel->setView(view);
    EXPECT_EQ(panel->view().plots, view.plots);
    EXPECT_EQ(stack().plots()[4].width_ratio, 0.62);
    panel->resize(777, 555);
    QApplication::processEvents();
    EXPECT_EQ(panel->view().plots, view.plots);
    bench().setDisplayUnits({{}, SpeedUnit::RadiansPerSecond});
    EXPECT_EQ(panel->view().plots, view.plots) << "other units are no reason";
    // The first plot of a column is not there on this device: its column is as wide as it said.
    view.plots[3].signalNames = {"no such"};
    panel->setView(view);
    ASSERT_EQ(stack().plots().size(), 4U);
    EXPECT_EQ(stack().plots()[3].width_ratio, 0.62);
    EXPECT_EQ(panel->view().plots, view.plots) << "the project keeps what is left out";
}

TEST_F(MonitorViewTest, pairsOfCursorsArePartOfTheViewTheUnnamedOneIsNot) {
    connectTo("sim:htm", 5.0);
    const auto run = [&](widgets::LivePlotStack::Command command) { stack().action(command)->trigger(); };
    run(widgets::LivePlotStack::Command::Cursors);
    EXPECT_TRUE(panel->view().cursors.empty());
    EXPECT_FALSE(panel->view().areCursorsShown);
    run(widgets::LivePlotStack::Command::NewPair);
    stack().setCursor(0, 1.25);
    const MonitorView kept = panel->view();
    ASSERT_EQ(kept.cursors.size(), 2U);
    EXPECT_EQ(kept.cursors[1].name, "2");
    EXPECT_DOUBLE_EQ(kept.cursors[1].a_s, 1.25);
    EXPECT_TRUE(kept.cursors[1].isMeasuring);
    EXPECT_TRUE(kept.areCursorsShown);
    panel->setView(MonitorView());
    EXPECT_EQ(stack().cursorPairs().list().size(), 1U);
    panel->setView(kept);
    EXPECT_EQ(panel->view(), kept);
    EXPECT_TRUE(stack().cursors().isVisible);
}

TEST_F(MonitorViewTest, aViewWithoutPlotsIsTheDevicesOwn) {
    MonitorView view;
    view.plots = {{{"hall.a"}, {}, {}}};
    panel->setView(view);
    connectTo("sim:htm", 5.0);
    ASSERT_EQ(stack().plots().size(), 1U);
    panel->setView({});
    EXPECT_EQ(stack().plots().size(), 3U) << "angle, speed, current";
}

} // namespace
} // namespace halbench::app
