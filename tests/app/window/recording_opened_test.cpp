// A recording in the window: it is no device, and one click leads back to the device.
#include "app/window/connect_button.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/record_button.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/drive/arm_button.h"
#include "devices/formats/recording_file.h"
#include "tests/app/window/top_bar_fixture.h"
#include "widgets/controls/status_strip.h"
#include "widgets/controls/stop_button.h"

#include <QLabel>

namespace halbench::app {
namespace {

class RecordingOpenedTest : public TopBarTest {
protected:
    /// A second of a turn at 100 Hz.
    QString written() {
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(
            StreamLayout{{{"position", "rad"}, {"speed", "rad/s"}, {"reference", "rad"}}, 0.01});
        for (int row = 0; row < 100; ++row) {
            recording.time_s.push_back(row / 100.0);
            recording.values.insert(recording.values.end(), {0.01 * row, 1.0, 0.0});
        }
        devices::RecordingMeta meta;
        meta.device.model = "htm";
        meta.device.id = "HB-17";
        meta.started = "2026-01-01T00:00:00Z";
        meta.signals = {{"position", "position_rad", "rad", "position"},
                        {"speed", "speed_rad_s", "rad/s", "speed"},
                        {"reference", "reference_rad", "rad", "reference"}};
        const QString path = folder.filePath("turn.csv");
        EXPECT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
        return path;
    }
    void openRecording() {
        window->bench().shownRecording().open(written());
        ASSERT_TRUE(wait([&] {
            return session().state() == SessionState::Connected && session().info().transport == "replay";
        }));
    }
    bool says(const QString& words) {
        for (const auto* label : inBar<widgets::StatusStrip>()->findChildren<QLabel*>()) {
            if (label->isVisible() && label->text() == words) {
                return true;
            }
        }
        return false;
    }

    QTemporaryDir folder;
};

TEST_F(RecordingOpenedTest, isMarkedAndOffersNothingThatMoves) {
    open();
    window->resize(1920, 1000);
    connectMotor(1.0);
    ASSERT_TRUE(says("SIMULATED"));
    openRecording();
    EXPECT_TRUE(says("RECORDING"));
    EXPECT_TRUE(says("turn.csv"));
    EXPECT_FALSE(says("SIMULATED"));
    EXPECT_FALSE(says("Connected"));
    EXPECT_FALSE(inBar<ArmButton>()->isVisible());
    EXPECT_FALSE(inBar<RecordButton>()->isVisible());
    EXPECT_FALSE(window->docks().isOffered("drive"));
    EXPECT_TRUE(inBar<widgets::StopButton>()->isVisible()) << "always";
}

TEST_F(RecordingOpenedTest, isLeftForTheDeviceByOneClick) {
    open();
    connectMotor(1.0);
    openRecording();
    auto* back = inBar<ConnectButton>();
    EXPECT_EQ(back->text(), "Back");
    EXPECT_TRUE(back->toolTip().contains("sim:htm")) << back->toolTip().toStdString();
    back->click();
    ASSERT_TRUE(wait(
        [&] { return session().state() == SessionState::Connected && session().info().uri == "sim:htm"; }));
    EXPECT_TRUE(inBar<ArmButton>()->isVisible());
    EXPECT_EQ(back->text(), "Disconnect");
    EXPECT_EQ(session().heldDevice(), "");
}

TEST_F(RecordingOpenedTest, isClosedWhereNoDeviceWasConnected) {
    open();
    openRecording();
    auto* close = inBar<ConnectButton>();
    EXPECT_EQ(close->text(), "Close");
    close->click();
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
}

} // namespace
} // namespace halbench::app
