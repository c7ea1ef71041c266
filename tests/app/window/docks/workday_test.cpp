#include "app/window/docks/dock_layout.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "devices/formats/recording_file.h"
#include "tests/app/window/docks/keyboard_test.h"
#include "tests/devices/transport/served_board.h"

#include <QAbstractButton>
#include <QListWidget>
#include <QTemporaryDir>

#include <algorithm>

namespace halbench::app {
namespace {

/// The first minutes with a motor, through the real window and its keys.
class WorkdayTest : public WindowTest {
protected:
    void connectByKey() {
        open();
        QTest::keyClick(window->findChild<DevicePanel*>()->findChild<QListWidget*>(), Qt::Key_Return);
        ASSERT_TRUE(wait([&] { return !window->bench().deviceValues().empty(); }));
    }
    void key(Qt::Key code, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(window.get(), code, modifiers);
    }
    bool isArmed() { return session().report().board.isArmed; }
    double latest(const char* signal) {
        const auto value = window->bench().history().latest(signal);
        return value ? value->value : 0.0;
    }
};

TEST_F(WorkdayTest, connectsWatchesDrivesRecordsAndStops) {
    const QTemporaryDir folder;
    connectByKey();
    window->bench().recording().setFolder(folder.path());
    ASSERT_TRUE(wait([&] { return window->bench().history().latest("hall.a").has_value(); })); // watched

    key(Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return window->bench().recording().isRecording(); }));
    key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return isArmed() && latest("status") > 0.5; }));
    key(Qt::Key_F7, Qt::NoModifier); // Drive
    const auto buttons = window->docks().panel("drive")->findChildren<QAbstractButton*>();
    const auto start = std::find_if(buttons.begin(), buttons.end(),
                                    [](const QAbstractButton* button) { return button->text() == "Start"; });
    ASSERT_NE(start, buttons.end());
    ASSERT_TRUE(wait([&] { return (*start)->isEnabled(); }));
    key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(wait([&] { return latest("speed") > 1.0; })); // it moves
    key(Qt::Key_Escape, Qt::NoModifier);
    ASSERT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
    key(Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return !window->bench().recording().isRecording(); }));

    const auto file = devices::readRecordingFile(window->bench().recording().path().toStdString());
    ASSERT_TRUE(file) << file.error().message;
    const std::vector<double> speed = file->recording.column("speed");
    EXPECT_GT(*std::max_element(speed.begin(), speed.end()), 1.0); // the motion is in it
    EXPECT_EQ(file->recording.column("status").back(), 2.0);       // and the stop
}

class KeyboardDayTest : public KeyboardTest {
protected:
    void identifyTuneAndApply() {
        constexpr int Fit_ms = 120000;
        connectByKeys("sim:htm");
        goTo(Perspective::Identify, Qt::Key_2);
        tabTo("Start identification");
        press(Qt::Key_Space);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->bench().identification().has_value(); }, Fit_ms));
        ASSERT_TRUE(wait([&] { return focusedText() == "Tune with this model"; }));
        press(Qt::Key_Space);
        ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
        EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
        tabTo("Apply and verify");
        press(Qt::Key_Space);
        ASSERT_TRUE(QTest::qWaitFor([&] { return focusedText() == "Keep"; }, Fit_ms));
    }
};

TEST_F(KeyboardDayTest, identifiesTunesAppliesRestoresAndStops) {
    identifyTuneAndApply();
    tabTo("Restore");
    auto* restore = QApplication::focusWidget();
    press(Qt::Key_Space);
    ASSERT_TRUE(wait([&] { return !restore->isVisible(); }));
    // Which of them depends on what is possible just then; never STOP, never nowhere.
    auto* tune = window->docks().panel("tune");
    EXPECT_TRUE(wait([&] { return tune->isAncestorOf(QApplication::focusWidget()); }));
    session().setPace({1.0});
    ASSERT_TRUE(wait([&] { return window->bench().drive().canArm(); }));
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier); // Esc stops what is armed
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    press(Qt::Key_Escape);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(KeyboardDayTest, aWindowThatClosesUndecidedKeepsTheGainsInItsProject) {
    identifyTuneAndApply();
    window->close(); // goes on when the device is left
    ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
    const auto& designs = window->project().project().designs;
    EXPECT_TRUE(std::any_of(designs.begin(), designs.end(), [](const NamedDocument& design) {
        return design.name.find("applied on") == 0;
    })) << designs.size();
    const auto kept = window->project().recoverable({});
    ASSERT_TRUE(kept); // on the disk, not only here
    EXPECT_EQ(kept->designs.size(), designs.size());
}

TEST_F(WorkdayTest, losingTheDeviceLeavesAWindowThatWorks) {
    devices::BoardServer first;
    open();
    window->connectDevice(QString::fromStdString(first.uri()));
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    session().request([](devices::Device& device) { return device.arm(); }, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return isArmed(); }));
    first.end(); // killed while armed
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Reconnecting; }));
    EXPECT_FALSE(session().report().board.isConnected);
    for (const Perspective perspective : AllPerspectives) {
        window->docks().setPerspective(perspective);
        QTest::qWait(0);
    }
    devices::BoardServer second;
    window->connectDevice(QString::fromStdString(second.uri())); // leaves the lost one first
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_TRUE(wait([&] { return window->bench().deviceValue("hb.arm") == 0.0; }));
    EXPECT_FALSE(isArmed()); // never armed by coming back
}

} // namespace
} // namespace halbench::app
