#include "tests/app/actuators/spherical/simulated_sphere.h"

namespace halbench::app {
namespace {

// 30 specimens of 37 values; those of one kind belong together in part.
TEST(SensingCoverage, intervalsAndConesHoldTheTruth) {
    const SphereCoverage coverage = sphereCoverage(30);
    RecordProperty("intervals", fmt::format("{:.3f}", coverage.ratio()));
    RecordProperty("cones_before", fmt::format("{:.3f}", coverage.coneBefore));
    RecordProperty("cones_after", fmt::format("{:.3f}", coverage.coneAfter));
    RecordProperty("worst_deg", fmt::format("{:.3f}", coverage.worstAfter_deg));
    EXPECT_GE(coverage.ratio(), 0.92);
    EXPECT_LE(coverage.ratio(), 0.985);
    EXPECT_GE(coverage.coneBefore, 0.92);
    EXPECT_GE(coverage.coneAfter, 0.92);
    EXPECT_LT(coverage.worstAfter_deg, 0.4); // places of 0.1 mm: 0.11 degrees rms, three times that at most
}

} // namespace
} // namespace halbench::app
