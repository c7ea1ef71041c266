#include "app/procedures/identify/identify_procedure.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/transport/virtual_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

struct Line {
    devices::LineFaults faults;
    std::uint64_t seed;
};

void PrintTo(const Line& line, std::ostream* stream) {
    *stream << "drop " << line.faults.drop_ratio << ", corrupt " << line.faults.corrupt_ratio << ", latency "
            << line.faults.latency_s << " s, seed " << line.seed;
}

/// An identification over the lines that `halbench serve --drop --corrupt --latency-ms` offers: right within
/// its interval, or refused, or ended by a lost link; never wrong without a word.
class LossyLine : public testing::TestWithParam<Line> {};

void expectRight(const char* name, const control::Estimate& estimate, double truth) {
    if (!estimate.interval95) {
        return; // not identifiable is an answer too
    }
    const auto [low, high] = *estimate.interval95;
    // Three standard errors, so that of all these intervals of 95 % none misses by chance.
    EXPECT_LT(std::fabs(*estimate.value - truth), 1.53 * 0.5 * (high - low))
        << name << " " << *estimate.value << " [" << low << ", " << high << "]";
}

TEST_P(LossyLine, identificationIsRightWithinItsIntervalOrRefused) {
    const auto device = devices::openXcpDevice(
        std::make_unique<devices::VirtualLine>("seed=1", GetParam().faults, GetParam().seed), {});
    if (!device) {
        EXPECT_FALSE(device.error().message.empty() || device.error().hint.empty());
        return;
    }
    IdentifyConfig config;
    config.given.inertia_kg_m2 = 5.5e-4;
    config.sweep = {2.0, 4.0, 0.5};
    const auto result = runIdentify(**device, config, {});
    // One message in a hundred is what a line may do to a board that is armed (resources/help/protocol.md).
    const bool mustSucceed = GetParam().faults.corrupt_ratio == 0.0 && GetParam().faults.drop_ratio <= 0.01;
    if (!result) {
        EXPECT_FALSE(mustSucceed) << result.error().message;
        RecordProperty("outcome", result.error().message);
        EXPECT_FALSE(result.error().message.empty() || result.error().hint.empty());
        return;
    }
    RecordProperty("outcome", std::string(verdictName(result->quality.verdict)));
    if (result->quality.verdict == Verdict::Refused) {
        EXPECT_FALSE(mustSucceed);
        EXPECT_FALSE(result->quality.findings.empty());
        return;
    }
    expectRight("damping", result->viscousDamping, 1.23e-3);
    expectRight("friction", result->coulombFriction, 2.05e-2);
    expectRight("torque", result->torqueConstant, 1.43e-2);
}

INSTANTIATE_TEST_SUITE_P(Served, LossyLine,
                         testing::Values(Line{{0.0, 0.0, 0.020}, 1}, Line{{0.01, 0.0, 0.0}, 1},
                                         Line{{0.01, 0.0, 0.020}, 2}, Line{{0.0, 0.001, 0.0}, 1},
                                         Line{{0.0, 0.001, 0.0}, 2}, Line{{0.01, 0.001, 0.020}, 1},
                                         Line{{0.01, 0.001, 0.020}, 2}, Line{{0.01, 0.001, 0.020}, 3},
                                         Line{{0.05, 0.0, 0.0}, 1}, Line{{0.0, 0.01, 0.0}, 1},
                                         Line{{0.2, 0.0, 0.0}, 1}, Line{{1.0, 0.0, 0.0}, 1}));

} // namespace
} // namespace halbench::app
