#include "control/analysis/nyquist.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/design/optimal_designs.h"
#include "control/lti/eigenvalues.h"
#include "control/lti/riccati.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr double Limit_A = 4.0;

PidGains gains(double kp, double ki, double kd) {
    PidGains result;
    result.proportional = kp;
    result.integral = ki;
    result.derivative = kd;
    return result;
}

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    Eigen::MatrixXd result(rows, cols);
    for (double& value : result.reshaped()) {
        value = random.gaussian();
    }
    return result;
}

// x = a^2 x - a^2 b^2 x^2/(r + b^2 x) + q with a = b = q = r = 1: x^2 = x + 1, the golden ratio.
TEST(Riccati, theScalarAnswerIsTheGoldenRatio) {
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
    EXPECT_NEAR((*solveRiccati(one, one, one, one))(0, 0), 0.5 * (1.0 + std::sqrt(5.0)), 1e-14);
}

TEST(Riccati, solvesItsEquationAndStabilises) {
    Random random(61);
    for (int round = 0; round < 30; ++round) {
        const auto n = static_cast<Eigen::Index>(1 + random.below(6));
        const Eigen::MatrixXd A = randomMatrix(random, n, n);
        const Eigen::MatrixXd B = randomMatrix(random, n, 2);
        const Eigen::MatrixXd root = randomMatrix(random, n, n);
        const Eigen::MatrixXd Q = root * root.transpose();
        const Eigen::MatrixXd R = Eigen::Vector2d(0.5, 2.0).asDiagonal();
        const auto X = solveRiccati(A, B, Q, R);
        ASSERT_TRUE(X.has_value());
        const Eigen::MatrixXd K = *regulatorGain(A, B, Q, R);
        const Eigen::MatrixXd rest = A.transpose() * *X * (A - B * K) + Q - *X;
        EXPECT_LT(rest.norm(), 1e-9 * X->norm());
        for (const auto& pole : eigenvalues(A - B * K)) {
            EXPECT_LT(std::abs(pole), 1.0);
        }
    }
}

TEST(Riccati, refusesWhatNoInputReaches) {
    const Eigen::MatrixXd A = 1.1 * Eigen::MatrixXd::Identity(1, 1);
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
    EXPECT_EQ(solveRiccati(A, 0.0 * one, one, one).error().code, ErrorCode::Refused);
    EXPECT_EQ(solveRiccati(A, one, one, -one).error().code, ErrorCode::InvalidInput);
}

TEST(Lyapunov, solvesItsEquation) {
    Random random(62);
    const Eigen::MatrixXd A = 0.3 * randomMatrix(random, 4, 4);
    const Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(4, 4);
    const Eigen::MatrixXd X = solveLyapunov(A, Q);
    EXPECT_LT((A * X * A.transpose() + Q - X).norm(), 1e-12 * X.norm());
}

// help: htm-theory.md 8.4: crossover 45.7 rad/s, phase margin 37.9 deg, gain margin 4.2, pole radius 0.984
// with and without a sample of delay, fast gain 180 A/rad.
TEST(LoopAssessment, ofTheRecommendedGainsSaysWhatTheTheorySays) {
    const auto assessment = assessDesign(published(), gains(40.0, 60.0, 1.4), NoDelay, Limit_A);
    ASSERT_TRUE(assessment.has_value());
    EXPECT_TRUE(assessment->isStable);
    // One unit of the last digit shown.
    EXPECT_NEAR(assessment->margins.gainCrossover_rad_s.value(), 45.7, 0.1);
    EXPECT_NEAR(assessment->margins.phaseMargin_deg, 37.9, 0.1);
    EXPECT_NEAR(assessment->margins.gainMargin_ratio, 4.2, 0.1);
    EXPECT_NEAR(assessment->poleRadius, 0.984, 0.001);
    EXPECT_NEAR(assessment->poleRadiusOneSampleLater, 0.984, 0.001);
    EXPECT_NEAR(assessment->fastGain_A_per_rad, 180.0, 1e-9);
    EXPECT_NEAR(assessment->peaks.Ms_ratio * assessment->margins.modulusMargin, 1.0, 1e-12);
    EXPECT_NEAR(assessment->largestStep_rad * assessment->peakCurrent_A, Limit_A, 1e-12);
    EXPECT_NEAR(assessment->peakCurrent_A, 40.0, 1e-9); // K_P at the first sample
    EXPECT_NEAR(
        assessDesign(published(), gains(10.0, 0.1, 0.0), NoDelay, Limit_A)->proportionalLimit_A_per_rad,
        17.27, 0.01);
}

// Second route: the loop run on white errors of the angle, 2e5 of them (0.5 % of counting).
TEST(LoopAssessment, theNoiseGainIsThatOfASimulation) {
    const PidGains pid = gains(40.0, 60.0, 1.4);
    for (const int delay : {0, 1}) {
        const LoopTiming timing{0.01, delay};
        const auto assessment = assessDesign(published(), pid, timing, Limit_A);
        const TransferFunction plant = sampledPlant(published(), 0.01);
        const StateSpace motor = toStateSpace(plant);
        Random random(63);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(2);
        double integral = 0.0;
        double last = 0.0;
        double pending = 0.0;
        double squares = 0.0;
        constexpr int Samples = 200000;
        for (int k = 0; k < Samples; ++k) {
            const double measured = (motor.C * x).value() + random.gaussian();
            const double asked = -40.0 * measured + integral - 1.4 * (measured - last) / 0.01;
            integral -= 0.01 * 60.0 * measured;
            last = measured;
            const double given = delay == 0 ? asked : pending;
            pending = asked;
            squares += given * given;
            x = (motor.A * x + motor.B * given).eval();
        }
        // Twice the counting error; to ten digits in PositionRoutes.
        EXPECT_NEAR(assessment->noiseGain_A_per_rad / std::sqrt(squares / Samples), 1.0, 0.01) << delay;
    }
}

TEST(LoopAssessment, ofAnUnstableLoopIsGivenAllTheSame) {
    const auto assessment = assessDesign(published(), gains(18.0, 0.1, 0.0), NoDelay, Limit_A);
    ASSERT_TRUE(assessment.has_value());
    EXPECT_FALSE(assessment->isStable);
    EXPECT_TRUE(std::isinf(assessment->noiseGain_A_per_rad));
    EXPECT_EQ(assessDesign(published(), gains(1.0, 0.0, 0.0), NoDelay, 0.0).error().code,
              ErrorCode::OutOfRange);
}

TEST(Regulator, isStableInTheBoardsLoopAndSpendsWhatItMay) {
    RegulatorTargets targets{0.02, 0.02, 1.0};
    const auto design = designRegulator(published(), NoDelay, targets, Limit_A);
    ASSERT_TRUE(design.has_value());
    EXPECT_TRUE(design->assessment.isStable);
    EXPECT_GT(design->gains.proportional, 0.0);
    EXPECT_GT(design->gains.integral, 0.0);
    EXPECT_GT(design->gains.derivative, 0.0);
    EXPECT_GT(design->assessment.margins.phaseMargin_deg,
              40.0); // 60 deg of the continuous regulator less the sampling
    EXPECT_EQ(nyquist(*sampledOpenLoop(published(), design->gains, NoDelay))->unstableClosedLoopPoles, 0);
    // Asking for less angle per current makes it faster.
    targets.angle_rad = 0.01;
    const auto faster = designRegulator(published(), NoDelay, targets, Limit_A);
    EXPECT_GT(*faster->assessment.margins.gainCrossover_rad_s,
              *design->assessment.margins.gainCrossover_rad_s);
    targets.integral_rad_s.reset();
    EXPECT_EQ(designRegulator(published(), NoDelay, targets, Limit_A)->gains.integral, 0.0);
}

// As continuous theory has it for 1/s^2 with K = (k1, k2): damping 1/sqrt 2 when only angle and current are
// weighed.
TEST(Regulator, ofADoubleIntegratorHasTheDampingOfTheTheory) {
    const PositionPlant free{0.0, 26.0, 0.0};
    const LoopTiming fast{1e-4, 0};
    const auto design = designRegulator(free, fast, {0.02, {}, 1.0}, Limit_A);
    ASSERT_TRUE(design.has_value());
    const double w = std::sqrt(26.0 * design->gains.proportional);
    EXPECT_NEAR(design->gains.proportional, 1.0 / 0.02, 0.05 * 50.0); // sqrt(q/r), less what sampling takes
    EXPECT_NEAR(26.0 * design->gains.derivative / (2.0 * w), std::sqrt(0.5), 0.01);
}

TEST(Regulator, refusesWhatTheBoardsDelayMakesUnstable) {
    EXPECT_EQ(designRegulator(published(), {0.01, 2}, {1e-4, {}, 4.0}, Limit_A).error().code,
              ErrorCode::Refused);
    EXPECT_EQ(designRegulator(published(), NoDelay, {0.0, {}, 1.0}, Limit_A).error().code,
              ErrorCode::OutOfRange);
}

// A loop of integral action has int e = -1/K_I per unit of load; without overshoot that is the IAE itself.
TEST(LoadError, ofACalmLoopIsTheInverseOfTheIntegralGain) {
    const auto iae = loadError(published(), gains(20.0, 10.0, 1.4), NoDelay, ErrorMeasure::Iae, 40.0);
    ASSERT_TRUE(iae.has_value());
    // exp(-0.5 x 40) is left; the rest is the little that it swings over. Without a swing: PositionRoutes.
    EXPECT_NEAR(*iae, 0.1, 0.002);
}

TEST(LeastError, meetsMsAndBeatsItsNeighbours) {
    for (const double Ms : {1.4, 1.8}) {
        const LeastErrorTargets targets{ErrorMeasure::Iae, Ms, {}};
        const auto design = designLeastError(published(), NoDelay, targets, Limit_A);
        ASSERT_TRUE(design.has_value());
        EXPECT_LE(design->assessment.peaks.Ms_ratio, 1.005 * Ms);
        EXPECT_TRUE(design->assessment.isStable);
        const double best = *loadError(published(), design->gains, NoDelay, ErrorMeasure::Iae, 10.0);
        // No gains in a grid of steps of 7 % around it are better by more than 2 % and within Ms.
        for (int i = 0; i < 27; ++i) {
            const PidGains near = gains(design->gains.proportional * std::pow(1.07, i % 3 - 1),
                                        design->gains.integral * std::pow(1.07, i / 3 % 3 - 1),
                                        design->gains.derivative * std::pow(1.07, i / 9 - 1));
            if (sensitivityPeaks(*sampledOpenLoop(published(), near, NoDelay)).Ms_ratio <= Ms) {
                EXPECT_GT(*loadError(published(), near, NoDelay, ErrorMeasure::Iae, 10.0), 0.98 * best) << i;
            }
        }
    }
}

TEST(LeastError, keepsToTheCurrentLimitAndPunishesWhatLasts) {
    LeastErrorTargets targets{ErrorMeasure::Itae, 1.7, 0.5};
    const auto limited = designLeastError(published(), NoDelay, targets, Limit_A);
    ASSERT_TRUE(limited.has_value());
    EXPECT_LE(limited->gains.proportional * 0.5, 1.01 * Limit_A);
    targets.step_rad.reset();
    const auto open = designLeastError(published(), NoDelay, targets, Limit_A);
    EXPECT_GT(open->gains.proportional, 2.0 * limited->gains.proportional);
    targets.mostMs_ratio = 0.9;
    EXPECT_EQ(designLeastError(published(), NoDelay, targets, Limit_A).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
