#include "tests/app/actuators/planar/coverage/platen_coverage.h"

namespace halbench::app {
namespace {

// Of n intervals of 95 % at least `least` hold the truth, or the run is refused. Binomial probability that a
// correct estimator passes for all 14 constants: 30 of 30 seeds, 24 and more: 0.9995 each; of 8, 5 and more:
// 0.9996 each. All of them happen often, so bloated intervals are for the night to find.
void expectCovered(const PlatenCoverage& coverage, int runs, int least) {
    EXPECT_EQ(coverage.runs, runs);
    EXPECT_LE(coverage.refused, runs / 10);
    for (const auto& [name, covered] : coverage.covered) {
        EXPECT_GE(covered + coverage.refused, least) << name;
    }
}

TEST(PlatenCoverage, intervalsHoldThePublishedMachineForSeeds1To30) {
    expectCovered(countPlatenCoverage(1, 30, "", models::PlanarParameters{}), 30, 24);
}

TEST(PlatenCoverage, intervalsHoldAHeavierMachine) {
    expectCovered(countPlatenCoverage(101, 108, "&m=0.9", heavyMachine()), 8, 5);
}

TEST(PlatenCoverage, intervalsHoldTheRealisticInertia) {
    expectCovered(countPlatenCoverage(201, 208, "&Iz=0.0027", realisticInertia()), 8, 5);
}

TEST(PlatenCoverage, intervalsHoldForcesThatAre15PercentStronger) {
    expectCovered(countPlatenCoverage(301, 308, "&mu0M0=0.82225", strongMagnets()), 8, 5);
}

} // namespace
} // namespace halbench::app
