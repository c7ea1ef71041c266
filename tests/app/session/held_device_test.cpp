// A recording that is opened leaves the connected device as it is.
#include "app/session/device_session.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

constexpr int Patience_ms = 100000;
constexpr const char* Gain = "gain.kp";

class HeldDeviceTest : public testing::Test {
protected:
    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }
    bool isConnectedTo(const QString& uri) {
        return wait([&] {
            return session.state() == SessionState::Connected &&
                   QString::fromStdString(session.info().uri) == uri;
        });
    }
    void connectMotor() {
        session.connectDevice("sim:htm", {1.0});
        ASSERT_TRUE(isConnectedTo("sim:htm"));
    }
    QString recording(const char* name) const {
        Recording rows;
        rows.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
        for (int row = 0; row < 100; ++row) {
            rows.time_s.push_back(0.01 * row);
            rows.values.push_back(0.02 * row);
        }
        const QString path = folder.filePath(name);
        EXPECT_TRUE(devices::writeRecordingFile(path.toStdString(), rows, {}));
        return "replay:" + path;
    }
    void openRecording(const char* name = "turn.csv") {
        const QString uri = recording(name);
        session.connectDevice(uri, {0.0});
        ASSERT_TRUE(isConnectedTo(uri));
    }
    void writeGain(double value) {
        bool isWritten = false;
        session.request(
            [value](devices::Device& device) {
                const ParameterValue gain{Gain, value};
                return device.writeParameters(std::span(&gain, 1));
            },
            [&isWritten](const Result<void>& written) { isWritten = written.has_value(); });
        ASSERT_TRUE(wait([&] { return isWritten; }));
    }
    double gain() {
        std::optional<double> value;
        session.request(
            [](devices::Device& device) {
                const std::string name = Gain;
                return device.readParameters(std::span(&name, 1));
            },
            [&value](Result<std::vector<double>> read) { value = read ? read->front() : -1.0; });
        EXPECT_TRUE(wait([&] { return value.has_value(); }));
        return value.value_or(-1.0);
    }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    QTemporaryDir folder;
    DeviceSession session;
};

TEST_F(HeldDeviceTest, keepsItsGainsWhileRecordingsAreOpen) {
    connectMotor();
    writeGain(12.5);
    for (const char* name : {"one.csv", "two.csv"}) { // one after the other
        openRecording(name);
        EXPECT_EQ(session.heldDevice(), "sim:htm");
    }
    session.closeRecording();
    ASSERT_TRUE(isConnectedTo("sim:htm"));
    EXPECT_EQ(session.heldDevice(), "");
    EXPECT_EQ(gain(), 12.5);
}

TEST_F(HeldDeviceTest, comesBackWhenItsAddressIsConnected) {
    connectMotor();
    writeGain(12.5);
    openRecording();
    session.connectDevice("sim:htm", {1.0});
    ASSERT_TRUE(isConnectedTo("sim:htm"));
    EXPECT_EQ(gain(), 12.5);
}

TEST_F(HeldDeviceTest, comesBackWhenTheRecordingCannotBeRead) {
    connectMotor();
    writeGain(12.5);
    bool hasFailed = false;
    QObject::connect(&session, &DeviceSession::connectFailed, [&] { hasFailed = true; });
    session.connectDevice("replay:" + folder.filePath("none.csv"), {0.0});
    ASSERT_TRUE(wait([&] { return hasFailed; }));
    ASSERT_TRUE(isConnectedTo("sim:htm"));
    EXPECT_EQ(gain(), 12.5);
}

TEST_F(HeldDeviceTest, isStoppedWithTheRecording) {
    connectMotor();
    openRecording();
    session.stopActuator();
    session.closeRecording();
    ASSERT_TRUE(isConnectedTo("sim:htm"));
    EXPECT_TRUE(wait([&] { return session.report().board.isStopLatched; }));
}

TEST_F(HeldDeviceTest, showsNoRowsUntilItIsBack) {
    connectMotor();
    session.setLiveStream({"position"}, 100.0);
    std::size_t rows = 0;
    ASSERT_TRUE(wait([&] {
        rows += session.takeBlocks().size();
        return rows > 0;
    }));
    openRecording();
    for (const TimedBlock& block : session.takeBlocks()) {
        EXPECT_LE(block.end_s(), 1.0) << "a second of recording";
    }
    session.closeRecording();
    ASSERT_TRUE(isConnectedTo("sim:htm"));
    session.setLiveStream({"position"}, 100.0);
    EXPECT_TRUE(wait([&] { return !session.takeBlocks().empty(); })) << "its time goes on";
}

TEST_F(HeldDeviceTest, isLeftWithTheRecordingByDisconnect) {
    connectMotor();
    writeGain(12.5);
    openRecording();
    int disconnected = 0;
    QObject::connect(&session, &DeviceSession::stateChanged,
                     [&] { disconnected += session.state() == SessionState::Disconnected ? 1 : 0; });
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Disconnected; }));
    EXPECT_EQ(disconnected, 1) << "once, when both are left: a window closes then";
    EXPECT_EQ(session.heldDevice(), "");
    connectMotor();
    EXPECT_NE(gain(), 12.5) << "a simulated motor is new";
}

TEST_F(HeldDeviceTest, isLeftForAnotherDevice) {
    connectMotor();
    openRecording();
    session.connectDevice("sim:htm?seed=7", {1.0});
    ASSERT_TRUE(isConnectedTo("sim:htm?seed=7"));
    EXPECT_EQ(session.heldDevice(), "");
}

} // namespace
} // namespace halbench::app
