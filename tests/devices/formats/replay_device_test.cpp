#include "devices/acquisition/guard.h"
#include "devices/formats/recording_file.h"
#include "devices/open/open_device.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>

namespace halbench::devices {
namespace {

Recording record(Device& device, const StreamRequest& request, double duration_s) {
    Recording recording;
    const auto started =
        device.startStream(request, [&](const SampleBlockPtr& block) { recording.append(*block); });
    EXPECT_TRUE(started) << started.error().message;
    EXPECT_TRUE(device.clock().waitFor(duration_s));
    device.stopStream();
    return recording;
}

class ReplayDeviceTest : public testing::Test {
protected:
    void SetUp() override {
        const auto board = openDevice("sim:htm", {});
        ASSERT_TRUE(board);
        m_live = record(**board, {{"position", "hall.a", "current_command"}, 1000.0}, 0.5);
        const RecordingMeta meta = describeRecording(**board, *m_live.layout, "1970-01-01T00:00:00Z");
        m_path = m_folder.filePath("run.csv").toStdString();
        ASSERT_TRUE(writeRecordingFile(m_path, m_live, meta));
        auto replay = openDevice("replay:" + m_path, {});
        ASSERT_TRUE(replay) << replay.error().message;
        m_replay = *std::move(replay);
    }

    QTemporaryDir m_folder;
    std::string m_path;
    Recording m_live;
    std::unique_ptr<Device> m_replay;
};

TEST_F(ReplayDeviceTest, playsTheSameSamplesAtTheSameTimes) {
    const Recording again = record(*m_replay, {{"position", "hall.a", "current_command"}, 1000.0}, 0.499);
    ASSERT_EQ(again.rows(), 500U);
    EXPECT_EQ(again.time_s, std::vector<double>(m_live.time_s.begin(), m_live.time_s.begin() + 500));
    EXPECT_EQ(again.lostRows, 0U);
    for (std::size_t i = 0; i < again.values.size(); ++i) {
        // 4-octet floats are kept in their own precision: half a unit of the 24-bit mantissa.
        EXPECT_NEAR(again.values[i], m_live.values[i], std::abs(m_live.values[i]) * 6.0e-8);
    }
}

TEST_F(ReplayDeviceTest, aLongRecordingIsGivenUpWhileItIsRead) {
    const std::string path = m_folder.filePath("long.csv").toStdString();
    {
        std::ofstream out(path);
        out << "time_s,a\n";
        for (int row = 0; row < 5000; ++row) {
            out << row << ",1\n";
        }
    }
    OpenOptions options;
    const auto orders = std::make_shared<LinkOrders>();
    options.orders = orders;
    EXPECT_TRUE(openDevice("replay:" + path, options));
    orders->isLeaving = true;
    const auto given = openDevice("replay:" + path, options);
    ASSERT_FALSE(given);
    EXPECT_EQ(given.error().code, ErrorCode::Interrupted);
    const std::atomic<int> signal = SIGTERM;
    options.orders = nullptr;
    options.interruptSignal = &signal;
    EXPECT_EQ(openDevice("replay:" + path, options).error().code, ErrorCode::Terminated);
}

TEST_F(ReplayDeviceTest, playsEveryTenthSampleAtATenthOfTheRate) {
    const Recording slow = record(*m_replay, {{"hall.a"}, 100.0}, 0.4);
    ASSERT_GE(slow.rows(), 40U);
    EXPECT_EQ(slow.lostRows, 0U);
    EXPECT_DOUBLE_EQ(slow.layout->period_s, 0.01);
    for (std::size_t row = 0; row < 40; ++row) {
        EXPECT_NEAR(slow.time_s[row], static_cast<double>(row) / 100.0, 1e-12);
    }
}

TEST_F(ReplayDeviceTest, beginsWhereItIsAskedWithTheTimesOfTheRecording) {
    const auto late = openDevice("replay:" + m_path + "?at=0.3", {});
    ASSERT_TRUE(late) << late.error().message;
    EXPECT_EQ((*late)->clock().now_s(), 0.3);
    const std::string name = "position";
    EXPECT_EQ((*(*late)->readSignals({&name, 1}))[0], (*readRecordingFile(m_path)).recording.values[3 * 300]);
    std::size_t rows = 0;
    ASSERT_TRUE((*late)->startStream({{"position"}, 1000.0},
                                     [&](const SampleBlockPtr& block) { rows += block->rows(); }));
    ASSERT_TRUE((*late)->clock().waitFor(0.1));
    EXPECT_NEAR(static_cast<double>(rows), 101.0, 1.0); // both ends
    EXPECT_EQ(openDevice("replay:" + m_path + "?at=7", {}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(openDevice("replay:" + m_path + "?at=x", {}).error().code, ErrorCode::FileSystem);
}

TEST_F(ReplayDeviceTest, aQuestionMarkInAFilesNameIsOne) {
    const std::string name = m_folder.filePath("odd?at=0.csv").toStdString();
    ASSERT_TRUE(writeRecordingFile(name, m_live, {}));
    const auto device = openDevice("replay:" + name, {});
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->clock().now_s(), 0.0);
}

TEST_F(ReplayDeviceTest, cannotBeChangedOrArmed) {
    const ParameterValue change{"gain.kp", 1.0};
    EXPECT_EQ(m_replay->writeParameters({&change, 1}).error().code, ErrorCode::DeviceRefused);
    EXPECT_EQ(m_replay->arm().error().code, ErrorCode::DeviceRefused);
    EXPECT_FALSE(m_replay->state().isArmed);
    const std::string name = "gain.kp";
    EXPECT_EQ((*m_replay->readParameters({&name, 1}))[0], 10.0) << "the value at the recording's start";
}

TEST_F(ReplayDeviceTest, endsWithTheRecording) {
    const auto waited = m_replay->clock().waitFor(10.0);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
}

TEST_F(ReplayDeviceTest, refusesRatesAndSignalsTheRecordingDoesNotHave) {
    const auto sink = [](const SampleBlockPtr&) {};
    EXPECT_EQ(m_replay->startStream({{"hall.a"}, 300.0}, sink).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(m_replay->startStream({{"hall.a"}, 2000.0}, sink).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(m_replay->startStream({{"speed"}, 100.0}, sink).error().code, ErrorCode::UnknownName);
}

TEST(Guard, stopsTheDeviceAtTheFirstValueOutside) {
    const auto opened = openDevice("sim:htm?imperfections=off", {});
    ASSERT_TRUE(opened);
    Device& device = **opened;
    Guard guard(device, {{"speed", -2.0, 2.0}});
    const std::vector<ParameterValue> drive = {{"hb.mode", 1.0}};
    ASSERT_TRUE(device.writeParameters(drive));
    ASSERT_TRUE(device.startStream({{"speed"}, 1000.0}, guard.watching(nullptr)));
    ASSERT_TRUE(device.arm());
    const std::vector<ParameterValue> push = {{"hb.setpoint", 3.0}};
    ASSERT_TRUE(device.writeParameters(push));
    const auto waited = device.clock().waitFor(2.0);
    ASSERT_FALSE(waited) << "3 A accelerate far beyond 2 rad/s within 2 s";
    EXPECT_EQ(waited.error().code, ErrorCode::SafetyStop);
    ASSERT_TRUE(guard.tripped());
    EXPECT_EQ(guard.tripped()->code, ErrorCode::SafetyStop);
    EXPECT_NE(guard.tripped()->message.find("speed"), std::string::npos);
    EXPECT_TRUE(device.state().isStopLatched);
}

TEST(Guard, passesEveryBlockOnAndStaysQuietInside) {
    const auto opened = openDevice("sim:htm?imperfections=off", {});
    ASSERT_TRUE(opened);
    Guard guard(**opened, {{"speed", -1e6, 1e6}, {"not streamed", 0.0, 0.0}});
    std::size_t rows = 0;
    ASSERT_TRUE((*opened)->startStream(
        {{"speed"}, 1000.0}, guard.watching([&](const SampleBlockPtr& block) { rows += block->rows(); })));
    ASSERT_TRUE((*opened)->clock().waitFor(0.1));
    EXPECT_GE(rows, 99U);
    EXPECT_FALSE(guard.tripped());
}

TEST(Guard, countsAPositionFromTheFirstValueItSees) {
    const auto opened = openDevice("sim:htm?imperfections=off&psi0=5", {});
    ASSERT_TRUE(opened);
    Guard guard(**opened, {{"position", -1.0, 1.0, true}});
    const BlockSink sink = guard.watching(nullptr);
    const auto layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.001});
    sink(std::make_shared<SampleBlock>(SampleBlock{layout, {0.0, 0.1}, {5.0, 5.9}, 0.0, 0}));
    EXPECT_FALSE(guard.tripped());
    sink(std::make_shared<SampleBlock>(SampleBlock{layout, {0.2}, {3.9}, 0.0, 0}));
    ASSERT_TRUE(guard.tripped());
    EXPECT_TRUE((*opened)->state().isStopLatched);
}

TEST(Guard, stopsWhenAValueIsNotANumber) {
    const auto opened = openDevice("sim:htm?imperfections=off", {});
    ASSERT_TRUE(opened);
    Guard guard(**opened, {{"speed", -1.0, 1.0}});
    const auto layout = std::make_shared<const StreamLayout>(StreamLayout{{{"speed", "rad/s"}}, 0.001});
    guard.watching(nullptr)(
        std::make_shared<SampleBlock>(SampleBlock{layout, {0.0}, {std::nan("")}, 0.0, 0}));
    ASSERT_TRUE(guard.tripped());
    EXPECT_NE(guard.tripped()->message.find("not a number"), std::string::npos);
}

} // namespace
} // namespace halbench::devices
