#include "devices/firmware/examples/minimal_board.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

/// The example of resources/help/firmware-guide.md does what the guide says.
class MinimalBoard : public testing::Test {
protected:
    MinimalBoard() { minimal_board_init(m_board.get()); }

    Octets command(const Octets& packet) {
        hb_xcp_receive(&m_board->xcp, packet.data(), static_cast<std::uint16_t>(packet.size()));
        std::uint8_t buffer[HB_MAX_DTO];
        const std::uint16_t length = hb_xcp_transmit(&m_board->xcp, buffer, sizeof buffer);
        return {buffer, buffer + length};
    }

    Octets writeLive(std::size_t offset, const Octets& octets) {
        Octets packet{
            0xED, static_cast<std::uint8_t>(octets.size()), 0, 0, static_cast<std::uint8_t>(offset), 0x80, 0,
            0};
        packet.insert(packet.end(), octets.begin(), octets.end());
        return command(packet);
    }

    float tick(float position_rad) { return minimal_board_tick(m_board.get(), position_rad); }

    std::unique_ptr<minimal_board> m_board = std::make_unique<minimal_board>();
};

TEST_F(MinimalBoard, describesItself) {
    command({0xFF, 0});
    const Octets model = command({0xFA, 1});
    EXPECT_EQ(std::string(model.begin() + 8, model.end()), "minimal");
    EXPECT_GT(BoardFixture::u32(command({0xFA, 4}), 4), 1000U);
}

TEST_F(MinimalBoard, drivesStopsAndStaysStopped) {
    command({0xFF, 0});
    EXPECT_EQ(writeLive(offsetof(minimal_live, mode), {2}), Accepted);
    EXPECT_EQ(writeLive(offsetof(minimal_live, arm), {1}), Accepted);
    EXPECT_EQ(tick(0.5F), -0.5F); // gain 1 A/rad, set-point 0
    EXPECT_EQ(tick(5.0F), -2.0F); // limit
    EXPECT_EQ(command({0xF1, 0x45}), (Octets{0xFF, HB_LATCH_COMMAND}));
    EXPECT_EQ(tick(0.5F), 0.0F);
    EXPECT_EQ(writeLive(offsetof(minimal_live, arm), {1}), refused(0x24));
    EXPECT_EQ(command({0xF1, 0x52}), (Octets{0xFF, HB_LATCH_NONE}));
    EXPECT_EQ(writeLive(offsetof(minimal_live, arm), {1}), Accepted);
}

TEST_F(MinimalBoard, stopsWhenItsMasterFallsSilent) {
    command({0xFF, 0});
    writeLive(offsetof(minimal_live, mode), {2});
    writeLive(offsetof(minimal_live, arm), {1});
    for (int i = 0; i < 999; ++i) {
        ASSERT_NE(tick(0.5F), 0.0F);
    }
    EXPECT_EQ(tick(0.5F), 0.0F);
    EXPECT_EQ(m_board->signals.status, HB_STATUS_WATCHDOG);
}

TEST_F(MinimalBoard, keepsItsWatchdogWhileItIsArmed) {
    command({0xFF, 0});
    writeLive(offsetof(minimal_live, mode), {2});
    writeLive(offsetof(minimal_live, arm), {1});
    EXPECT_EQ(writeLive(offsetof(minimal_live, watchdog_ms), {0, 0}), refused(0x22));
    EXPECT_EQ(m_board->live.watchdog_ms, 1000);
    EXPECT_EQ(writeLive(offsetof(minimal_live, watchdog_ms), {0x60, 0xEA}), Accepted);
    EXPECT_EQ(m_board->live.watchdog_ms, 2000) << "a longer one becomes the longest";
    EXPECT_EQ(writeLive(offsetof(minimal_live, arm), {0}), Accepted);
    EXPECT_EQ(writeLive(offsetof(minimal_live, watchdog_ms), {0, 0}), Accepted) << "nothing moves now";
}

TEST_F(MinimalBoard, putsOutNothingWhenItsSensorFails) {
    command({0xFF, 0});
    writeLive(offsetof(minimal_live, mode), {2});
    writeLive(offsetof(minimal_live, arm), {1});
    EXPECT_EQ(tick(NAN), 0.0F);
    EXPECT_EQ(tick(0.5F), 0.0F);
    EXPECT_EQ(m_board->signals.status, HB_STATUS_FAULT);
}

} // namespace
} // namespace halbench::devices::firmware
