#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

class RemarkingLine : public LoopbackTransport {
public:
    using LoopbackTransport::LoopbackTransport;
    std::optional<std::string> remarkOnStream(double packets_Hz, std::size_t octets) const override {
        return fmt::format("{} packets/s of {} octets", packets_Hz, octets);
    }
};

TEST(StreamRemark, tellsWhatTheLineSaysOfTheStreamBeforeItBegins) {
    auto board = makeSimulatedHtm({}, 1);
    ASSERT_TRUE(board);
    std::vector<std::string> said;
    XcpDeviceOptions options;
    options.onMessage = [&said](const std::string& text) { said.push_back(text); };
    const auto device = openXcpDevice(
        std::make_unique<RemarkingLine>(std::shared_ptr<SimulatedBoard>(std::move(*board)), false), options);
    ASSERT_TRUE(device) << device.error().message;
    said.clear();
    ASSERT_TRUE((*device)->startStream({{"position", "speed"}, 100.0}, [](const SampleBlockPtr&) {}));
    // Two values of four octets behind at most eight of identification and time stamp.
    EXPECT_EQ(said, std::vector<std::string>{"100 packets/s of 16 octets"});
}

} // namespace
} // namespace halbench::devices::xcp
