#include "app/workbench/drive_control.h"
#include "app/workspaces/monitor/trigger_bar.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/quantity_edit.h"

#include <QAction>
#include <QComboBox>
#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>

namespace halbench::app {
namespace {

/// The trigger of the Monitor through its widgets; the simulated motor's true angle drifts with the noise, so
/// that the events come from commands.
class MonitorTriggerTest : public MonitorTest {
protected:
    TriggerBar& bar() { return *panel->findChild<TriggerBar*>(); }
    widgets::ElidedLabel& stateLabel() { return *find<widgets::ElidedLabel>(*panel, "State of the trigger"); }
    /// The whole sentence, for who asks.
    QString state() { return stateLabel().accessibleDescription(); }
    void choose(const QString& box, const QString& text) {
        auto* found = find<QComboBox>(*panel, box);
        ASSERT_GE(found->findText(text), 0) << text.toStdString();
        found->setCurrentIndex(found->findText(text));
        Q_EMIT found->activated(found->currentIndex());
    }
    void enter(const QString& field, const QString& text) {
        auto* found = find<widgets::QuantityEdit>(*panel, field);
        type(found, text);
        QTest::keyClick(found, Qt::Key_Return);
    }
    /// Armed: an edge that comes before the part before the trigger is there is none.
    void waitForPartBefore() {
        ASSERT_TRUE(wait([&] { return bench().history().range().has_value(); }));
        const TriggerChoice choice = bar().choice();
        const double armed_s = bench().history().range()->end_s + choice.preTrigger_ratio * choice.window_s;
        ASSERT_TRUE(wait([&] { return bench().history().range()->end_s > armed_s; }));
    }
    /// Current into the coils, by which the set-point changes.
    void command(double current_A) {
        DriveControl& drive = bench().drive();
        if (!drive.isArmed()) {
            drive.setMode(devices::BoardMode::Current);
            ASSERT_TRUE(wait([&] { return drive.canArm(); }));
            drive.arm();
        }
        ASSERT_TRUE(wait([&] { return drive.canMove(); }));
        drive.setSetpoint(current_A, 0.0); // a step
    }
};

TEST_F(MonitorTriggerTest, theKeyShowsItsSettingsAndItWaitsInWords) {
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(bar().isVisible());
    press(Qt::Key_T);
    ASSERT_TRUE(bar().isVisible());
    choose("Mode", "Normal");
    choose("Source", "Speed");
    enter("Level", "10");
    const QString waiting = QString::fromUtf8("Waiting until Speed rises through 10.0\u00a0r/min");
    EXPECT_TRUE(wait([&] { return state() == waiting; }))
        << state().toStdString(); // samples are on their way
    ASSERT_TRUE(stack().level());
    EXPECT_NEAR(stack().level()->level, 10.0 * 2.0 * M_PI / 60.0, 1e-12); // r/min to rad/s
    EXPECT_TRUE(stack().isFollowing());                                   // nothing to show yet
    press(Qt::Key_T);
    EXPECT_FALSE(bar().isVisible());
    EXPECT_FALSE(stack().level());
}

TEST_F(MonitorTriggerTest, isOneLineInWhichTheStateIsWholeUntilMoreIsAskedFor) {
    connectTo("sim:htm", 5.0);
    panel->resize(700, 560); // what 1440 x 900 leaves for it
    press(Qt::Key_T);
    choose("Mode", "Single");
    waitForPartBefore();
    EXPECT_EQ(stateLabel().text(), "Waiting");
    EXPECT_LT(bar().height(), 2 * find<QComboBox>(*panel, "Mode")->height());
    command(0.5);
    ASSERT_TRUE(wait([&] { return stateLabel().words().startsWith("Stopped at"); }));
    EXPECT_EQ(stateLabel().text(), stateLabel().words()); // nothing is left out
    auto* window = find<widgets::QuantityEdit>(*panel, "Window");
    EXPECT_FALSE(window->isVisible());
    find<QPushButton>(*panel, "More settings of the trigger")->click();
    EXPECT_TRUE(window->isVisible());
}

TEST_F(MonitorTriggerTest, aSetPointChangeStandsInTheViewUntilTheNextAndEndFollowsAgain) {
    connectTo("sim:htm", 5.0);
    press(Qt::Key_T);
    choose("Mode", "Single");
    enter("Window", "0.4");
    enter("Pre-trigger", "25");
    waitForPartBefore();
    command(0.5);
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after the event"); })) << state().toStdString();
    EXPECT_FALSE(stack().isFollowing());
    const control::TimeRange view = stack().timeRange();
    EXPECT_NEAR(view.length_s(), 0.4, 1e-9);
    // The command is the first change in the window, a quarter of it from its begin.
    const double event_s = view.begin_s + 0.1;
    EXPECT_EQ(bench().history().valueAt("current_command", event_s - 0.01)->value, 0.0);
    EXPECT_NE(bench().history().valueAt("current_command", event_s + 0.01)->value, 0.0);
    command(0.0);
    QTest::qWait(300);
    EXPECT_EQ(stack().timeRange(), view); // stopped
    press(Qt::Key_T, Qt::ShiftModifier);
    EXPECT_FALSE(state().startsWith("Stopped"));
    press(Qt::Key_End);
    EXPECT_TRUE(stack().isFollowing());
    EXPECT_FALSE(bar().isVisible());
}

TEST_F(MonitorTriggerTest, whereTheUserLooksInTheWindowHeLooksAtTheNextEventToo) {
    connectTo("sim:htm", 5.0);
    press(Qt::Key_T); // auto: goes on by itself
    choose("Source", "Speed");
    enter("Level", "9000");
    enter("Window", "0.2");
    ASSERT_TRUE(wait([&] { return state().startsWith("Auto: no event"); }));
    ASSERT_FALSE(stack().isFollowing());
    stack().action(widgets::LivePlotStack::Command::ZoomIn)->trigger();
    const double length_s = stack().timeRange().length_s();
    EXPECT_LT(length_s, 0.15);
    const double begin_s = stack().timeRange().begin_s;
    ASSERT_TRUE(wait([&] { return stack().timeRange().begin_s > begin_s; }));
    EXPECT_NEAR(stack().timeRange().length_s(), length_s, 1e-9);
}

TEST_F(MonitorTriggerTest, theLevelIsDraggedInThePlotAndPutIntoTheMiddle) {
    connectTo("sim:htm", 5.0);
    press(Qt::Key_T);
    choose("Mode", "Normal");
    choose("Source", "Hall A");
    const auto inView = [&] { return bench().history().extremes("hall.a", stack().timeRange()); };
    ASSERT_TRUE(wait([&] { return inView().min <= inView().max; })); // the picture follows the data
    click(*panel, "Set level to 50 %");
    const double middle = stack().level()->level;
    const control::Extremes extremes = inView();
    EXPECT_GE(middle, extremes.min);
    EXPECT_LE(middle, extremes.max);
    const auto plots = panel->findChildren<widgets::LivePlot*>();
    const auto found = std::find_if(plots.begin(), plots.end(), [](const widgets::LivePlot* one) {
        return one->spec().curves.front().signal == "hall.a";
    });
    ASSERT_NE(found, plots.end());
    widgets::LivePlot* plot = *found;
    QTest::qWait(100);
    const int y = static_cast<int>(plot->transform(QwtPlot::yLeft, 1000.0 * middle)); // mT
    const QPoint from(plot->canvas()->width() / 2, y);
    QTest::mousePress(plot->canvas(), Qt::LeftButton, Qt::NoModifier, from);
    QMouseEvent move(QEvent::MouseMove, from + QPoint(0, -15), Qt::LeftButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(plot->canvas(), &move);
    QTest::mouseRelease(plot->canvas(), Qt::LeftButton, Qt::NoModifier, from + QPoint(0, -15));
    EXPECT_GT(stack().level()->level, middle) << y << " of " << plot->canvas()->height();
    EXPECT_EQ(bar().choice().level, stack().level()->level);
}

TEST_F(MonitorTriggerTest, isKeptWithTheViewAndLeavesFollowingAlone) {
    MonitorView view;
    view.plots = {{{"speed"}, {}, {}}};
    view.span_s = 10.0;
    view.trigger = {
        true, "speed", control::TriggerMode::Auto, control::TriggerSlope::Falling, 900.0, 1.0, 0.2, 0.1, 0.3};
    panel->setView(view);
    EXPECT_EQ(panel->view(), view);
    connectTo("sim:htm", 5.0);
    EXPECT_TRUE(bar().isVisible());
    ASSERT_TRUE(wait([&] { return state().startsWith("Auto: no event"); }));
    EXPECT_EQ(panel->view().trigger, view.trigger);
    EXPECT_TRUE(panel->view().isFollowing);
}

TEST_F(MonitorTriggerTest, aSourceThatTheDeviceDoesNotHaveIsSaid) {
    MonitorView view;
    view.trigger.isOn = true;
    view.trigger.source = "hall.north";
    panel->setView(view);
    connectTo("sim:htm", 5.0);
    EXPECT_TRUE(wait([&] { return state() == "No samples of hall.north"; })) << state().toStdString();
}

} // namespace
} // namespace halbench::app
