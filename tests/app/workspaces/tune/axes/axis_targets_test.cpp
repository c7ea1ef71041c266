#include "app/workspaces/tune/axes/axis_targets.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/optional_number_edit.h"

#include <QFormLayout>
#include <QSignalSpy>
#include <QtTest/QTest>

namespace halbench::app {
namespace {

class AxisTargetsTest : public widgets::GuiTest {
protected:
    AxisTargetsTest() { targets.refreshWords(); }
    widgets::OptionalNumberEdit* edit(const char* name) {
        for (auto* each : page.findChildren<widgets::OptionalNumberEdit*>()) {
            if (each->accessibleName() == QString::fromUtf8(name)) {
                return each;
            }
        }
        return nullptr;
    }
    std::vector<bool> shown() {
        std::vector<bool> all;
        for (const char* name :
             {"damping ratio", "frequency [rad/s]", "bandwidth [Hz]", "phase margin [\u00b0]"}) {
            all.push_back(!edit(name)->isHidden());
        }
        return all;
    }

    void empty(const char* name) {
        edit(name)->selectAll();
        QTest::keyClick(edit(name), Qt::Key_Delete);
    }

    QWidget page;
    QFormLayout form{&page};
    AxisTargets targets{form, &page};
};

// The targets that resources/help/tuning.md, "Loops of several axes", names for each method.
TEST_F(AxisTargetsTest, onlyTargetsThatTheMethodReadsAreShown) {
    targets.showFor("pole-placement");
    EXPECT_EQ(shown(), (std::vector{true, true, false, false}));
    targets.showFor("bandwidth");
    EXPECT_EQ(shown(), (std::vector{false, false, true, false}));
    targets.showFor("phase-margin");
    EXPECT_EQ(shown(), (std::vector{false, false, false, true}));
    targets.showFor("device"); // gains as they are: no design
    EXPECT_EQ(shown(), (std::vector{false, false, false, false}));
}

// A target that another method left behind must not reach this one, which would refuse it.
TEST_F(AxisTargetsTest, hiddenTargetsAreNotGiven) {
    control::DesignTargets set;
    set.omega_rad_s = 25.0;
    set.bandwidth_Hz = 12.0;
    targets.showFor("bandwidth");
    targets.setTargets(set);
    EXPECT_EQ(targets.targets().bandwidth_Hz, 12.0);
    EXPECT_FALSE(targets.targets().omega_rad_s);
}

TEST_F(AxisTargetsTest, typingIsAnEditSettingIsNone) {
    QSignalSpy edited(&targets, &AxisTargets::edited);
    targets.showFor("pole-placement");
    control::DesignTargets set;
    set.omega_rad_s = 25.0;
    targets.setTargets(set);
    EXPECT_EQ(edited.count(), 0);
    QTest::keyClicks(edit("damping ratio"), "0.7");
    EXPECT_GT(edited.count(), 0);
    EXPECT_EQ(targets.targets().zeta, 0.7);
    EXPECT_EQ(targets.targets().omega_rad_s, 25.0);
}

TEST_F(AxisTargetsTest, textThatIsNoPositiveNumberIsNoTarget) {
    targets.showFor("bandwidth");
    for (const char* text : {"-3", "0", "ten"}) {
        empty("bandwidth [Hz]");
        QTest::keyClicks(edit("bandwidth [Hz]"), text);
        EXPECT_FALSE(targets.targets().bandwidth_Hz) << text;
        EXPECT_FALSE(edit("bandwidth [Hz]")->isValid()) << text;
    }
    empty("bandwidth [Hz]");
    EXPECT_FALSE(targets.targets().bandwidth_Hz);
    EXPECT_TRUE(edit("bandwidth [Hz]")->isValid()); // empty: the method chooses
}

} // namespace
} // namespace halbench::app
