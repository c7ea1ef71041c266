#include "tests/devices/firmware/avr/avr_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::simavr {
namespace {

using devices::BoardMode;

// Masters that come, go and are not heard, at the board's processor (resources/help/protocol.md 3.15, gate
// 2).

/// Loses the answer of the next write of one octet after it was told to.
class ForgetfulLine : public AvrTransport {
public:
    using AvrTransport::AvrTransport;
    bool losesNext = false;
    int lost = 0;

    Result<void> send(std::span<const std::uint8_t> packet) override {
        m_isLosing = losesNext && packet.size() == 9 && packet[0] == 0xED;
        losesNext = losesNext && !m_isLosing;
        return AvrTransport::send(packet);
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        Result<bool> received = AvrTransport::receive(packet, timeout_s);
        if (m_isLosing && received && *received && packet[0] == 0xFF) {
            m_isLosing = false;
            ++lost;
            return false;
        }
        return received;
    }

private:
    bool m_isLosing = false;
};

void turn(AvrBench& bench) {
    ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Current)));
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("hb.setpoint", 3.0));
    bench.wait(0.3);
    ASSERT_TRUE(bench.board->dacCode(0) != 2048 || bench.board->dacCode(1) != 2048);
}

void expectAtRest(const AvrBoard& board) {
    EXPECT_EQ(board.dacCode(0), 2048);
    EXPECT_EQ(board.dacCode(1), 2048);
}

TEST(AvrMasters, aStartWhoseAnswerIsLostMovesByOneStep) {
    const auto board = makeBoard(perfectMotor());
    auto line = std::make_unique<ForgetfulLine>(board);
    ForgetfulLine& forgetful = *line;
    auto opened = devices::openXcpDevice(std::move(line), {});
    ASSERT_TRUE(opened) << opened.error().message;
    AvrBench bench{board, std::move(*opened)};
    for (const auto& [name, value] : {std::pair{"hb.mode", 2.0},
                                      {"reference.shape", 1.0},
                                      {"reference.amplitude", 1.0},
                                      {"reference.duration", 0.1}}) {
        ASSERT_TRUE(bench.write(name, value)) << name;
    }
    ASSERT_TRUE(bench.device->arm());
    bench.wait(0.05);
    const double before_rad = bench.read("reference");
    for (int step = 1; step <= 2; ++step) {
        forgetful.losesNext = true;
        const auto started = bench.write("reference.start", 1.0);
        ASSERT_TRUE(started) << started.error().message;
        bench.wait(0.7);
        EXPECT_EQ(forgetful.lost, step);
        EXPECT_NEAR(bench.read("reference") - before_rad, step, 1e-6);
    }
}

TEST(AvrMasters, theWatchdogCannotBeTakenAwayWhileArmed) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    turn(bench);
    EXPECT_FALSE(bench.write("hb.watchdog_ms", 0.0));
    EXPECT_FALSE(bench.write("hb.watchdog_ms", 60000.0)); // the description's limit
    bench.board->advanceTo(bench.board->time_s() + 1.1);
    expectAtRest(*bench.board);
}

TEST(AvrMasters, oneThatIsKilledInMidStreamLeavesABoardAtRestForTheNext) {
    const auto board = makeBoard(perfectMotor());
    {
        AvrBench killed = connect(board);
        ASSERT_TRUE(killed.device);
        ASSERT_TRUE(
            killed.device->startStream({{"position", "status"}, 100.0}, [](const SampleBlockPtr&) {}));
        turn(killed);
        // Nobody takes what the board sends, nobody sends; the watchdog set by arming is 1 s.
        board->advanceTo(board->time_s() + 1.1);
        expectAtRest(*board);
        board->core().take();
        board->advanceTo(board->time_s() + 0.5);
        EXPECT_TRUE(board->core().take().empty()) << "its session is over";
        EXPECT_FALSE(killed.device->clock().waitFor(3.0));
    }
    AvrBench next = connect(board);
    ASSERT_TRUE(next.device);
    turn(next);
}

TEST(AvrMasters, aSecondOneOnTheLineEndsTheMotionAndTheFirstIsTold) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    ASSERT_TRUE(bench.device->startStream({{"position", "status"}, 100.0}, [](const SampleBlockPtr&) {}));
    turn(bench);
    std::vector<std::uint8_t> line;
    devices::SxiFraming().append(line, 0, std::vector<std::uint8_t>{0xFF, 0x00}); // CONNECT
    bench.board->core().send(line);
    bench.board->advanceTo(bench.board->time_s() + 0.030); // the line, a tick, the converters
    expectAtRest(*bench.board);
    EXPECT_FALSE(bench.device->clock().waitFor(1.0)) << "its samples have ended";
}

} // namespace
} // namespace halbench::simavr
