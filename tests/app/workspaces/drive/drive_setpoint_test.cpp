#include "tests/app/workspaces/drive/drive_panel_fixture.h"

namespace halbench::app {
namespace {

TEST_F(DrivePanelTest, aTextThatIsNoSetpointSendsNothing) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "90");
    QTest::keyClick(field, Qt::Key_Tab); // not sent, but the field's last number
    for (const char* text : {"400000", "1e", ""}) {
        type(field, text);
        if (*text == '\0') {
            QTest::keyClick(field, Qt::Key_Backspace);
        }
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_EQ(parameter("hb.setpoint"), 0.0) << text;
        EXPECT_TRUE(message().contains("not a valid set-point")) << message().toStdString();
    }
    type(field, "400000");
    QTest::keyClick(field, Qt::Key_Tab);
    EXPECT_EQ(field->value(), 0.0); // what holds now
    click(*panel, "Go");
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
}

TEST_F(DrivePanelTest, goWithATextThatIsNoSetpointSaysSoAndSendsNothing) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    auto* go = find<QPushButton>(*panel, "Go");
    for (const char* text : {"3,5", "abc", "99999"}) {
        type(field, text);
        // As a mouse does it: the focus goes to the button, then the button is pressed.
        go->setFocus(Qt::MouseFocusReason);
        QTest::mouseClick(go, Qt::LeftButton);
        EXPECT_TRUE(message().contains("not a valid set-point")) << text << ": " << message().toStdString();
        EXPECT_TRUE(message().contains(text)) << message().toStdString();
        EXPECT_EQ(parameter("hb.setpoint"), 0.0) << text;
        QTest::qWait(0);
    }
    type(field, "5");
    go->setFocus(Qt::MouseFocusReason);
    QTest::mouseClick(go, Qt::LeftButton);
    EXPECT_GT(parameter("hb.setpoint"), 0.0);
}

TEST_F(DrivePanelTest, whatWasRefusedIsNotSaidAnyMoreOnceAGoodNumberStandsThere) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* amplitude = find<QDoubleSpinBox>(*panel, "Amplitude");
    auto* setpoint = find<QDoubleSpinBox>(*panel, "Set-point");
    for (auto* field : {amplitude, setpoint}) {
        type(field, "x");
        QTest::keyClick(field, Qt::Key_Tab);
        ASSERT_TRUE(message().contains("x")) << message().toStdString();
        type(field, "12");
        QTest::keyClick(field, Qt::Key_Tab);
        EXPECT_TRUE(message().isEmpty()) << message().toStdString();
    }
    // A stop that comes and goes brings nothing old back.
    type(amplitude, "x");
    QTest::keyClick(amplitude, Qt::Key_Tab);
    type(amplitude, "20");
    QTest::keyClick(amplitude, Qt::Key_Tab);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return bench().stopLatch().isLatched(); }));
    ASSERT_TRUE(wait([&] { return bench().drive().canRelease(); }));
    bench().drive().releaseStop();
    ASSERT_TRUE(wait([&] { return !bench().stopLatch().isLatched(); }));
    QTest::qWait(0);
    EXPECT_FALSE(message().contains("is not valid")) << message().toStdString();
}

TEST_F(DrivePanelTest, aSetpointFarAwayIsAnEvenRampAndZeroComesBackAsOne) {
    connectTo("sim:htm", 5.0);
    armByClick();
    ASSERT_TRUE(wait([&] { return hasReference(); }));
    const double before = latest("reference");
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    const auto* zero = find<QPushButton>(*panel, "Zero");
    const DriveControl& drive = bench().drive();
    const auto isThere = [&] { return !drive.isRunning() && drive.setpoint() == drive.goal(); };
    for (const double to_deg : {90.0, 0.0}) {
        const double begin_s = bench().history().latest("reference")->time_s;
        if (to_deg == 0.0) {
            EXPECT_TRUE(zero->toolTip().contains("back by 90.00")) << zero->toolTip().toStdString();
            click(*panel, "Zero");
        } else {
            type(field, QString::number(to_deg));
            QTest::keyClick(field, Qt::Key_Return);
        }
        ASSERT_TRUE(wait([&] { return drive.isRunning(); }));
        ASSERT_TRUE(wait(isThere));
        EXPECT_NEAR(drive.setpoint(), degreesToRadians(to_deg), 1e-9); // what was asked for
        EXPECT_EQ(parameter("hb.setpoint"), 0.0);                      // the board's has not leapt
        QTest::qWait(100);
        EXPECT_NEAR(latest("reference"), before + degreesToRadians(to_deg), 1e-5); // floats of some radians
        std::vector<control::TimedValue> reference;
        bench().history().samples("reference", {begin_s, latestTime_s()}, reference);
        for (std::size_t i = 1; i < reference.size(); ++i) {
            const double way_s =
                std::max(reference[i].time_s - reference[i - 1].time_s, 0.010); // of the loop
            EXPECT_LT(std::abs(reference[i].value - reference[i - 1].value),
                      degreesToRadians(45.0) * (way_s + 0.010) + 1e-5);
        }
    }
    type(field, "12"); // near: a step
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(parameter("hb.setpoint"), degreesToRadians(12.0), 1e-6);
}

TEST_F(DrivePanelTest, anotherSetpointOnTheWayBeginsWhereTheRampIs) {
    connectTo("sim:htm", 1.0);
    armByClick();
    ASSERT_TRUE(wait([&] { return hasReference(); }));
    const double before = latest("reference");
    const DriveControl& drive = bench().drive();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "300");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return drive.setpoint() > degreesToRadians(20.0); }));
    click(*panel, "Zero");
    EXPECT_EQ(drive.goal(), 0.0);
    ASSERT_TRUE(wait([&] { return !drive.isRunning() && drive.setpoint() == 0.0; }));
    QTest::qWait(100);
    // The origin, from which it is counted how far the ramp came, is known to a sample of the angle.
    EXPECT_NEAR(latest("reference"), before, degreesToRadians(0.5));
    type(field, "300");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return drive.setpoint() > degreesToRadians(20.0); }));
    click(*panel, "End");
    ASSERT_TRUE(wait([&] { return !drive.isRunning(); }));
    QTest::qWait(100);
    EXPECT_NEAR(drive.setpoint(), latest("reference") - before, degreesToRadians(1.0));
    EXPECT_EQ(drive.goal(), drive.setpoint()); // it stays there
}

TEST_F(DrivePanelTest, aLeapBesideAReferenceIsRefused) {
    connectTo("sim:htm", 1.0);
    armByClick();
    click(*panel, "Start"); // a step by 30 degrees
    ASSERT_TRUE(wait([&] { return latest("reference.running") > 0.5; }));
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "90");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(message().contains("too large")) << message().toStdString();
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
    EXPECT_GT(latest("reference.running"), 0.5);
}

} // namespace
} // namespace halbench::app
