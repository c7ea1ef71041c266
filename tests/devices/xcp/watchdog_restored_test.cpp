#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices::xcp {
namespace {

// After a board is left disarmed its watchdog is what it was: a foreign program that says nothing for two
// seconds would lose its session.

/// Answers so many writes of the watchdog by itself, with an error; the board does not hear of them.
class RefusingLine : public LoopbackTransport {
public:
    explicit RefusingLine(std::shared_ptr<SimulatedBoard> board)
        : LoopbackTransport(std::move(board), false) {}

    int refusals = 0;

    Result<void> send(std::span<const std::uint8_t> packet) override {
        constexpr std::uint32_t Watchdog = 0x8000U + offsetof(hb_htm_live, board.watchdog_ms);
        const bool isMeant = packet.size() == 10 && packet[0] == 0xED && // SHORT_DOWNLOAD of two octets
                             packet[4] + 256U * packet[5] == Watchdog;
        if (isMeant && refusals > 0) {
            --refusals;
            m_answer = std::vector<std::uint8_t>{0xFE, 0x31}; // ERR_GENERIC
            return {};
        }
        return LoopbackTransport::send(packet);
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        if (m_answer) {
            packet = *std::exchange(m_answer, std::nullopt);
            return true;
        }
        return LoopbackTransport::receive(packet, timeout_s);
    }

private:
    std::optional<std::vector<std::uint8_t>> m_answer;
};

class WatchdogRestored : public testing::Test {
protected:
    void SetUp() override {
        auto made = makeSimulatedHtm({}, 1);
        ASSERT_TRUE(made);
        board = std::shared_ptr<SimulatedBoard>(std::move(*made));
        auto transport = std::make_unique<RefusingLine>(board);
        line = transport.get();
        XcpDeviceOptions options;
        options.onMessage = [this](const std::string& text) { said += text + '\n'; };
        auto opened = openXcpDevice(std::move(transport), options);
        ASSERT_TRUE(opened) << opened.error().message;
        device = std::move(*opened);
        ASSERT_TRUE(device->arm());
        ASSERT_EQ(watchdog_ms(), 1000);
    }
    int watchdog_ms() const { return htmFirmware(*board).live.board.watchdog_ms; }

    std::shared_ptr<SimulatedBoard> board;
    RefusingLine* line = nullptr;
    std::string said;
    std::unique_ptr<Device> device;
};

TEST_F(WatchdogRestored, isTriedAgainAfterARefusal) {
    line->refusals = 2;
    EXPECT_TRUE(device->disarm());
    EXPECT_EQ(watchdog_ms(), 0) << "as before";
    EXPECT_EQ(said, "");
}

TEST_F(WatchdogRestored, isTriedAgainWhenTheDeviceIsLeft) {
    line->refusals = 3;
    EXPECT_FALSE(device->disarm());
    EXPECT_EQ(watchdog_ms(), 1000);
    EXPECT_NE(said.find("hb.watchdog_ms of the device may still be 1000 instead of 0 ms"), std::string::npos)
        << said;
    device.reset();
    EXPECT_EQ(watchdog_ms(), 0);
}

TEST_F(WatchdogRestored, isToldWhenItFailsForGood) {
    line->refusals = 1000;
    device.reset(); // armed: left by a program that ends
    EXPECT_EQ(board->firmware().safety.armed, 0);
    EXPECT_NE(said.find("hb.watchdog_ms of the device may still be 1000 instead of 0 ms"), std::string::npos)
        << said;
}

} // namespace
} // namespace halbench::devices::xcp
