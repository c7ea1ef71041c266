#include "app/workbench/drive_control.h"
#include "tests/app/window/docks/keyboard_test.h"

#include <QAbstractSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

#include <cmath>

namespace halbench::app {
namespace {

/// Each actuator from its connection to its result without a mouse; the motor's day is in workday_test.cpp.
class KeyboardTourTest : public KeyboardTest {
protected:
    void record(const QTemporaryDir& folder) {
        window->bench().recording().setFolder(folder.path());
        press(Qt::Key_R, Qt::ControlModifier);
        ASSERT_TRUE(wait([&] { return window->bench().recording().isRecording(); }));
        press(Qt::Key_R, Qt::ControlModifier);
        ASSERT_TRUE(wait([&] { return !window->bench().recording().isRecording(); }));
    }
    double latest(const char* signal) {
        const auto value = window->bench().history().latest(signal);
        return value ? value->value : HUGE_VAL;
    }
};

TEST_F(KeyboardTourTest, platenIsIdentifiedTunedMovedAndStopped) {
    connectByKeys("sim:planar");
    goTo(Perspective::Identify, Qt::Key_2);
    pressButton("Start identification");
    ASSERT_TRUE(wait([&] { return focusedText() == "Tune with this model"; })) << shownTexts();
    press(Qt::Key_Space);
    ASSERT_TRUE(wait([&] { return window->docks().perspective() == Perspective::Tune; }));
    pressButton("Apply and verify");
    pressButton("Restore");
    ASSERT_TRUE(wait([&] { return window->bench().drive().canArm(); }));
    session().setPace({1.0});
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    press(Qt::Key_F7); // Drive
    QAbstractSpinBox* x = nullptr;
    ASSERT_TRUE(wait([&] { return canPress("Go to pose"); }));
    ASSERT_TRUE(tabUntil([&](QWidget* focused) {
        x = qobject_cast<QAbstractSpinBox*>(focused);
        return x != nullptr && x->accessibleName() == "Position x";
    }));
    press(Qt::Key_A, Qt::ControlModifier);
    press(Qt::Key_2); // mm
    pressButton("Go to pose");
    EXPECT_TRUE(wait([&] { return std::abs(latest("position.x") - 0.002) < 2e-5; })) << latest("position.x");
    press(Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(KeyboardTourTest, sphericalMotorIsWatchedComparedAndRecorded) {
    const QTemporaryDir folder;
    connectByKeys("sim:spherical");
    ASSERT_TRUE(wait([&] { return window->bench().history().latest("chi_square").has_value(); }));
    record(folder);
    press(Qt::Key_Escape); // nothing is armed: it stops nothing
    EXPECT_FALSE(session().report().board.isStopLatched);
    goTo(Perspective::Field, Qt::Key_5);
    press(Qt::Key_PageDown, Qt::ControlModifier);
    pressButton("Recommended"); // Coverage
    EXPECT_TRUE(wait([&] { return canPress("Board's placement"); }));
    press(Qt::Key_PageDown, Qt::ControlModifier);
    pressButton("Compare estimators");
    const auto tables = window->docks().panel("estimators")->findChildren<QTableWidget*>();
    ASSERT_FALSE(tables.isEmpty());
    EXPECT_TRUE(wait([&] { return tables.front()->rowCount() == 7; })); // one for each estimator
}

} // namespace
} // namespace halbench::app
