#include "app/procedures/identify/identify_steady_line.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// A line that nothing can be said against.
IdentifyFits soundFits() {
    IdentifyFits fits;
    fits.sweep.emplace();
    fits.sweep->damping_A_s = 0.086;
    fits.sweep->friction_A = 1.43;
    fits.sweep->covariance = Eigen::Matrix2d::Identity() * 1e-8;
    fits.sweep->residualRms_rad_s = 0.5;
    fits.sweep->runs.probability = 0.5;
    return fits;
}

std::vector<std::string> codesOf(const IdentifyFits& fits) {
    IdentifyResult result;
    judgeSteadyLine(result, fits);
    EXPECT_EQ(result.quality.verdict == Verdict::Good, result.quality.findings.empty());
    std::vector<std::string> codes;
    for (const Finding& finding : result.quality.findings) {
        codes.push_back(finding.code);
    }
    return codes;
}

TEST(SteadyLine, aSoundOneHasNoFinding) {
    EXPECT_TRUE(codesOf(soundFits()).empty());
    EXPECT_TRUE(codesOf({}).empty()) << "no sweep";
}

TEST(SteadyLine, outliersMisfitsRunsAndPointsThatDecideAreNamed) {
    IdentifyFits fits = soundFits();
    fits.sweep->isRobustDifferent = true;
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"outliers"});
    fits = soundFits();
    fits.sweep->lackOfFit.emplace();
    fits.sweep->lackOfFit->probability = 1e-4;
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"model_inadequate"});
    fits = soundFits();
    fits.sweep->runs.probability = 1e-4;
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"residuals_in_runs"});
    fits = soundFits();
    fits.sweep->largestInfluence = 3.0;
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"one_point_decides"});
}

/// One code of a converter of 12 bit over 10 A is 2.4 mA: 0.02 rad/s times 0.086 A*s/rad is less.
TEST(SteadyLine, aMisfitBelowOneCodeIsNoFinding) {
    IdentifyFits fits = soundFits();
    fits.sweep->residualRms_rad_s = 0.02;
    fits.sweep->runs.probability = 1e-4;
    fits.sweep->lackOfFit.emplace();
    fits.sweep->lackOfFit->probability = 1e-4;
    EXPECT_TRUE(codesOf(fits).empty());
}

TEST(SteadyLine, plateausThatContradictTheMotionAreNamedByTheConstantThatDiffers) {
    IdentifyFits fits = soundFits();
    fits.sweep->freedom = 20;
    fits.points.resize(1);
    fits.points[0].current_A = 4.0;
    fits.motion.emplace();
    fits.balance.emplace();
    fits.balance->torque_rad_s2_A = 26.0;
    fits.balance->friction_rad_s2 = 1.43 * 26.0;
    fits.balance->scatterCovariance = Eigen::Matrix3d::Identity() * 1e-8;
    fits.motion->damping_per_s = 0.086 * 26.0;
    EXPECT_TRUE(codesOf(fits).empty());
    fits.balance->friction_rad_s2 = -1.17 * 26.0; // the plateaus of a clipped amplifier
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"steady_and_transient_disagree"});
    fits.balance->friction_rad_s2 = 1.43 * 26.0;
    fits.motion->damping_per_s = 0.115 * 26.0;
    EXPECT_EQ(codesOf(fits), std::vector<std::string>{"steady_and_transient_disagree"});
}

} // namespace
} // namespace halbench::app
