#include "tests/app/actuators/spherical/simulated_sphere.h"

namespace halbench::app {
namespace {

TEST(SensingCoverageNight, intervalsHoldTheTruthIn92To98PercentOf200Seeds) {
    const SphereCoverage coverage = sphereCoverage(200);
    EXPECT_GE(coverage.ratio(), 0.92);
    EXPECT_LE(coverage.ratio(), 0.98);
    EXPECT_GE(coverage.coneBefore, 0.92);
    EXPECT_GE(coverage.coneAfter, 0.92);
}

} // namespace
} // namespace halbench::app
