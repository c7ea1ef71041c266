#include "tests/app/actuators/planar/coverage/platen_coverage.h"

namespace halbench::app {
namespace {

// Acceptance of the identification: 92 to 98 % of 200 seeds for each constant. 95 % has a standard deviation
// of 3.1 of 200; the limits 180 and 199 are 3 of them away, so that one of 14 constants fails by chance in
// fewer than 2 % of the nights, and the mean of all constants keeps to 92 to 98 %.
void expectCovered(const PlatenCoverage& coverage, int runs) {
    EXPECT_EQ(coverage.runs, runs);
    EXPECT_LE(coverage.refused, runs / 20);
    const int judged = coverage.runs - coverage.refused;
    double sum = 0.0;
    for (const auto& [name, covered] : coverage.covered) {
        EXPECT_GE(covered, 0.90 * judged) << name;
        EXPECT_LE(covered, 0.995 * judged) << name;
        sum += static_cast<double>(covered) / judged / static_cast<double>(coverage.covered.size());
    }
    EXPECT_GE(sum, 0.92);
    EXPECT_LE(sum, 0.98);
}

TEST(PlatenCoverage, intervalsHoldThePublishedMachineIn92To98PercentOfSeeds1To200) {
    expectCovered(countPlatenCoverage(1, 200, "", models::PlanarParameters{}), 200);
}

TEST(PlatenCoverage, intervalsHoldAHeavierMachine) {
    expectCovered(countPlatenCoverage(1001, 1200, "&m=0.9", heavyMachine()), 200);
}

TEST(PlatenCoverage, intervalsHoldTheRealisticInertia) {
    expectCovered(countPlatenCoverage(2001, 2200, "&Iz=0.0027", realisticInertia()), 200);
}

TEST(PlatenCoverage, intervalsHoldForcesThatAre15PercentStronger) {
    expectCovered(countPlatenCoverage(3001, 3200, "&mu0M0=0.82225", strongMagnets()), 200);
}

} // namespace
} // namespace halbench::app
