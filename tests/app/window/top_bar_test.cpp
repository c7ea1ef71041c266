#include "app/window/connect_button.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/record_button.h"
#include "app/workspaces/device/pace_row.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/drive/mode_box.h"
#include "tests/app/window/top_bar_fixture.h"
#include "tests/devices/transport/served_board.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/status_strip.h"
#include "widgets/controls/stop_button.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

TEST_F(TopBarTest, connectsAndDisconnectsByButtonKeyAndMenu) {
    open();
    auto* button = inBar<ConnectButton>();
    EXPECT_EQ(button->text(), "Connect");
    QTest::mouseClick(button, Qt::LeftButton, Qt::NoModifier, QPoint(6, button->height() / 2));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_EQ(button->text(), "Disconnect");
    key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    Q_EMIT button->menu()->aboutToShow(); // what opening it does; a menu is modal
    ASSERT_FALSE(button->menu()->actions().isEmpty());
    button->menu()->actions().first()->trigger();
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
}

TEST_F(TopBarTest, theFocusDoesNotStayOnWhatDisconnectsAfterConnecting) {
    open();
    QApplication::setActiveWindow(window.get());
    auto* devices = window->docks().panel("devices");
    const auto isHarmless = [&] {
        const QWidget* focus = window->focusWidget();
        return focus != nullptr && qobject_cast<const QAbstractButton*>(focus) == nullptr &&
               !devices->isAncestorOf(focus);
    };
    const auto leave = [&] {
        session().disconnectDevice();
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    };
    auto* button = inBar<ConnectButton>();
    QTest::mouseClick(button, Qt::LeftButton, Qt::NoModifier, QPoint(6, button->height() / 2));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_TRUE(isHarmless());
    leave();
    window->docks().raise("devices"); // the plots with what was measured are in front
    for (auto* address : devices->findChildren<QLineEdit*>()) {
        if (address->isVisible() && address->text().startsWith("sim:")) {
            address->setFocus();
            QTest::keyClick(address, Qt::Key_Return);
        }
    }
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_TRUE(isHarmless());
    QTest::keyClick(window->focusWidget(), Qt::Key_Space);
    EXPECT_EQ(session().state(), SessionState::Connected);
}

TEST_F(TopBarTest, armsAndChoosesTheModeInEveryPerspective) {
    open();
    connectMotor(1.0);
    window->docks().setPerspective(Perspective::Field); // without the Drive panel
    key(Qt::Key_M, Qt::ControlModifier);
    auto* mode = inBar<ModeBox>();
    EXPECT_EQ(window->focusWidget(), mode);
    QTest::keyClick(mode, Qt::Key_Up); // current
    ASSERT_TRUE(wait([&] { return window->bench().drive().mode() == devices::BoardMode::Current; }));
    key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    auto* arm = inBar<ArmButton>();
    EXPECT_EQ(arm->text(), "Disarm");
    ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
    QTest::mouseClick(arm, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return !isArmed(); }));
    // The Drive panel says the same.
    EXPECT_EQ(static_cast<DrivePanel*>(window->docks().panel("drive"))->findChild<ModeBox*>()->currentIndex(),
              mode->currentIndex());
}

TEST_F(TopBarTest, aRealDeviceIsArmedOnlyAfterTheWarning) {
    devices::BoardServer board;
    open();
    window->connectDevice(QString::fromStdString(board.uri()));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    auto* arm = inBar<ArmButton>();
    ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
    QTest::mouseClick(arm, Qt::LeftButton);
    auto* message = window->findChild<widgets::MessageBar*>("window_message");
    ASSERT_TRUE(message->isVisible());
    EXPECT_EQ(message->message().text, armingWarning().text);
    EXPECT_FALSE(isArmed());
    QPushButton* armIt = message->findChild<QPushButton*>();
    ASSERT_TRUE(armIt->isVisible());
    armIt->setFocus(); // as a click does
    QTest::mouseClick(armIt, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return isArmed(); }));
    // Not on Disconnect, the next in the chain.
    EXPECT_EQ(qobject_cast<QAbstractButton*>(window->focusWidget()), nullptr);
}

TEST_F(TopBarTest, oneAnswerEndsTheQuestionInTheWindowAndInTheDrivePanel) {
    devices::BoardServer board;
    open();
    window->connectDevice(QString::fromStdString(board.uri()));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    auto* drive = window->docks().panel("drive");
    auto* inPanel = drive->findChild<widgets::MessageBar*>();
    auto* inWindow = window->findChild<widgets::MessageBar*>("window_message");
    const auto ask = [&] {
        QTest::mouseClick(inBar<ArmButton>(), Qt::LeftButton);
        QTest::mouseClick(drive->findChild<ArmButton*>(), Qt::LeftButton);
        ASSERT_EQ(inPanel->message().text, armingWarning().text);
        ASSERT_EQ(inWindow->message().text, armingWarning().text);
    };
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    ask();
    inWindow->findChild<QToolButton*>()->click(); // dismissed
    EXPECT_TRUE(inPanel->message().text.isEmpty());
    ask();
    inPanel->findChild<QToolButton*>()->click();
    EXPECT_TRUE(inWindow->message().text.isEmpty());
    ask();
    Q_EMIT inPanel->actionTriggered();
    EXPECT_TRUE(inWindow->message().text.isEmpty() && inPanel->message().text.isEmpty());
    EXPECT_TRUE(wait([&] { return isArmed(); }));
}

TEST_F(TopBarTest, aKeyThatIsHeldArmsOrDisarmsOnce) {
    open();
    QApplication::setActiveWindow(window.get());
    connectMotor(1.0);
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    const auto hold = [&] {
        for (int i = 0; i < 8; ++i) {
            QTest::simulateEvent(static_cast<QWidget*>(window.get()), true, Qt::Key_A,
                                 Qt::ControlModifier | Qt::ShiftModifier, {}, i > 0);
            QTest::qWait(50); // the board has answered in between
        }
    };
    hold();
    EXPECT_TRUE(isArmed());
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    hold();
    EXPECT_FALSE(isArmed());
}

TEST_F(TopBarTest, theStateSaysWhatRuns) {
    open();
    connectMotor(1.0);
    auto* drive = window->docks().panel("drive");
    const auto button = [&](const char* text) -> QPushButton* {
        for (auto* one : drive->findChildren<QPushButton*>()) {
            if (one->text() == text) {
                return one;
            }
        }
        return nullptr;
    };
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    QTest::mouseClick(inBar<ArmButton>(), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return button("Start")->isEnabled(); }));
    auto* strip = window->findChild<widgets::StatusStrip*>();
    EXPECT_EQ(strip->stateText(), "Armed");
    EXPECT_FALSE(button("End")->isEnabled()); // of nothing
    for (auto* box : drive->findChildren<QComboBox*>()) {
        if (box->accessibleName() == "Shape of the reference") {
            box->setCurrentIndex(2);
        }
    }
    button("Start")->click();
    ASSERT_TRUE(wait([&] { return button("End")->isEnabled(); }));
    EXPECT_EQ(strip->stateText(), "Armed: sine, position mode");
    button("End")->click();
    EXPECT_TRUE(wait([&] { return !button("End")->isEnabled(); }));
    EXPECT_EQ(strip->stateText(), "Armed");
}

// Three rows: it is over before anything can be asked of it.
TEST_F(TopBarTest, aRecordingThatWasPlayedToItsEndIsNoLostConnection) {
    open();
    const QTemporaryDir folder;
    QFile file(folder.filePath("short.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time_s,position_rad\n0,0.1\n0.001,0.2\n0.002,0.3\n");
    file.close();
    QStringList errors;
    QObject::connect(&session(), &DeviceSession::message, &session(),
                     [&](MessageLevel level, const QString&, const QString& text) {
                         errors += level == MessageLevel::Error ? QStringList(text) : QStringList();
                     });
    session().connectDevice("replay:" + file.fileName(), {1.0});
    ASSERT_TRUE(wait([&] { return session().isPlayedToTheEnd(); }));
    EXPECT_TRUE(errors.isEmpty()) << errors.join('\n').toStdString();
    const auto* strip = inBar<widgets::StatusStrip>();
    EXPECT_NE(strip->state(), widgets::WorkState::Fault) << strip->stateText().toStdString();
}

TEST_F(TopBarTest, aPerspectivesButtonTakesTheFocusIntoItsMainPanel) {
    open();
    QApplication::setActiveWindow(window.get());
    connectMotor(1.0);
    const std::pair<const char*, const char*> pages[] = {
        {"Identify", "identification.md"}, {"Tune", "tuning.md"}, {"Monitor", "monitor.md"}};
    for (const auto& [title, page] : pages) {
        QTest::mouseClick(perspective(title), Qt::LeftButton);
        EXPECT_EQ(helpWords(), pageWords(page)) << title;
    }
    key(Qt::Key_2, Qt::ControlModifier);
    EXPECT_EQ(helpWords(), pageWords("identification.md"));
}

TEST_F(TopBarTest, theFocusGoesWithATabAndNotToWhatDisconnects) {
    open();
    QApplication::setActiveWindow(window.get());
    connectMotor(1.0);
    QTest::mouseClick(perspective("Identify"), Qt::LeftButton);
    auto* identify = window->docks().panel("identify");
    ASSERT_TRUE(wait([&] { return identify->isAncestorOf(QApplication::focusWidget()); }));
    auto* calibrate = window->docks().panel("calibrate");
    for (ads::CDockWidget* dock : window->docks().docks()) {
        if (dock->objectName() == "calibrate") {
            dock->setAsCurrentTab();
        }
    }
    EXPECT_TRUE(wait([&] { return calibrate->isAncestorOf(QApplication::focusWidget()); }));
}

TEST_F(TopBarTest, recordingAndThePerspectiveOfRecordingsHaveNamesOfTheirOwn) {
    open();
    EXPECT_EQ(inBar<RecordButton>()->accessibleName(), "Record data");
    EXPECT_EQ(perspective("Record")->accessibleName(), "Perspective Record");
}

TEST_F(TopBarTest, theKeyAndTheClickThatRecordLeaveTheFocusWhereItWas) {
    const QTemporaryDir folder;
    open();
    QApplication::setActiveWindow(window.get());
    connectMotor(1.0);
    RecordingControl& recording = window->bench().recording();
    recording.setFolder(folder.path());
    key(Qt::Key_1, Qt::ControlModifier);
    QWidget* const worked = QApplication::focusWidget();
    ASSERT_TRUE(worked != nullptr && window->docks().panel("monitor")->isAncestorOf(worked));
    for (const bool isByKey : {true, false}) {
        for (const bool isStart : {true, false}) {
            if (isByKey) {
                key(Qt::Key_R, Qt::ControlModifier);
            } else {
                QTest::mouseClick(inBar<RecordButton>(), Qt::LeftButton);
            }
            ASSERT_TRUE(wait([&] { return recording.isRecording() == isStart; }));
            EXPECT_EQ(QApplication::focusWidget(), worked) << isByKey << isStart;
        }
    }
}

TEST_F(TopBarTest, aStopThatStoppedNothingSaysSo) {
    open();
    connectMotor(1.0);
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); }));
    QTest::mouseClick(window->findChild<widgets::StopButton*>(), Qt::LeftButton); // Esc would do nothing
    auto* strip = window->findChild<widgets::StatusStrip*>();
    ASSERT_TRUE(wait([&] { return strip->state() == widgets::WorkState::Stopped; }));
    EXPECT_EQ(strip->stateText(), "Stopped (device was disarmed)");
    ASSERT_TRUE(wait([&] { return window->bench().drive().canRelease(); }));
    window->bench().drive().releaseStop();
    ASSERT_TRUE(wait([&] { return strip->state() == widgets::WorkState::Connected; }));
    ASSERT_TRUE(wait([&] { return inBar<ArmButton>()->isEnabled(); })); // not right after a release
    key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    key(Qt::Key_Escape, Qt::NoModifier);
    ASSERT_TRUE(wait([&] { return strip->state() == widgets::WorkState::Stopped; }));
    EXPECT_EQ(strip->stateText(), "Stopped (by Esc)");
}

TEST_F(TopBarTest, twoClicksInOnePlaceReleaseAndDoNotArm) {
    open();
    QApplication::setActiveWindow(window.get());
    for (const int width_px : {window->minimumSizeHint().width(), 1440, 1700}) {
        window->resize(width_px, 900);
        if (session().state() != SessionState::Connected) {
            connectMotor(1.0);
        }
        auto* arm = inBar<ArmButton>();
        ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
        QTest::mouseClick(arm, Qt::LeftButton); // the focus is on it now
        ASSERT_TRUE(wait([&] { return isArmed() && arm->isEnabled(); }));
        key(Qt::Key_Escape, Qt::NoModifier);
        ASSERT_TRUE(wait([&] { return window->bench().drive().canRelease(); }));
        settle(); // laid out
        QPushButton* release = nullptr;
        for (auto* one : window->findChild<TopBar*>()->findChildren<QPushButton*>()) {
            release = one->text() == "Release" ? one : release;
        }
        ASSERT_TRUE(release != nullptr && release->isVisible());
        const QRect was = arm->geometry();
        const QPoint ends[] = {release->rect().topLeft(), release->rect().center(),
                               release->rect().bottomRight()};
        QTest::mouseClick(release, Qt::LeftButton);
        ASSERT_TRUE(wait([&] { return !window->bench().drive().isStopped(); }));
        settle();
        EXPECT_EQ(arm->geometry(), was) << width_px;
        for (const QPoint& end : ends) {
            const QWidget* under = window->childAt(release->mapTo(window.get(), end));
            EXPECT_EQ(qobject_cast<const QAbstractButton*>(under), nullptr) << width_px;
        }
        EXPECT_NE(window->focusWidget(), arm);
        // Also aimed at, and by the keys: right after a release nothing arms.
        QTest::mouseClick(arm, Qt::LeftButton);
        key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClick(window->focusWidget(), Qt::Key_Space);
        QTest::qWait(100);
        EXPECT_FALSE(isArmed()) << width_px;
        ASSERT_TRUE(wait([&] { return arm->isEnabled(); }));
        EXPECT_NE(window->focusWidget(), arm);
    }
}

TEST_F(TopBarTest, theSpeedOfSimulatedTimeIsBesideTheStartOfAProcedureToo) {
    open();
    auto* beside = window->docks().panel("identify")->findChild<PaceRow*>();
    EXPECT_TRUE(beside->isHidden()); // a real device has its own time
    connectMotor(1.0);
    EXPECT_FALSE(beside->isHidden());
    auto* speeds = beside->findChild<QComboBox*>();
    speeds->setCurrentIndex(speeds->findData(20.0));
    EXPECT_EQ(session().pace().speed_ratio, 20.0);
    auto* devices = window->docks().panel("devices")->findChild<PaceRow*>()->findChild<QComboBox*>();
    EXPECT_EQ(devices->currentIndex(), speeds->currentIndex());
}

} // namespace
} // namespace halbench::app
