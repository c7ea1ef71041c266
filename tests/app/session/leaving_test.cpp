#include "app/procedures/move/move_procedure.h"
#include "app/session/device_session.h"
#include "devices/open/open_device.h"
#include "devices/transport/tcp_server.h"
#include "tests/devices/transport/served_board.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <future>

namespace halbench::app {
namespace {

constexpr int Patience_ms = 20000;

/// Holds up another thread until the test lets it go: a fit or a board that takes longer than anybody waits.
class Gate {
public:
    void open() { m_promise.set_value(); }
    void pass() const { m_future.wait(); }

private:
    std::promise<void> m_promise;
    std::shared_future<void> m_future = m_promise.get_future().share();
};

/// Turns of the event loop and the longest time between two of them.
class Heartbeat {
public:
    Heartbeat() {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            longest_ms = std::max(longest_ms, m_since.restart());
            ++turns;
        });
        m_since.start();
        m_timer.start(5);
    }
    int turns = 0;
    qint64 longest_ms = 0;

private:
    QTimer m_timer;
    QElapsedTimer m_since;
};

/// A session on a board in a thread of the test.
class LeavingTest : public testing::Test {
protected:
    void connectBoard() {
        session.connectDevice(QString::fromStdString(board.uri()), {1.0});
        ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
    }

    template <typename Condition>
    static bool wait(Condition condition) {
        return QTest::qWaitFor(condition, Patience_ms);
    }

    bool hasLeft() { return session.state() == SessionState::Disconnected; }

    /// What the board says to the next master.
    devices::DeviceState boardState() const {
        const auto next = devices::openDevice(board.uri(), {});
        EXPECT_TRUE(next) << next.error().message;
        return next ? (*next)->state() : devices::DeviceState();
    }

    /// A board that was left armed latches a stop when its watchdog of 1 s runs out in its own time.
    void expectDisarmedInOrder() const {
        QTest::qWait(1500);
        const devices::DeviceState state = boardState();
        EXPECT_FALSE(state.isArmed);
        EXPECT_FALSE(state.isStopLatched);
    }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    devices::BoardServer board;
    Gate gate; ///< outlives the session's threads
    DeviceSession session;
};

TEST_F(LeavingTest, anArmedActuatorIsDisarmedFirst) {
    connectBoard();
    session.request([](devices::Device& device) { return device.arm(); }, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return session.report().board.isArmed; }));
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    expectDisarmedInOrder();
}

TEST_F(LeavingTest, aMoveEndsThroughItsRestorePathAndTheBoardIsDisarmed) {
    connectBoard();
    std::optional<Result<MoveResult>> moved;
    session.runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config;
            config.reference = *parseMoveReference("sine,amplitude_deg=100,period_s=2");
            config.duration_s = 30.0;
            return runMove(device, config, observer);
        },
        [&moved](Result<MoveResult> result) { moved = std::move(result); });
    ASSERT_TRUE(wait([&] { return session.report().board.isArmed; }));
    session.disconnectDevice();
    EXPECT_EQ(session.state(), SessionState::Leaving);
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    EXPECT_TRUE(session.procedure().isEmpty());
    EXPECT_TRUE(moved && !*moved);
    expectDisarmedInOrder();
}

TEST_F(LeavingTest, aFitHoldsUpNeitherTheWindowNorTheDisarming) {
    connectBoard();
    bool hasEnded = false;
    session.runProcedure(
        "fit",
        [this](devices::Device& device, const ProcedureObserver&) {
            Result<void> armed = device.arm();
            gate.pass();
            return armed;
        },
        [&hasEnded](const Result<void>&) { hasEnded = true; });
    ASSERT_TRUE(wait([&] { return session.report().board.isArmed; }));
    session.disconnectDevice(); // would wait for ever if it waited
    EXPECT_TRUE(wait([&] { return !session.report().board.isArmed; }));
    EXPECT_FALSE(hasEnded);
    EXPECT_EQ(session.state(), SessionState::Leaving);
    gate.open();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    EXPECT_TRUE(hasEnded);
    expectDisarmedInOrder();
}

TEST_F(LeavingTest, aCommandThatHangsHoldsUpNoWindowAndAStopIsStillObeyed) {
    connectBoard();
    session.request([this](devices::Device& device) { return gate.pass(), device.arm(); },
                    [](const Result<void>&) {});
    session.disconnectDevice();
    const Heartbeat heartbeat;
    ASSERT_TRUE(wait([&] { return heartbeat.turns > 20; }));
    EXPECT_EQ(session.state(), SessionState::Leaving);
    session.stopActuator();
    gate.open();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    const devices::DeviceState state = boardState();
    EXPECT_FALSE(state.isArmed);
    EXPECT_TRUE(state.isStopLatched);
}

TEST_F(LeavingTest, aBoardThatDoesNotAnswerIsGivenUpWhileItIsBeingOpened) {
    auto silent = devices::TcpServer::listen({"127.0.0.1", 0}); // the system accepts, nobody answers
    ASSERT_TRUE(silent);
    session.connectDevice(QString::fromStdString(silent->address()), {1.0});
    Heartbeat heartbeat;
    ASSERT_TRUE(wait([&] { return heartbeat.turns > 5; }));
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    // A try of CONNECT takes 300 ms and all of them 1.8 s; the rest is what a loaded machine may need.
    EXPECT_LT(heartbeat.longest_ms, 150);
}

TEST_F(LeavingTest, theNextDeviceIsConnectedOnceTheOldOneIsLeft) {
    connectBoard();
    session.request([this](devices::Device&) -> Result<void> { return gate.pass(), Result<void>(); },
                    [](const Result<void>&) {});
    session.connectDevice("sim:htm?seed=3", {1.0});
    session.connectDevice("sim:htm?seed=4", {1.0}); // the last wish counts
    EXPECT_EQ(session.state(), SessionState::Leaving);
    gate.open();
    ASSERT_TRUE(wait([&] { return session.state() == SessionState::Connected; }));
    EXPECT_EQ(session.info().id, "sim-htm-4");
}

TEST_F(LeavingTest, anAnswerOfTheDeviceBeforeComesBeforeItIsLeft) {
    connectBoard();
    int answers = 0;
    for (int i = 0; i < 100; ++i) {
        session.request([](devices::Device& device) { return device.disarm(); },
                        [&](const Result<void>&) {
                            EXPECT_FALSE(hasLeft());
                            ++answers;
                        });
    }
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    EXPECT_EQ(answers, 100);
}

TEST_F(LeavingTest, aReleaseThatWaitedIsRefusedWhenAStopCameLater) {
    connectBoard();
    session.stopActuator();
    ASSERT_TRUE(wait([&] { return session.report().board.isStopLatched; }));
    session.request([this](devices::Device&) -> Result<void> { return gate.pass(), Result<void>(); },
                    [](const Result<void>&) {});
    std::optional<Result<void>> released;
    session.requestUnlessStopped([](devices::Device& device) { return device.clearStop(); },
                                 [&released](Result<void> done) { released = std::move(done); });
    session.stopActuator();
    gate.open();
    ASSERT_TRUE(wait([&] { return released.has_value(); }));
    ASSERT_FALSE(*released);
    EXPECT_EQ(released->error().code, ErrorCode::Interrupted);
    session.disconnectDevice();
    ASSERT_TRUE(wait([&] { return hasLeft(); }));
    EXPECT_TRUE(boardState().isStopLatched);
}

} // namespace
} // namespace halbench::app
