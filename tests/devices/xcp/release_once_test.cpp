#include "devices/simulated/htm/simulated_htm.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/spoiled_line.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <utility>

namespace halbench::devices::xcp {
namespace {

// A release clears what has latched: what the line loses must not make it clear what latches afterwards,
// which nobody has seen yet (resources/help/protocol.md 3.15).

constexpr double Late_s = 0.7; // longer than a master waits, 0.5 s
constexpr std::uint8_t UserCommand = 0xF1;
constexpr std::uint8_t Stop = 0x45;
constexpr std::uint8_t Release = 0x52;

bool isRelease(std::span<const std::uint8_t> packet) {
    return packet.size() == 2 && packet[0] == UserCommand && packet[1] == Release;
}

class ReleaseOnce : public testing::TestWithParam<Loss> {
protected:
    void SetUp() override {
        auto made = makeSimulatedHtm({}, 1);
        ASSERT_TRUE(made);
        board = std::shared_ptr<SimulatedBoard>(std::move(*made));
        auto transport = std::make_unique<SpoiledLine>(board, Late_s, isRelease);
        line = transport.get();
        auto opened = openXcpDevice(std::move(transport), {});
        ASSERT_TRUE(opened) << opened.error().message;
        device = std::move(*opened);
        ASSERT_TRUE(device->arm());
        device->stop();
        ASSERT_EQ(board->firmware().safety.stop, HB_LATCH_COMMAND);
    }
    /// Of somebody else, who is not answered.
    void stopFromElsewhere() {
        const std::array<std::uint8_t, 2> stop{UserCommand, Stop};
        board->receive(stop);
        std::array<std::uint8_t, 512> answer{};
        while (board->transmit(answer) > 0) {
        }
    }
    bool isLatched() const { return hb_safety_latch(&board->firmware().safety) != HB_LATCH_NONE; }
    bool isArmed() const { return board->firmware().safety.armed != 0; }

    std::shared_ptr<SimulatedBoard> board;
    SpoiledLine* line = nullptr;
    std::unique_ptr<Device> device;
};

class ReleaseUnanswered : public ReleaseOnce {};

TEST_P(ReleaseOnce, isSentOnceAndSaysWhatCameOfIt) {
    line->loss = GetParam();
    const auto released = device->clearStop();
    EXPECT_EQ(line->sent, 1);
    EXPECT_EQ(released.has_value(), GetParam() != Loss::Command);
    EXPECT_EQ(isLatched(), GetParam() == Loss::Command);
    if (!released) {
        EXPECT_EQ(released.error().code, ErrorCode::Protocol);
        EXPECT_NE(released.error().message.find("still stopped"), std::string::npos)
            << released.error().message;
        EXPECT_TRUE(device->state().isConnected) << "one lost command is no lost board";
        EXPECT_TRUE(device->clearStop()) << "the next one goes through";
    }
    ASSERT_TRUE(device->clock().waitFor(1.0));
    EXPECT_FALSE(isArmed()) << "a release never arms";
    EXPECT_TRUE(device->arm());
}

TEST_P(ReleaseUnanswered, leavesAStopOfSomebodyElseThatComesBehindIt) {
    line->loss = GetParam();
    line->meanwhile = [this] {
        EXPECT_FALSE(isLatched()) << "the release itself was heard";
        stopFromElsewhere();
    };
    const auto released = device->clearStop();
    ASSERT_FALSE(released);
    EXPECT_EQ(released.error().code, ErrorCode::Protocol);
    EXPECT_EQ(board->firmware().safety.stop, HB_LATCH_COMMAND);
    EXPECT_FALSE(device->arm());
}

TEST_P(ReleaseUnanswered, leavesAFaultThatComesBehindItAndIsOverAgain) {
    line->loss = GetParam();
    line->meanwhile = [this] {
        board->breakReading(HtmHallReading, 1023.0);
        board->advanceTo(board->time_s() + 0.005);
        board->breakReading(HtmHallReading, 512.0);
    };
    const auto released = device->clearStop();
    ASSERT_FALSE(released);
    EXPECT_NE(board->firmware().safety.fault, HB_FAULT_NONE);
    EXPECT_NE(device->state().fault, 0U);
    EXPECT_FALSE(device->arm());
}

TEST_P(ReleaseOnce, changesNothingOnABoardThatIsArmed) {
    ASSERT_TRUE(device->clearStop());
    ASSERT_TRUE(device->arm());
    line->loss = GetParam();
    (void)device->clearStop();
    EXPECT_TRUE(isArmed());
    EXPECT_FALSE(isLatched());
}

INSTANTIATE_TEST_SUITE_P(Line, ReleaseOnce,
                         testing::Values(Loss::None, Loss::Command, Loss::Answer, Loss::AnswerLate),
                         nameOfLoss);
INSTANTIATE_TEST_SUITE_P(Line, ReleaseUnanswered, testing::Values(Loss::Answer, Loss::AnswerLate),
                         nameOfLoss);

} // namespace
} // namespace halbench::devices::xcp
