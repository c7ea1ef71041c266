// Random motors under random gains: what control/design says of the board's loop against the loop written out
// by states (own_loop.h).
#include "control/assess/load_step.h"
#include "control/base/units.h"
#include "control/design/optimal_designs.h"
#include "control/robustness/loop_batch.h"
#include "tests/control/routes/own_loop.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

// 1e-9: the polynomials of the loop multiply roots near z = 1, some three digits a root.
TEST(PositionRoutesSeeds, theOpenLoopIsThatOfTheStates) {
    Random random(301);
    for (int round = 0; round < 60; ++round) {
        const OwnLoop own = randomStableLoop(random);
        const auto loop = sampledOpenLoop(own.plant, own.gains, own.timing);
        ASSERT_TRUE(loop.has_value());
        const StateSpace states = own.open();
        const auto batch = LoopBatch::make({own.plant}, own.gains, own.timing);
        for (const double share : {0.02, 0.1, 0.5, 0.9}) {
            const double w = share * Pi / own.timing.period_s;
            const Complex z = boundaryPoint(states.timeBase, w);
            const Complex expected = valueAt(states, z);
            const double tolerance = 1e-9 + 100.0 * roundingOf(*loop, w);
            EXPECT_LT(std::abs(loop->atFrequency(w) / expected - 1.0), tolerance) << round;
            EXPECT_LT(std::abs(batch->loop(0, w) / expected - 1.0), 1e-9) << round;
        }
        // A radius near 1 of n poles near z = 1: the polynomial's roots keep fewer digits than eigenvalues.
        EXPECT_NEAR(poleRadius(*loop), own.poleRadius(), 1e-6) << round;
    }
}

TEST(PositionRoutesSeeds, stepsOfReferenceAndLoadAreThoseOfTheStates) {
    Random random(302);
    for (int round = 0; round < 40; ++round) {
        const OwnLoop own = randomStableLoop(random);
        const double duration_s = 200.0 * own.timing.period_s;
        const auto step = linearStep(own.plant, own.gains, own.timing, 0.7, duration_s, 5);
        const auto load = loadStep(own.plant, own.gains, own.timing, -0.4, duration_s, 5);
        ASSERT_TRUE(step && load) << round;
        const OwnLoop::Run ofStep = own.run(0.7, 0.0, 200, 5);
        const OwnLoop::Run ofLoad = own.run(0.0, -0.4, 200, 5);
        const double angle = 1e-10 * largest(ofStep.angle_rad); // rounding of a thousand products
        const double current = 1e-10 * largest(ofStep.current_A);
        for (std::size_t i = 0; i < ofStep.angle_rad.size(); ++i) {
            ASSERT_NEAR(step->response_rad[i], ofStep.angle_rad[i], angle) << round << ' ' << i;
            ASSERT_NEAR(step->current_A[i], ofStep.current_A[i], current) << round << ' ' << i;
            ASSERT_NEAR(load->angle_rad[i], ofLoad.angle_rad[i], 1e-10 * largest(ofLoad.angle_rad)) << round;
            ASSERT_NEAR(load->current_A[i], ofLoad.current_A[i], 1e-10 * largest(ofLoad.current_A)) << round;
        }
    }
}

/// Of independent errors of the measured angle: the mean of |C z^-d/(1 + L)|^2 over the circle, by the books'
/// formulas. Even points are exact for such a function but for its own impulse response after so many
/// samples.
double noiseByIntegral(const OwnLoop& own) {
    const double T = own.timing.period_s;
    const Eigen::Matrix3d M = own.motion(T);
    const auto points = static_cast<int>(40.0 / (1.0 - own.poleRadius()));
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        const Complex z = std::polar(1.0, 2.0 * Pi * (i + 0.5) / points);
        const Complex law = own.gains.proportional + T * own.gains.integral / (z - 1.0) +
                            own.gains.derivative / T * (z - 1.0) / z;
        const Complex given = law * std::pow(z, -own.timing.delay_samples);
        // (z - M)^-1 of the motor's triangular two by two, by hand.
        const Complex speed = M(1, 2) / (z - M(1, 1));
        const Complex angle = (M(0, 2) + M(0, 1) * speed) / (z - 1.0);
        sum += std::norm(given / (1.0 + given * angle));
    }
    return std::sqrt(sum / points);
}

// Lyapunov's equation against the integral over frequency.
TEST(PositionRoutes, theNoiseGainIsTheIntegralOverFrequency) {
    Random random(303);
    for (int round = 0; round < 40; ++round) {
        const OwnLoop own = randomStableLoop(random);
        const auto assessment =
            assessDesign(own.plant, own.gains, own.timing, 4.0, 10.0 * own.timing.period_s);
        ASSERT_TRUE(assessment.has_value());
        // 1e-9, and what the closed polynomial has lost where its slowest roots are.
        const TransferFunction loop = *sampledOpenLoop(own.plant, own.gains, own.timing);
        const auto closed = *feedback(loop, TransferFunction::gain(1.0, loop.timeBase()));
        const double slowest_rad_s = (1.0 - own.poleRadius()) / own.timing.period_s;
        EXPECT_NEAR(assessment->noiseGain_A_per_rad / noiseByIntegral(own), 1.0,
                    1e-9 + 100.0 * roundingOf(closed, slowest_rad_s))
            << round;
    }
}

TEST(PositionRoutesSeeds, theProofIsThatOfTheStates) {
    Random random(304);
    for (int round = 0; round < 40; ++round) {
        const OwnLoop own = randomStableLoop(random);
        const auto assessment =
            assessDesign(own.plant, own.gains, own.timing, 4.0, 200.0 * own.timing.period_s);
        ASSERT_TRUE(assessment.has_value());
        const StateSpace states = own.open();
        EXPECT_TRUE(assessment->isStable);
        EXPECT_NEAR(assessment->poleRadius, own.poleRadius(), 1e-6) << round; // as above
        OwnLoop later = own;
        later.timing.delay_samples += 1;
        EXPECT_NEAR(assessment->poleRadiusOneSampleLater, later.poleRadius(), 1e-6) << round;
        EXPECT_NEAR(assessment->peaks.Ms_ratio / largestMagnitude(sensitivityOf(states)), 1.0, 1e-8) << round;
        EXPECT_NEAR(assessment->peaks.Mt_ratio / largestMagnitude(complementOf(states)), 1.0, 1e-8) << round;
        const double peak_A = largest(own.run(1.0, 0.0, 201, 1).current_A);
        EXPECT_NEAR(assessment->peakCurrent_A / peak_A, 1.0, 1e-10) << round;
        EXPECT_NEAR(assessment->largestStep_rad * peak_A / 4.0, 1.0, 1e-10) << round;
        EXPECT_NEAR(assessment->fastGain_A_per_rad,
                    own.gains.proportional + own.gains.derivative / own.timing.period_s,
                    1e-12 * assessment->fastGain_A_per_rad);
        // The limit of K_P: stable just below, not just above, without integral action.
        OwnLoop edge = own;
        edge.gains.integral = 0.0;
        edge.gains.proportional = assessment->proportionalLimit_A_per_rad * (1.0 - 1e-5);
        EXPECT_LE(edge.poleRadius(), 1.0 + 1e-9) << round;
        edge.gains.proportional = assessment->proportionalLimit_A_per_rad * (1.0 + 1e-5);
        EXPECT_GT(edge.poleRadius(), 1.0) << round;
    }
}

// The measure is a sum over the samples: of the states' own run to 1e-9, of the integral between them to half
// a sample of everything that the error moves.
TEST(PositionRoutes, theErrorsOfALoadAreTheSumsOfTheStatesAndNearlyTheIntegrals) {
    Random random(305);
    for (int round = 0; round < 40; ++round) {
        const OwnLoop own = randomStableLoop(random);
        constexpr int Samples = 400;
        constexpr int Points = 20;
        const double T = own.timing.period_s;
        const OwnLoop::Run run = own.run(0.0, 1.0, Samples + 1, Points);
        double iae = 0.0;
        double itae = 0.0;
        for (int k = 0; k <= Samples; ++k) {
            const double error = std::abs(run.sample_rad[static_cast<std::size_t>(k)]);
            iae += T * error;
            itae += T * error * k * T;
        }
        const auto found = loadError(own.plant, own.gains, own.timing, ErrorMeasure::Iae, Samples * T);
        const auto timed = loadError(own.plant, own.gains, own.timing, ErrorMeasure::Itae, Samples * T);
        ASSERT_TRUE(found && timed) << round;
        EXPECT_NEAR(*found / iae, 1.0, 1e-8) << round;
        EXPECT_NEAR(*timed / itae, 1.0, 1e-8) << round;
        double integral = 0.0;
        double way = 0.0;
        for (std::size_t i = 1; i < static_cast<std::size_t>(Samples * Points); ++i) {
            integral += 0.5 * T / Points * (std::abs(run.angle_rad[i - 1]) + std::abs(run.angle_rad[i]));
            way += std::abs(std::abs(run.angle_rad[i]) - std::abs(run.angle_rad[i - 1]));
        }
        EXPECT_NEAR(*found, integral, T * (way + std::abs(run.sample_rad.back()))) << round;
    }
}

// Loops with integral action whose error keeps its sign: sum of T e K_I is the current that holds the load.
TEST(PositionRoutesSeeds, anErrorWithoutASwingSumsUpToTheInverseOfTheIntegralGain) {
    Random random(306);
    int calm = 0;
    for (int round = 0; round < 200; ++round) {
        OwnLoop own = randomStableLoop(random);
        own.gains.integral *= 0.2;
        if (own.gains.integral == 0.0 || own.poleRadius() > 1.0 - 1e-3) {
            continue;
        }
        const auto samples = static_cast<int>(std::ceil(30.0 / (1.0 - own.poleRadius())));
        const OwnLoop::Run run = own.run(0.0, 1.0, samples, 1);
        if (*std::min_element(run.sample_rad.begin(), run.sample_rad.end()) < -1e-12) {
            continue;
        }
        const auto iae =
            loadError(own.plant, own.gains, own.timing, ErrorMeasure::Iae, samples * own.timing.period_s);
        EXPECT_NEAR(*iae * own.gains.integral, 1.0, 1e-8) << round; // exp(-30) is left
        ++calm;
    }
    EXPECT_GT(calm, 10);
}

} // namespace
} // namespace halbench::control
