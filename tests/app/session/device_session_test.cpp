#include "app/procedures/identify/identify_procedure.h"
#include "app/procedures/move/move_procedure.h"
#include "app/session/device_session.h"
#include "devices/open/open_device.h"

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <mutex>

namespace halbench::app {
namespace {

constexpr int Patience_ms = 100000; // a race detector on a busy machine is a hundred times slower

/// A session with its event loop.
class DeviceSessionTest : public testing::Test {
protected:
    void connectMotor(const QString& query, double speed_ratio) {
        session.connectDevice(query.isEmpty() ? QString("sim:htm") : "sim:htm?" + query, {speed_ratio});
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
    }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    double parameter(const std::string& name) {
        std::optional<double> value;
        session.request(
            [name](devices::Device& device) { return device.readParameters(std::span(&name, 1)); },
            [&value](Result<std::vector<double>> read) { value = read ? read->front() : -1.0; });
        EXPECT_TRUE(wait([&] { return value.has_value(); }));
        return value.value_or(-1.0);
    }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    DeviceSession session;
};

IdentifyConfig shortSweep() {
    IdentifyConfig config;
    config.sweep = {2.0, 4.0, 1.0};
    config.given.inertia_kg_m2 = 5.5e-4;
    config.coastDownsPerDirection = 2;
    return config;
}

MoveConfig longMove() {
    MoveConfig config;
    config.reference = *parseMoveReference("sine,amplitude_deg=100,period_s=2");
    config.duration_s = 30.0; // longer than any test looks at
    return config;
}

TEST_F(DeviceSessionTest, identifiesToTheSameBitsAsTheDeviceItself) {
    // Second route: the procedure on the device without any thread between them, as batch mode runs it.
    const auto direct = devices::openDevice("sim:htm?seed=5", {});
    ASSERT_TRUE(direct);
    const auto expected = runIdentify(**direct, shortSweep(), {});
    ASSERT_TRUE(expected) << expected.error().message;

    connectMotor("seed=5", 0.0);
    std::optional<Result<IdentifyResult>> result;
    ASSERT_TRUE(session.runProcedure(
        "identify",
        [](devices::Device& device, const ProcedureObserver& observer) {
            return runIdentify(device, shortSweep(), observer);
        },
        [&result](Result<IdentifyResult> found) { result = std::move(found); }));
    ASSERT_TRUE(wait([&] { return result.has_value(); }));
    ASSERT_TRUE(*result) << result->error().message;
    EXPECT_EQ((*result)->viscousDamping.value, expected->viscousDamping.value);
    EXPECT_EQ((*result)->torqueConstant.value, expected->torqueConstant.value);
    EXPECT_EQ((*result)->recording.time_s, expected->recording.time_s);
    EXPECT_EQ((*result)->recording.values, expected->recording.values);
}

TEST_F(DeviceSessionTest, stopEndsAMoveAndLatches) {
    connectMotor("", 1.0);
    std::optional<Result<MoveResult>> result;
    session.runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            return runMove(device, longMove(), observer);
        },
        [&result](Result<MoveResult> found) { result = std::move(found); });
    ASSERT_TRUE(wait([&] { return session.report().board.isArmed; }));
    session.stopActuator();
    ASSERT_TRUE(wait([&] { return result.has_value(); }));
    EXPECT_FALSE(*result);
    EXPECT_TRUE(wait([&] { return session.report().board.isStopLatched; }));
    EXPECT_FALSE(session.report().board.isArmed);
    EXPECT_TRUE(session.procedure().isEmpty());
    EXPECT_EQ(session.state(), SessionState::Connected); // a stop is not a loss
}

TEST_F(DeviceSessionTest, abortRestoresTheWindowsThatTheMoveHadSet) {
    connectMotor("", 20.0);
    const double before = parameter("window.speed");
    std::optional<Result<MoveResult>> result;
    session.runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config = longMove();
            config.speedLimit_rad_s = 35.0;
            return runMove(device, config, observer);
        },
        [&result](Result<MoveResult> found) { result = std::move(found); });
    ASSERT_TRUE(wait([&] { return session.report().board.isArmed; }));
    session.abortProcedure();
    ASSERT_TRUE(wait([&] { return result.has_value(); }));
    ASSERT_FALSE(*result);
    EXPECT_EQ(result->error().code, ErrorCode::Interrupted);
    EXPECT_EQ(parameter("window.speed"), before);
    EXPECT_FALSE(session.report().board.isArmed);
}

TEST_F(DeviceSessionTest, aStreamTheDeviceRefusesIsSaidAndTheDeviceStaysConnected) {
    connectMotor("", 20.0);
    QString said;
    const QObject listener; // goes before what it writes to
    QObject::connect(&session, &DeviceSession::message, &listener,
                     [&said](MessageLevel level, const QString&, const QString& text) {
                         said = level == MessageLevel::Warning ? text : said;
                     });
    session.setLiveStream({"position", "no.such.signal"}, 100.0);
    EXPECT_TRUE(wait([&] { return said.contains("no.such.signal"); }));
    EXPECT_EQ(session.state(), SessionState::Connected);
}

TEST_F(DeviceSessionTest, aBlockSinkHearsEveryRowThatTheDeviceSent) {
    connectMotor("", 20.0);
    std::mutex mutex;
    std::vector<TimedBlock> heard;
    session.setBlockSink([&](const TimedBlock& block) {
        const std::lock_guard lock(mutex);
        heard.push_back(block);
    });
    session.setLiveStream({"position"}, 100.0);
    ASSERT_TRUE(wait([&] {
        const std::lock_guard lock(mutex);
        return heard.size() > 10;
    }));
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Disconnected; })); // no call follows
    std::vector<double> times_s;
    for (const TimedBlock& block : heard) {
        EXPECT_EQ(block.block->lostRows, 0U);
        for (std::size_t row = 0; row < block.rows(); ++row) {
            times_s.push_back(block.time_s(row));
        }
    }
    for (std::size_t i = 1; i < times_s.size(); ++i) {             // the device sends a row every 10 ms
        ASSERT_NEAR(times_s[i] - times_s[i - 1], 0.01, 1e-9) << i; // 1e-9: rounding of seconds
    }
    EXPECT_TRUE(session.takeBlocks().empty()); // forgotten with the device
}

TEST_F(DeviceSessionTest, aFloodThatNobodyTakesIsLeftOutAndSaid) {
    connectMotor("", 50.0);
    QString said;
    const QObject listener;
    QObject::connect(&session, &DeviceSession::message, &listener,
                     [&said](MessageLevel level, const QString&, const QString& text) {
                         said = level == MessageLevel::Warning ? text : said;
                     });
    std::atomic<std::size_t> rows = 0;
    session.setBlockSink([&rows](const TimedBlock& block) { rows += block.rows(); });
    session.setLiveStream({"position"}, 1000.0);
    ASSERT_TRUE(wait([&] { return rows > 150000; })); // more than two minutes at 1 kHz
    std::size_t taken = 0;
    for (const TimedBlock& block : session.takeBlocks()) {
        taken += block.rows();
    }
    EXPECT_LE(taken, 120000U);
    EXPECT_GT(taken, 119000U); // full up to a block
    EXPECT_TRUE(said.contains("not shown"));
    EXPECT_EQ(session.state(), SessionState::Connected);
    session.end(); // the sink counts into this function's variable
}

TEST_F(DeviceSessionTest, displayTimeGoesOnWhileStreamsChange) {
    connectMotor("", 20.0);
    session.setLiveStream({"position"}, 100.0);
    std::vector<TimedBlock> blocks;
    const auto collect = [&] {
        for (TimedBlock& block : session.takeBlocks()) {
            blocks.push_back(std::move(block));
        }
        return blocks.size();
    };
    ASSERT_TRUE(wait([&] { return collect() > 3; }));
    std::optional<Result<MoveResult>> result;
    session.runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config = longMove();
            config.duration_s = 1.0;
            return runMove(device, config, observer);
        },
        [&result](Result<MoveResult> found) { result = std::move(found); });
    ASSERT_TRUE(wait([&] { return result.has_value(); }));
    ASSERT_TRUE(*result) << result->error().message;
    const std::size_t before = collect();
    ASSERT_TRUE(wait([&] { return collect() > before + 3; }));
    double last_s = -1.0;
    for (const TimedBlock& block : blocks) {
        EXPECT_GT(block.begin_s(), last_s);
        last_s = block.end_s();
    }
    EXPECT_EQ(blocks.front().block->layout->columns.size(), 1U);
    EXPECT_EQ(blocks.back().block->layout->columns.size(), 1U); // the live stream is back
}

TEST_F(DeviceSessionTest, anAddressThatCannotBeOpenedIsSaidWithItsRemedy) {
    QString message;
    QString hint;
    QObject::connect(&session, &DeviceSession::connectFailed, &session,
                     [&](const QString& text, const QString& remedy) {
                         message = text;
                         hint = remedy;
                     });
    session.connectDevice("sim:htm?colour=3", {1.0});
    ASSERT_TRUE(wait([&] { return !message.isEmpty(); }));
    EXPECT_TRUE(message.contains("colour"));
    EXPECT_FALSE(hint.isEmpty());
    EXPECT_EQ(session.state(), SessionState::Disconnected);
}

TEST_F(DeviceSessionTest, aRequestWithoutADeviceIsAnsweredAtOnce) {
    std::optional<ErrorCode> code;
    session.request([](devices::Device& device) { return device.disarm(); },
                    [&code](Result<void> answer) { code = answer.error().code; });
    EXPECT_EQ(code, ErrorCode::DeviceLost);
}

} // namespace
} // namespace halbench::app
