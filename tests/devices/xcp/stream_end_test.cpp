#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace halbench::devices::xcp {
namespace {

/// Stamps the samples later than the board does, on request.
class LateStamps : public LoopbackTransport {
public:
    explicit LateStamps(std::shared_ptr<SimulatedBoard> board) : LoopbackTransport(std::move(board), false) {}

    std::uint32_t late_us = 0;
    std::size_t samples = 0;

    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        Result<bool> received = LoopbackTransport::receive(packet, timeout_s);
        if (received && *received && packet.size() > 5 && packet[0] < 0xFC) { // PID, time stamp of 4 octets
            ++samples;
            std::uint32_t stamp = late_us;
            for (int i = 4; i >= 1; --i) {
                stamp += static_cast<std::uint32_t>(packet[static_cast<std::size_t>(i)]) << (8 * (i - 1));
            }
            for (int i = 1; i <= 4; ++i) {
                packet[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(stamp >> (8 * (i - 1)));
            }
        }
        return received;
    }
};

TEST(StreamEnd, rowsThatWaitForTheNextOnesAreDelivered) {
    auto made = SimulatedBoard::make({}, 1);
    ASSERT_TRUE(made);
    auto transport = std::make_unique<LateStamps>(std::shared_ptr<SimulatedBoard>(std::move(*made)));
    LateStamps* const line = transport.get();
    auto device = openXcpDevice(std::move(transport), {});
    ASSERT_TRUE(device) << device.error().message;
    Recording recording;
    ASSERT_TRUE((*device)->startStream({{"position"}, 100.0},
                                       [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE((*device)->clock().waitFor(0.5));
    EXPECT_EQ(recording.rows(), line->samples);
    line->late_us = 24000; // of rows 10 ms apart: late, or two are lost; the next ones would tell
    ASSERT_TRUE((*device)->clock().waitFor(0.025));
    const std::size_t samples = line->samples;
    ASSERT_LT(recording.rows(), samples) << "the case is the one meant";
    (*device)->stopStream();
    EXPECT_EQ(recording.rows(), samples);
}

TEST(StreamEnd, aDeviceThatIsClosedDeliversNothing) {
    auto made = SimulatedBoard::make({}, 1);
    ASSERT_TRUE(made);
    auto transport = std::make_unique<LateStamps>(std::shared_ptr<SimulatedBoard>(std::move(*made)));
    LateStamps* const line = transport.get();
    auto device = openXcpDevice(std::move(transport), {});
    ASSERT_TRUE(device);
    std::size_t rows = 0;
    ASSERT_TRUE((*device)->startStream({{"position"}, 100.0},
                                       [&](const SampleBlockPtr& block) { rows += block->rows(); }));
    ASSERT_TRUE((*device)->clock().waitFor(0.5));
    line->late_us = 24000;
    ASSERT_TRUE((*device)->clock().waitFor(0.025));
    const std::size_t before = rows;
    device->reset(); // whoever took the rows may be gone
    EXPECT_EQ(rows, before);
}

} // namespace
} // namespace halbench::devices::xcp
