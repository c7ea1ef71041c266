#include "devices/xcp/xcp_device.h"
#include "tests/devices/transport/virtual_line.h"
#include "tests/memory_in_use.h"

#include <cmath>

namespace halbench::devices {
namespace {

/// An hour of device time on a line that loses and delays: armed, streaming, written to every second.
TEST(LineSoak, anHourOnABadLineLosesNoSessionCountsEveryGapAndKeepsNoMemory) {
    constexpr int Seconds = 3600;
    constexpr double Rate_Hz = 500.0;
    auto line = std::make_unique<VirtualLine>("seed=1", LineFaults{0.002, 0.0, 0.005}, 5);
    const VirtualLine& watched = *line;
    const auto device = openXcpDevice(std::move(line), {});
    ASSERT_TRUE(device) << device.error().message;
    std::uint64_t rows = 0;
    std::uint64_t lost = 0;
    double first_s = -1.0;
    double last_s = 0.0;
    ASSERT_TRUE(
        (*device)->startStream({{"position", "hall.a", "status"}, Rate_Hz}, [&](const SampleBlockPtr& block) {
            rows += block->rows();
            lost += block->lostRows;
            first_s = first_s < 0.0 ? block->time_s.front() : first_s;
            last_s = block->time_s.back();
        }));
    ASSERT_TRUE((*device)->arm());
    double before_MB = 0.0;
    for (int second = 0; second < Seconds; ++second) {
        const auto waited = (*device)->clock().waitFor(1.0);
        ASSERT_TRUE(waited) << second << ": " << waited.error().message;
        const ParameterValue gain[] = {{"gain.kp", 8.0 + second % 5}};
        const auto written = (*device)->writeParameters(gain);
        ASSERT_TRUE(written) << second << ": " << written.error().message;
        if (second == Seconds / 10) {
            before_MB = memoryInUse_MB();
        }
    }
    EXPECT_TRUE((*device)->state().isArmed);
    // 200 MB of samples pass: what kept one octet in a hundred of them would show.
    EXPECT_LT(memoryInUse_MB() - before_MB, 2.0);
    const auto span = static_cast<std::uint64_t>(std::llround((last_s - first_s) * Rate_Hz)) + 1;
    EXPECT_EQ(rows + lost, span);
    EXPECT_GT(lost, span / 1000) << "2 in a thousand are lost on average";
    EXPECT_GT(watched.traffic().dropped, 0U);
}

} // namespace
} // namespace halbench::devices
