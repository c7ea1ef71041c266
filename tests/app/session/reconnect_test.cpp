#include "app/session/connection.h"
#include "tests/app/procedures/faulty_motor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>

namespace halbench::app {
namespace {

constexpr auto Patience = std::chrono::seconds(20);

/// A board that outlives its link, the connection to it, and what the connection said. Link and board belong
/// to the connection thread: a test changes them by jobs and through the opener.
class ReconnectTest : public testing::Test {
protected:
    ~ReconnectTest() override { connection.reset(); } // before what it writes to

    void connect(double speed_ratio) {
        ReturnPlan plan{[this]() -> Result<std::unique_ptr<devices::Device>> { return reopen(); }, {}};
        plan.times.first_s = 0.01;
        plan.times.longest_s = 0.01;
        plan.times.settled_s = 0.0;
        connection = std::make_unique<Connection>(
            [this] { return Result<std::unique_ptr<devices::Device>>(motor.connect()); }, Pace{speed_ratio},
            events(), 1e9, orders, plan);
        ASSERT_TRUE(wait([&] { return isOpen; }));
    }

    void unplug() {
        isPlugged = false;
        connection->post([this](devices::Device&) { motor.faults().isUnplugged = true; });
        // in virtual time nothing happens unless somebody waits
        connection->post([this](devices::Device& device) {
            connection->beginWait(device, 0.01, [](const Result<void>&) {});
        });
        ASSERT_TRUE(wait([&] { return report.lost && report.isReturning; }));
    }

    void plugIn() {
        std::uint64_t before = 0;
        ASSERT_TRUE(wait([&] {
            before = returns;
            return true;
        }));
        isPlugged = true;
        ASSERT_TRUE(wait([&] { return returns > before && !report.lost; }));
    }

    /// What a job answers, with the returns that its author knew of.
    template <typename Function>
    Result<void> ask(Function function, std::uint64_t known) {
        std::promise<Result<void>> answer;
        connection->post([&](devices::Device& device) { answer.set_value(function(device)); }, known);
        return answer.get_future().get();
    }

    template <typename Condition>
    bool wait(Condition condition) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, Patience, condition);
    }

    /// What the board itself says.
    bool isBoardArmed() {
        std::promise<bool> armed;
        connection->post([&](devices::Device&) { armed.set_value(motor.isArmed()); });
        return armed.get_future().get();
    }

    ConnectionReport latest() {
        const std::lock_guard lock(mutex);
        return report;
    }

    FaultyMotor motor{"imperfections=off"};
    std::shared_ptr<devices::LinkOrders> orders = std::make_shared<devices::LinkOrders>();
    std::atomic<bool> isPlugged = true;
    std::mutex mutex; ///< guards what follows
    std::condition_variable changed;
    bool isOpen = false;
    bool isClosed = false;
    ConnectionReport report;
    std::uint64_t returns = 0;
    double outage_s = 0.0;
    std::vector<TimedBlock> blocks;
    std::unique_ptr<Connection> connection;

private:
    Result<std::unique_ptr<devices::Device>> reopen() {
        if (!isPlugged) {
            return failure(ErrorCode::DeviceLost, "nothing is plugged in", "plug it in");
        }
        motor.repair();
        return motor.connect();
    }

    ConnectionEvents events() {
        ConnectionEvents events;
        const auto tell = [this](auto note) {
            const std::lock_guard lock(mutex);
            note();
            changed.notify_all();
        };
        events.onOpened = [this, tell](const devices::DeviceInfo&, const devices::Catalogue&) {
            tell([this] { isOpen = true; });
        };
        events.onRefused = [](const Error&) {};
        events.onReport = [this, tell](const ConnectionReport& latest) { tell([&] { report = latest; }); };
        events.onReturned = [this, tell](const devices::DeviceInfo&, double away_s, std::uint64_t count) {
            tell([&] {
                outage_s = away_s;
                returns = count;
            });
        };
        events.onBlock = [this, tell](const TimedBlock& block) { tell([&] { blocks.push_back(block); }); };
        events.onStreamRefused = [](const Error& error) { ADD_FAILURE() << error.message; };
        events.onClosed = [this, tell] { tell([this] { isClosed = true; }); };
        return events;
    }
};

TEST_F(ReconnectTest, aDeviceThatWasArmedComesBackDisarmedAndItsStreamGoesOn) {
    connect(10.0);
    connection->setLiveStream({{"position"}, 100.0});
    ASSERT_TRUE(ask([](devices::Device& device) { return device.arm(); }, 0));
    ASSERT_TRUE(wait([&] { return blocks.size() > 3 && report.board.isArmed; }));
    unplug();
    EXPECT_FALSE(latest().board.isConnected);
    EXPECT_FALSE(latest().board.isArmed);
    std::size_t before = 0;
    ASSERT_TRUE(wait([&] {
        before = blocks.size();
        return report.notBack == "nothing is plugged in";
    }));
    plugIn();
    ASSERT_TRUE(wait([&] { return blocks.size() > before + 3; }));
    EXPECT_FALSE(isBoardArmed());
    const std::lock_guard lock(mutex);
    EXPECT_FALSE(report.board.isArmed);
    // time has passed by the host's clock: a gap, and never a step back
    double last_s = blocks.front().begin_s();
    double longest_s = 0.0;
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        const double step_s = blocks[i].begin_s() - last_s;
        ASSERT_GT(step_s, 0.0);
        longest_s = std::max(longest_s, step_s);
        last_s = blocks[i].end_s();
    }
    EXPECT_GT(longest_s, outage_s);
    EXPECT_LT(longest_s, outage_s + 1.0); // and what it takes to start a stream, at ten times real time
}

TEST_F(ReconnectTest, whatWasBegunBeforeTheLossNeverReachesTheDeviceThatCameBack) {
    connect(0.0);
    unplug();
    plugIn();
    const auto arm = [](devices::Device& device) { return device.arm(); };
    const Result<void> stale = ask(arm, 0);
    ASSERT_FALSE(stale);
    EXPECT_EQ(stale.error().code, ErrorCode::DeviceLost);
    EXPECT_FALSE(isBoardArmed());
    EXPECT_TRUE(ask(arm, 1)); // asked for by somebody who knows
    EXPECT_TRUE(ask([](devices::Device& device) { return device.disarm(); }, 1));
}

TEST_F(ReconnectTest, aStopPressedWhileTheDeviceIsAwayReachesItWhenItIsBack) {
    connect(0.0);
    unplug();
    connection->stop();
    plugIn();
    EXPECT_TRUE(wait([&] { return report.board.isStopLatched; }));
}

TEST_F(ReconnectTest, aStopIntoALinkThatIsDeadButNotYetMissedIsOwedToo) {
    connect(0.0);
    isPlugged = false;
    std::promise<void> cut;
    connection->post([&](devices::Device&) {
        motor.faults().isUnplugged = true; // nobody waits: the loss is not seen yet
        cut.set_value();
    });
    cut.get_future().wait();
    connection->stop();
    connection->post(
        [this](devices::Device& device) { connection->beginWait(device, 0.01, [](const Result<void>&) {}); });
    ASSERT_TRUE(wait([&] { return report.lost && report.isReturning; }));
    EXPECT_FALSE(latest().board.isStopLatched);
    plugIn();
    EXPECT_TRUE(wait([&] { return report.board.isStopLatched; }));
}

TEST_F(ReconnectTest, aStopOfBeforeTheLossIsNotSentAgain) {
    connect(0.0);
    connection->stop();
    ASSERT_TRUE(wait([&] { return report.board.isStopLatched; }));
    ASSERT_TRUE(ask([](devices::Device& device) { return device.clearStop(); }, 0));
    unplug();
    plugIn();
    EXPECT_FALSE(latest().board.isStopLatched);
}

TEST_F(ReconnectTest, whoWaitsWhenTheLinkBreaksIsToldOnce) {
    connect(0.0);
    isPlugged = false; // else it may be back before the test asks for its return
    std::promise<Result<void>> waited;
    connection->post([&](devices::Device& device) {
        motor.faults().unplugAt_s = 1.0; // virtual time
        connection->beginWait(device, 30.0,
                              [&](Result<void> result) { waited.set_value(std::move(result)); });
    });
    const Result<void> result = waited.get_future().get();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::DeviceLost);
    plugIn();
}

TEST_F(ReconnectTest, leavingADeviceThatIsAwayTakesNoTime) {
    connect(0.0);
    unplug();
    connection->close();
    EXPECT_TRUE(wait([&] { return isClosed; }));
}

TEST_F(ReconnectTest, aHundredCyclesWhileArmedLeaveItDisarmedWithItsGains) {
    connect(0.0);
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE(ask([&](devices::Device& device) { return device.writeParameters({&gain, 1}); }, 0));
    for (std::uint64_t cycle = 0; cycle < 100; ++cycle) {
        ASSERT_TRUE(ask([](devices::Device& device) { return device.arm(); }, cycle)) << cycle;
        unplug();
        plugIn();
        ASSERT_FALSE(isBoardArmed()) << cycle;
        ASSERT_TRUE(ask(
            [&](devices::Device& device) -> Result<void> {
                EXPECT_EQ(device.readParameters({&gain.name, 1}).value_or(std::vector{0.0}).front(), 12.5);
                return {};
            },
            cycle + 1));
    }
}

} // namespace
} // namespace halbench::app
