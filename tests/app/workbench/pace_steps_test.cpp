#include "app/workbench/pace_steps.h"
#include "app/workspaces/device/pace_row.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>

namespace halbench::app {
namespace {

TEST(PaceSteps, goFromAThousandTimesSlowerToAHundredTimesFaster) {
    double pace_ratio = 1.0;
    for (int i = 0; i < 20; ++i) {
        pace_ratio = slowerPace(pace_ratio);
    }
    EXPECT_EQ(pace_ratio, 0.001);
    for (int i = 0; i < 20; ++i) {
        pace_ratio = fasterPace(pace_ratio);
    }
    EXPECT_EQ(pace_ratio, 100.0);
    EXPECT_EQ(slowerPace(0.0), 100.0); // virtual time is faster than all
    EXPECT_EQ(fasterPace(0.0), 0.0);
    EXPECT_EQ(slowerPace(0.03), 0.01); // one between two steps
    EXPECT_EQ(fasterPace(0.03), 0.1);
}

TEST(PaceSteps, aSlowOneSaysHowMuchSlower) {
    EXPECT_EQ(paceWords(0.01), "100 times slower");
    EXPECT_EQ(paceWords(1.0), "real time");
    EXPECT_EQ(paceWords(20.0), "20 times");
    EXPECT_EQ(paceWords(0.0), "as fast as possible");
}

class PaceKeysTest : public MonitorTest {};

TEST_F(PaceKeysTest, lessAndGreaterStepTheSpeedAndTheChoiceFollows) {
    QApplication::setActiveWindow(panel.get());
    PaceRow row(bench(), PaceRow::Place::Devices, nullptr);
    auto* box = row.findChild<QComboBox*>();
    press(Qt::Key_Less, Qt::ShiftModifier);
    EXPECT_EQ(bench().pace().speed_ratio, 1.0) << "nothing is connected that has a pace";
    connectTo("sim:htm", 1.0);
    bench().setPace({1.0});
    QApplication::setActiveWindow(panel.get());
    press(Qt::Key_Less);
    EXPECT_EQ(bench().pace().speed_ratio, 0.5);
    EXPECT_EQ(box->currentText(), "2 times slower");
    press(Qt::Key_Greater);
    press(Qt::Key_Greater);
    EXPECT_EQ(bench().pace().speed_ratio, 2.0);
    bench().setPace({0.25}); // none of the choices
    EXPECT_EQ(box->currentText(), "4 times slower");
}

/// Time that is slower can be seen to be: so much of it takes at least so long. No upper bound, which a busy
/// machine would break.
TEST_F(PaceKeysTest, aSlowTimeTakesAsLongAsItSays) {
    connectTo("sim:htm", 0.1);
    const auto now_s = [&] { return session().report().deviceTime_s; };
    const double begin_s = now_s();
    QElapsedTimer wall;
    wall.start();
    ASSERT_TRUE(wait([&] { return now_s() - begin_s > 0.1; }));
    // What is reported is up to 0.1 s of the wall old, and one slice of 20 ms may have been due.
    EXPECT_GT(wall.elapsed(), 1000 - 100 - 200);
    EXPECT_FALSE(bench().freshness().words().contains("No new values"));
}

} // namespace
} // namespace halbench::app
