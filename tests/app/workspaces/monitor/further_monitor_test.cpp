// A Monitor beside the first one.
#include "app/workbench/recording_trigger.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/monitor_rate.h"
#include "app/workspaces/monitor/monitor_trigger.h"
#include "app/workspaces/parts/signal_box.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"

#include <QAbstractItemView>
#include <QAction>

#include <algorithm>

namespace halbench::app {
namespace {

class FurtherMonitorTest : public MonitorTest {
protected:
    void SetUp() override {
        MonitorTest::SetUp();
        further = std::make_unique<MonitorPanel>(bench(), nullptr, MonitorPanel::Rank::Further);
        further->resize(900, 600);
        further->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(further.get()));
        further->setInUse(true);
    }
    void TearDown() override {
        further.reset();
        MonitorTest::TearDown();
    }
    widgets::LivePlotStack& second() { return *further->findChild<widgets::LivePlotStack*>(); }
    bool isStreamed(const std::string& name) {
        const auto& streamed = bench().liveSignals().streamed();
        return std::count(streamed.begin(), streamed.end(), name) == 1;
    }

    std::unique_ptr<MonitorPanel> further;
};

TEST_F(FurtherMonitorTest, hasPlotsAndATimeOfItsOwnOnTheSameSamples) {
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(second().history(), stack().history()) << "nothing is kept twice";
    ASSERT_EQ(second().plots().size(), 1U);
    EXPECT_TRUE(second().plots()[0].curves.empty()) << "the user chooses";
    Q_EMIT second().signalsDropped(0, {"truth.speed"});
    EXPECT_EQ(second().plots()[0].curves.front().signal, "truth.speed");
    EXPECT_EQ(stack().plots().size(), 5U) << "the first one is as it was";
    EXPECT_TRUE(isStreamed("truth.speed"));
    second().setTimeSpan(2.0);
    second().refresh();
    EXPECT_NEAR(second().timeRange().length_s(), 2.0, 1e-9);
    EXPECT_NEAR(stack().timeRange().length_s(), 10.0, 1e-9);
}

TEST_F(FurtherMonitorTest, aSignalIsChosenByKeyboard) {
    connectTo("sim:htm", 5.0);
    second().action(widgets::LivePlotStack::Command::AddSignals)->trigger();
    auto* box = further->findChild<SignalBox*>();
    EXPECT_TRUE(box->view()->isVisible());
    box->hidePopup();
    box->choose("truth.speed");
    Q_EMIT box->chosen();
    EXPECT_EQ(second().plots()[0].curves.front().signal, "truth.speed");
}

TEST_F(FurtherMonitorTest, asksForNothingWhileItIsClosed) {
    connectTo("sim:htm", 5.0);
    Q_EMIT second().signalsDropped(0, {"capture.time"});
    further->setInUse(false);
    EXPECT_FALSE(isStreamed("capture.time"));
    further->setInUse(true);
    EXPECT_TRUE(isStreamed("capture.time"));
}

TEST_F(FurtherMonitorTest, leavesWhatBelongsToTheFirstOneAlone) {
    EXPECT_EQ(further->findChild<MonitorTrigger*>(), nullptr);
    EXPECT_EQ(further->findChild<MonitorRate*>(), nullptr);
    MonitorView first;
    first.derived = {{"field", "sqrt(hall.a^2 + hall.b^2)", ""}};
    panel->setView(first);
    further->setView(MonitorView());
    EXPECT_EQ(bench().derivedSignals(), first.derived);
    EXPECT_EQ(further->view(), MonitorView()) << "a project keeps nothing of it";
}

TEST_F(FurtherMonitorTest, itsViewIsKeptAndShownAgain) {
    MonitorView view;
    view.plots = {{{"speed"}, {}, {}}, {{"hall.a"}, {}, {}}};
    view.plots[1].column = 1;
    view.span_s = 3.0;
    further->setView(view);
    EXPECT_EQ(further->view(), view) << "before there is a device";
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(second().columnCount(), 2);
    EXPECT_EQ(further->view(), view);
    further->setView(MonitorView());
    EXPECT_TRUE(second().plots()[0].curves.empty());
}

} // namespace
} // namespace halbench::app
