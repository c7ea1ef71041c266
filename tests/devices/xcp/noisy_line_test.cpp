#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices {
namespace {

/// Gate 4 of resources/help/protocol.md on a line that loses one packet in a hundred in each direction.
class NoisyLine : public testing::TestWithParam<std::uint64_t> {};

TEST_P(NoisyLine, armedForAMinuteWithoutLossOfSessionAndEveryGapCounted) {
    auto board = makeSimulatedHtm({}, 1);
    ASSERT_TRUE(board);
    const auto faults = std::make_shared<LinkFaults>();
    auto device =
        openXcpDevice(std::make_unique<FaultTransport>(
                          std::make_unique<LoopbackTransport>(*std::move(board), false), faults, GetParam()),
                      {});
    ASSERT_TRUE(device) << device.error().message;
    faults->dropReceived_ratio = 0.01;
    faults->dropSent_ratio = 0.01;

    std::uint64_t lostRows = 0;
    std::vector<double> time_s;
    ASSERT_TRUE((*device)->startStream({{"position", "hall.a"}, 100.0}, [&](const SampleBlockPtr& block) {
        lostRows += block->lostRows;
        time_s.insert(time_s.end(), block->time_s.begin(), block->time_s.end());
        for (const double value : block->values) {
            EXPECT_LT(std::abs(value), 0.2) << "at rest: an angle below 0.02 rad, a field below 0.16 T";
        }
    }));
    ASSERT_TRUE((*device)->arm());
    const auto waited = (*device)->clock().waitFor(60.0);
    ASSERT_TRUE(waited) << waited.error().message;
    EXPECT_TRUE((*device)->state().isArmed) << "the watchdog of 1 s was fed all the time";
    EXPECT_GT(faults->dropped, 30U);

    // Time tells every row that is missing: what came and what was counted as lost fill the axis without a
    // hole.
    ASSERT_FALSE(time_s.empty());
    const auto span = static_cast<std::uint64_t>(std::llround((time_s.back() - time_s.front()) * 100.0)) + 1;
    EXPECT_EQ(time_s.size() + lostRows, span);
    EXPECT_GT(lostRows, 20U);
    EXPECT_GE(span, 5990U);
    EXPECT_TRUE((*device)->disarm());
}

INSTANTIATE_TEST_SUITE_P(Seeds, NoisyLine, testing::Values(1, 2, 3, 4, 5));

} // namespace
} // namespace halbench::devices
