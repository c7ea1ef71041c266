#include "app/workspaces/drive/pose_pad.h"
#include "tests/app/workspaces/drive/drive_panel_fixture.h"

#include <QListView>

namespace halbench::app {
namespace {

/// A device with two lengths and an angle: one axis is moved, in its units, and the others hold.
class DriveAxesTest : public DrivePanelTest {
protected:
    /// Its loop settles within 1 s from a step of a millimetre (resources/help/planar-theory.md); a tenth of
    /// it is far above noise and calibration errors of the ideal device.
    static constexpr double Settled_m = 1e-4;

    void connectPlanar() {
        connectTo("sim:planar?imperfections=off", 5.0);
        ASSERT_TRUE(wait([&] { return axes()->count() == 3; }));
    }
    QComboBox* axes() { return find<QComboBox>(*panel, "Axis"); }
    void choose(const char* axis) { axes()->setCurrentIndex(axes()->findData(QString::fromLatin1(axis))); }
    void goTo(const QString& shown) {
        auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
        type(field, shown);
        QTest::keyClick(field, Qt::Key_Return);
    }
};

TEST_F(DriveAxesTest, aChoiceIsThereOnlyWhereThereAreSeveral) {
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(axes()->isVisible());
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectPlanar();
    EXPECT_TRUE(axes()->isVisible());
    // Current modes would mean none of the axes.
    const auto* modes = qobject_cast<QListView*>(find<QComboBox>(*panel, "Mode")->view());
    EXPECT_TRUE(modes->isRowHidden(1));
    EXPECT_FALSE(modes->isRowHidden(2));
}

TEST_F(DriveAxesTest, fieldsHaveTheUnitOfTheAxis) {
    connectPlanar();
    auto* setpoint = find<QDoubleSpinBox>(*panel, "Set-point");
    auto* jog = find<QDoubleSpinBox>(*panel, "Jog speed");
    auto* amplitude = find<QDoubleSpinBox>(*panel, "Amplitude");
    choose("y");
    EXPECT_TRUE(setpoint->suffix().endsWith("mm"));
    EXPECT_TRUE(jog->suffix().endsWith("mm/s"));
    EXPECT_TRUE(amplitude->suffix().endsWith("mm"));
    choose("phi");
    EXPECT_TRUE(setpoint->suffix().endsWith(QChar(0xB0)));
    EXPECT_TRUE(amplitude->suffix().endsWith(QChar(0xB0)));
}

TEST_F(DriveAxesTest, theChosenAxisMovesAndTheOthersHold) {
    connectPlanar();
    armByClick();
    choose("x");
    ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    const double x_m = *bench().drive().origin_rad();
    choose("y");
    ASSERT_TRUE(bench().drive().origin_rad()) << "every axis counts from where it was armed";
    const double y_m = *bench().drive().origin_rad();
    goTo("0.5"); // a step: below the margin of 1 mm
    EXPECT_TRUE(wait([&] { return std::abs(latest("position.y") - y_m - 0.5e-3) < Settled_m; }));
    EXPECT_NEAR(parameter("hb.setpoint.y"), 0.5e-3, 1e-9);
    EXPECT_EQ(parameter("hb.setpoint.x"), 0.0);
    EXPECT_NEAR(latest("position.x"), x_m, Settled_m);
    goTo("3.5"); // a ramp of the board at the jog speed
    EXPECT_TRUE(wait([&] { return std::abs(latest("position.y") - y_m - 3.5e-3) < Settled_m; }));
    EXPECT_NEAR(latest("position.x"), x_m, Settled_m);
    // Each axis has its own set-point.
    ASSERT_TRUE(wait([&] { return bench().drive().canChooseAxis(); }));
    EXPECT_NEAR(bench().drive().goal(), 3.5e-3, 1e-9);
    choose("x");
    EXPECT_EQ(bench().drive().goal(), 0.0);
    choose("y");
    EXPECT_NEAR(bench().drive().goal(), 3.5e-3, 1e-9);
}

TEST_F(DriveAxesTest, joggingMovesTheAxisForwardAndEnds) {
    connectPlanar();
    armByClick();
    choose("x");
    ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    const double x_m = *bench().drive().origin_rad();
    bench().drive().startJog(2e-3);
    EXPECT_FALSE(axes()->isEnabled()); // it would go on unseen
    EXPECT_TRUE(wait([&] { return latest("position.x") - x_m > 0.5e-3; }));
    bench().drive().stopJog();
    EXPECT_TRUE(wait([&] { return axes()->isEnabled(); }));
}

TEST_F(DriveAxesTest, theJogPadHasARowForEachAxis) {
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(panel->findChild<PosePad*>()->isVisible());
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectPlanar();
    auto* pad = panel->findChild<PosePad*>();
    EXPECT_TRUE(wait([&] { return pad->isVisible(); }));
    EXPECT_TRUE(find<QDoubleSpinBox>(*pad, "Position x")->suffix().endsWith("mm"));
    EXPECT_FALSE(find<QAbstractButton>(*pad, "Jog y forward")->isEnabled()); // nothing is armed
}

TEST_F(DriveAxesTest, arrowKeysJogTheirAxisWhileTheyAreHeld) {
    connectPlanar();
    armByClick();
    auto* pad = panel->findChild<PosePad*>();
    ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    const double y_m = latest("position.y");
    QTest::keyPress(pad, Qt::Key_Up);
    EXPECT_TRUE(wait([&] { return latest("position.y") - y_m > 0.3e-3; }));
    EXPECT_EQ(bench().drive().axis().id, "y");
    QTest::keyRelease(pad, Qt::Key_Up);
    EXPECT_FALSE(bench().drive().isJogging());
}

TEST_F(DriveAxesTest, aPoseIsReachedOneAxisAfterTheOther) {
    connectPlanar();
    armByClick();
    auto* pad = panel->findChild<PosePad*>();
    ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    find<QDoubleSpinBox>(*pad, "Position x")->setValue(8.0);
    find<QDoubleSpinBox>(*pad, "Position y")->setValue(-8.0);
    QTest::mouseClick(find<QAbstractButton>(*pad, "Go to pose"), Qt::LeftButton);
    EXPECT_TRUE(wait([&] {
        return std::abs(latest("position.x") - 8e-3) < Settled_m &&
               std::abs(latest("position.y") + 8e-3) < Settled_m && std::abs(latest("position.phi")) < 1e-3;
    }));
}

TEST_F(DriveAxesTest, homingCountsTheCellsFromHere) {
    connectPlanar();
    auto* home = find<QAbstractButton>(*panel->findChild<PosePad*>(), "Home");
    ASSERT_TRUE(wait([&] { return home->isEnabled(); }));
    bench().liveSignals().want(panel.get(), {"homed", "position.x", "position.y", "position.phi"});
    QTest::mouseClick(home, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return latest("homed") == 1.0; }));
}

} // namespace
} // namespace halbench::app
