#include "tests/app/workspaces/drive/drive_panel_fixture.h"
#include "widgets/controls/elided_label.h"

namespace halbench::app {
namespace {

class DriveArmingTest : public DrivePanelTest {};

TEST_F(DriveArmingTest, aDoubleClickOnDisarmDoesNotArmAgain) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* button = find<QPushButton>(*panel, "Disarm");
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return !isArmed() && button->isEnabled(); }));
    // The second half of a double click comes when the board is disarmed already.
    QTest::mouseDClick(button, Qt::LeftButton);
    QTest::mouseRelease(button, Qt::LeftButton);
    QTest::qWait(100);
    EXPECT_EQ(parameter("hb.arm"), 0.0);
}

TEST_F(DriveArmingTest, aWheelThatPassesChangesNoMode) {
    connectTo("sim:htm", 5.0);
    auto* box = find<QComboBox>(*panel, "Mode");
    const QPointF middle = box->rect().center();
    QWheelEvent turn(middle, box->mapToGlobal(middle.toPoint()), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(box, &turn);
    EXPECT_EQ(mode(), 2);
}

TEST_F(DriveArmingTest, toArmWhatIsArmedMovesNoSetpoint) {
    connectTo("sim:htm", 5.0);
    armByClick();
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "12");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return parameter("hb.setpoint") != 0.0; }));
    bench().drive().arm(); // a question that stood somewhere else
    EXPECT_NEAR(parameter("hb.setpoint"), degreesToRadians(12.0), 1e-6);
}

TEST_F(DriveArmingTest, armingForgetsWhatWasTypedBefore) {
    connectTo("sim:htm", 5.0);
    auto* field = find<QDoubleSpinBox>(*panel, "Set-point");
    type(field, "90");
    QTest::keyClick(field, Qt::Key_Tab);
    ASSERT_EQ(field->value(), 90.0);
    armByClick();
    EXPECT_EQ(field->value(), 0.0);
    click(*panel, "Go");
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
}

TEST_F(DriveArmingTest, aModeThatIsChosenWhileAnArmIsOnItsWayIsWritten) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    click(*panel, "Arm");
    chooseMode(1);
    EXPECT_FALSE(find<QPushButton>(*panel, "Forward +")->isEnabled()); // nothing is known of the mode yet
    ASSERT_TRUE(wait([&] { return isArmed() && find<QPushButton>(*panel, "Go")->isEnabled(); }));
    EXPECT_EQ(parameter("hb.mode"), 1.0);
    EXPECT_EQ(mode(), 1);
}

TEST_F(DriveArmingTest, aStopIsLatchedSaidInWordsAndReleasedOnPurpose) {
    connectTo("sim:htm", 5.0);
    armByClick();
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return message().startsWith("Stopped"); }));
    EXPECT_FALSE(find<QPushButton>(*panel, "Arm")->isEnabled());
    EXPECT_TRUE(bench().stopLatch().isLocked());
    const auto isOffered = [&] {
        const auto buttons = panel->findChildren<QPushButton*>();
        return std::any_of(buttons.begin(), buttons.end(), [](const QPushButton* each) {
            return each->isVisible() && each->text() == "Release";
        });
    };
    EXPECT_FALSE(isOffered()); // the lock-out of the STOP control holds here too
    ASSERT_TRUE(wait(isOffered));
    EXPECT_FALSE(bench().stopLatch().isLocked());
    click(*panel, "Release");
    EXPECT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    EXPECT_FALSE(isArmed()); // releasing does not arm
    EXPECT_TRUE(message().isEmpty());
}

/// A board behind TCP: nothing tells the program that it is simulated.
class ServedBoard {
public:
    ServedBoard() : m_thread([this] { serve(); }) {}
    ~ServedBoard() {
        m_signal = 2;
        m_thread.join();
    }
    QString uri() {
        const std::lock_guard lock(m_mutex);
        return QString::fromStdString(m_uri);
    }

private:
    void serve() {
        (void)devices::serveDevice(
            {"sim:htm", devices::ServedLine::Tcp, "127.0.0.1:0", {}},
            [this](const std::string& uri, bool) {
                const std::lock_guard lock(m_mutex);
                m_uri = uri;
            },
            m_signal);
    }

    std::mutex m_mutex;
    std::string m_uri;
    std::atomic<int> m_signal = 0;
    std::thread m_thread;
};

TEST_F(DriveArmingTest, aModeThatCouldNotBeWrittenIsNotShown) {
    {
        ServedBoard board;
        ASSERT_TRUE(wait([&] { return !board.uri().isEmpty(); }));
        connectTo(board.uri(), 1.0);
        ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    }
    chooseMode(1); // nobody answers any more
    ASSERT_TRUE(wait([&] { return session().state() != SessionState::Connected; }));
    EXPECT_EQ(mode(), 2);
    EXPECT_FALSE(find<QDoubleSpinBox>(*panel, "Set-point")->suffix().endsWith("A"));
    session().disconnectDevice();
}

TEST_F(DriveArmingTest, nothingMovesBeforeItIsKnownWhereTheRotorStands) {
    holdSamplesBack(true);
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    click(*panel, "Arm");
    ASSERT_TRUE(wait([&] { return isArmed() && !bench().drive().isPending(); }));
    EXPECT_FALSE(bench().drive().canMove());
    bench().drive().setSetpoint(0.1, 1.0);
    EXPECT_FALSE(find<QPushButton>(*panel, "Go")->isEnabled());
    holdSamplesBack(false);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Go")->isEnabled(); }));
    EXPECT_TRUE(bench().drive().origin_rad().has_value());
    EXPECT_EQ(parameter("hb.setpoint"), 0.0);
}

// As after a link that came back: the history goes on, but a hand may have turned the rotor meanwhile.
TEST_F(DriveArmingTest, anAngleFromBeforeTheArmingIsNoOrigin) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return bench().history().latest("position").has_value(); }));
    holdSamplesBack(true);
    const double stale_s = bench().history().latest("position")->time_s;
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    click(*panel, "Arm");
    ASSERT_TRUE(wait([&] { return isArmed() && !bench().drive().isPending(); }));
    EXPECT_FALSE(bench().drive().canMove());
    EXPECT_FALSE(bench().drive().origin_rad().has_value());
    bool isSaid = false;
    for (const auto* label : panel->findChildren<QLabel*>()) {
        isSaid = isSaid || label->text() == "Waiting for the first angle sample.";
    }
    EXPECT_TRUE(isSaid);
    holdSamplesBack(false);
    ASSERT_TRUE(wait([&] { return bench().drive().canMove(); }));
    EXPECT_GT(bench().history().latest("position")->time_s, stale_s);
    EXPECT_TRUE(bench().drive().origin_rad().has_value());
}

TEST_F(DriveArmingTest, aRealDeviceAsksOnceWithWordsAboutMotion) {
    ServedBoard board;
    ASSERT_TRUE(wait([&] { return !board.uri().isEmpty(); }));
    connectTo(board.uri(), 1.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    click(*panel, "Arm");
    EXPECT_TRUE(message().contains("can move"));
    EXPECT_EQ(parameter("hb.arm"), 0.0);
    click(*panel, "Arm it");
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    click(*panel, "Disarm");
    ASSERT_TRUE(wait([&] { return !isArmed() && find<QPushButton>(*panel, "Arm")->isEnabled(); }));
    click(*panel, "Arm");
    EXPECT_TRUE(wait([&] { return isArmed(); })); // asked once per connection
    session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
}

} // namespace
} // namespace halbench::app
