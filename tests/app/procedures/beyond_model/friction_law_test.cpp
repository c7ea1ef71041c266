#include "app/procedures/identify/identify_friction_law.h"
#include "app/procedures/identify/identify_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

IdentifyFits fitsWithLoss(double loss_s2) {
    IdentifyFits fits;
    control::MotionFit motion;
    motion.damping_per_s = 2.0;
    motion.torqueLoss_s2 = loss_s2;
    motion.torqueLossError_s2 = 1e-7;
    motion.isTorqueLossFitted = true;
    motion.balances.resize(1);
    motion.balances.front().current_A = 4.0;
    motion.balances.front().balance_rad_s2 = 60.0; // settles at 30 rad/s
    control::BalanceFit balance;
    balance.torque_rad_s2_A = 25.0;
    fits.motion = motion;
    fits.balance = balance;
    return fits;
}

control::MotorRatios ratios() {
    using enum control::MotorConstant;
    control::MotorRatios all;
    all.ratios = {{Damping, Inertia, 2.0}, {Friction, Inertia, 40.0}, {Torque, Inertia, 25.0}};
    return all;
}

TEST(IdentifyFrictionLaw, theLossOfThePublishedBoardAddsNoError) {
    control::MotorRatios data = ratios();
    addLossAmbiguity(data, fitsWithLoss(3.9e-7));
    addLossAmbiguity(data, fitsWithLoss(6.0e-7)); // within three standard errors
    EXPECT_TRUE(data.errors.empty());
}

TEST(IdentifyFrictionLaw, aLossThatAWrongStrayFieldMayMakeIsAnErrorOfTorqueFrictionAndDamping) {
    control::MotorRatios data = ratios();
    addLossAmbiguity(data, fitsWithLoss(2.69e-6)); // 2e-6 beyond three standard errors
    ASSERT_EQ(data.errors.size(), 1u);
    const Eigen::MatrixXd& covariance = data.errors.front().covariance;
    // identification.md 5.1: angle 2 * 2e-6 * 30 / 0.8e-3 = 0.15 rad, half of its square 1.125 %
    EXPECT_NEAR(std::sqrt(covariance(2, 2)), 25.0 * 0.01125, 1e-9);
    EXPECT_GT(covariance(0, 0), 0.0);
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), 0.25 * 25.0 * 0.01125 * 4.0, 1e-9);
}

TEST(IdentifyJudge, anAsymmetryIsSaidOnlyWhereItsNumberMeansSomething) {
    IdentifyFits fits = fitsWithLoss(3.9e-7);
    fits.balance->friction_rad_s2 = 40.0;
    fits.balance->freedom = 20;
    fits.balance->asymmetryError = 1e-6;
    const auto messageFor = [&fits](double asymmetry) {
        fits.balance->asymmetry = asymmetry;
        for (const Finding& finding : judgeFits(fits, {}).quality.findings) {
            if (finding.code == "friction_asymmetry") {
                return finding.message;
            }
        }
        return std::string();
    };
    EXPECT_EQ(messageFor(2e-4), ""); // 0.0 %, less than the currents of two directions are known to
    EXPECT_NE(messageFor(-0.05).find("10.0 %"), std::string::npos); // (K+ - K-) over the mean of both
}

TEST(IdentifyMotion, leavesTheMotionBelowTheUsableSpeedOut) {
    IdentifyConfig config;
    config.usableSpeed_rad_s = 4.5;
    EXPECT_EQ(segmentConfigOf(config).slowest_rad_s, 4.5);
    IdentifyFits fits;
    ASSERT_TRUE(fitTransients({}, {}, {}, config, {}, fits));
    EXPECT_FALSE(fits.motion);
    EXPECT_FALSE(fits.motionProblem.empty());
}

TEST(IdentifyFrictionLaw, saysThatNoKnownLawFits) {
    IdentifyFits fits = fitsWithLoss(3.9e-7);
    fits.missing.isTaken = true;
    fits.missing.isAdequate = false;
    control::ExtraForceTerm term{control::ExtraForce::QuadraticDrag};
    term.value = -0.01; // a drag that drives: no motor has it
    term.freedom = 20.0;
    fits.missing.terms = {term};
    IdentifyResult result;
    judgeFrictionLaw(result, fits);
    EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
    ASSERT_EQ(result.quality.findings.size(), 2u);
    for (const Finding& finding : result.quality.findings) {
        EXPECT_EQ(finding.code, "friction_beyond_model");
    }
    EXPECT_TRUE(result.notes.empty());
}

} // namespace
} // namespace halbench::app
