#include "control/base/units.h"
#include "control/lti/frequency_response.h"
#include "control/robustness/robustness.h"
#include "control/robustness/uncertainty_bands.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

/// The published motor with its gain k known to 10 %.
std::vector<PositionPlant> plants(double deviation_ratio) {
    UncertainPlant uncertain;
    uncertain.mean = Eigen::Vector3d(1.23e-3 / 5.5e-4, 26.0, 1.434);
    uncertain.covariance = Eigen::Vector3d(0.0, std::pow(26.0 * deviation_ratio, 2), 0.0).asDiagonal();
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    return *drawPlants(uncertain, 4000, Random(1));
}

// The magnitude is proportional to k: 5 % of the motors lie 1.645 deviations below, 5 % above; the phase does
// not depend on it.
TEST(UncertaintyBands, ofTheOpenLoopAreThoseOfTheGain) {
    const auto frequencies = logarithmicFrequencies(0.5, 300.0, 40);
    const auto bands = loopBands(plants(0.1), recommended(), NoDelay, frequencies);
    ASSERT_TRUE(bands.has_value());
    const auto nominal = *frequencyResponse(
        *sampledOpenLoop({1.23e-3 / 5.5e-4, 26.0, 0.0}, recommended(), NoDelay), frequencies);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        // 4000 draws know the percentile to 0.033 deviations; three of them are 0.1 dB.
        EXPECT_NEAR(bands->magnitude_dB.p5[i] - magnitude_dB(nominal)[i], 20.0 * std::log10(1.0 - 0.1645),
                    0.1);
        EXPECT_NEAR(bands->magnitude_dB.p95[i] - magnitude_dB(nominal)[i], 20.0 * std::log10(1.0 + 0.1645),
                    0.1);
        // Near z = 1 the multiplied polynomials of the whole loop keep some ten digits.
        EXPECT_NEAR(bands->phase_deg.p5[i], phase_deg(nominal)[i], 1e-6);
        EXPECT_NEAR(bands->phase_deg.p95[i], phase_deg(nominal)[i], 1e-6);
    }
}

TEST(UncertaintyBands, ofTheStepHoldNineTenthsOfTheMotorsAtEachInstant) {
    const auto drawn = plants(0.1);
    const auto band = stepBand(drawn, recommended(), NoDelay, 1.0, 0.5);
    ASSERT_TRUE(band.has_value());
    for (const std::size_t i : {5u, 10u, 20u, 40u}) {
        int inside = 0;
        for (const PositionPlant& plant : drawn) {
            const double y = linearStep(plant, recommended(), NoDelay, 1.0, 0.5, 1)->response_rad[i];
            inside += y >= band->response_rad.p5[i] && y <= band->response_rad.p95[i] ? 1 : 0;
        }
        EXPECT_NEAR(inside / 4000.0, 0.9, 0.001); // two or four of 4000: the ranks at both ends
    }
}

TEST(UncertaintyBands, ofAMotorKnownExactlyHaveNoWidth) {
    const auto band = stepBand(plants(0.0), recommended(), NoDelay, 1.0, 0.2);
    ASSERT_TRUE(band.has_value());
    EXPECT_EQ(band->response_rad.p5, band->response_rad.p95);
}

TEST(UncertaintyBands, leaveOutWhatIsNoMotorAndRefuseWhenNoneIsLeft) {
    const std::vector<PositionPlant> none = {{2.0, -1.0, 0.0}};
    EXPECT_EQ(loopBands(none, recommended(), NoDelay, {1.0, 2.0}).error().code, ErrorCode::Refused);
    EXPECT_EQ(stepBand(none, recommended(), NoDelay, 1.0, 0.2).error().code, ErrorCode::Refused);
    const std::vector<PositionPlant> one = {{2.0, -1.0, 0.0}, {2.0, 26.0, 0.0}};
    EXPECT_TRUE(loopBands(one, recommended(), NoDelay, {1.0, 2.0}).has_value());
    EXPECT_EQ(loopBands(one, recommended(), NoDelay, {1.0, 4000.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(stepBand(one, recommended(), NoDelay, 0.0, 0.2).error().code, ErrorCode::OutOfRange);
}

/// Percentile of the nearest rank, sorted.
double ranked(std::vector<double> values, double share_ratio) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::ceil(share_ratio * static_cast<double>(values.size()))) - 1];
}

std::vector<PositionPlant> uncertainInAll(double deviation_ratio) {
    UncertainPlant uncertain;
    uncertain.mean = Eigen::Vector3d(1.23e-3 / 5.5e-4, 26.0, 1.434);
    uncertain.covariance = (deviation_ratio * uncertain.mean).cwiseAbs2().asDiagonal();
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), p(2)}; };
    return *drawPlants(uncertain, 1000, Random(2));
}

// The plain route: each loop by its transfer function, each step by itself, all sorted.
TEST(UncertaintyBands, togetherAreThoseOfTheLoopsOneByOne) {
    const auto drawn = uncertainInAll(0.2);
    const LoopTiming timing{0.01, 1};
    PidGains gains = recommended();
    gains.proportional = 12.0;
    gains.integral = 10.0;
    gains.derivative = 0.5;
    const auto frequencies = logarithmicFrequencies(0.5, 300.0, 12);
    const auto bands = loopBands(drawn, gains, timing, frequencies);
    ASSERT_TRUE(bands.has_value());
    std::vector<FrequencyResponse> loops;
    for (const PositionPlant& plant : drawn) {
        loops.push_back(*frequencyResponse(*sampledOpenLoop(plant, gains, timing), frequencies));
    }
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        std::vector<double> magnitudes;
        std::vector<double> phases;
        for (const FrequencyResponse& loop : loops) {
            magnitudes.push_back(magnitude_dB(loop)[i]);
            phases.push_back(phase_deg(loop)[i]);
        }
        // Near z = 1 the multiplied polynomials of the whole loop keep some ten digits.
        EXPECT_NEAR(bands->magnitude_dB.p5[i], ranked(magnitudes, 0.05), 1e-7);
        EXPECT_NEAR(bands->magnitude_dB.p95[i], ranked(magnitudes, 0.95), 1e-7);
        EXPECT_NEAR(bands->phase_deg.p5[i], ranked(phases, 0.05), 1e-6);
        EXPECT_NEAR(bands->phase_deg.p95[i], ranked(phases, 0.95), 1e-6);
    }
}

TEST(UncertaintyBands, ofStepsTogetherAreThoseOfTheStepsOneByOne) {
    const auto drawn = uncertainInAll(0.2);
    for (const int delay_samples : {0, 2}) {
        const LoopTiming timing{0.01, delay_samples};
        PidGains gains = recommended();
        gains.proportional = delay_samples == 0 ? 40.0 : 5.0;
        gains.derivative = delay_samples == 0 ? 1.4 : 0.3;
        gains.integral = 3.0;
        const auto band = stepBand(drawn, gains, timing, 0.5, 0.4, 5);
        ASSERT_TRUE(band.has_value());
        std::vector<LoopStep> steps;
        for (const PositionPlant& plant : drawn) {
            steps.push_back(*linearStep(plant, gains, timing, 0.5, 0.4, 5));
        }
        ASSERT_EQ(band->time_s.size(), steps.front().time_s.size());
        for (std::size_t i = 0; i < band->time_s.size(); i += 7) {
            std::vector<double> angles;
            for (const LoopStep& step : steps) {
                angles.push_back(step.response_rad[i]);
            }
            EXPECT_DOUBLE_EQ(band->time_s[i], steps.front().time_s[i]);
            EXPECT_NEAR(band->response_rad.p5[i], ranked(angles, 0.05), 1e-12); // rounding of 400 steps
            EXPECT_NEAR(band->response_rad.p95[i], ranked(angles, 0.95), 1e-12);
        }
    }
}

TEST(UncertaintyBands, ofALongStepKeepSomePointsFromTheFirstToTheLast) {
    const auto drawn = uncertainInAll(0.05);
    const auto whole = stepBand(drawn, recommended(), NoDelay, 1.0, 10.0);
    const auto some = stepBand(drawn, recommended(), NoDelay, 1.0, 10.0, 1, 50);
    ASSERT_TRUE(whole && some);
    EXPECT_EQ(whole->time_s.size(), 1001u);
    EXPECT_LE(some->time_s.size(), 50u);
    EXPECT_EQ(some->time_s.front(), 0.0);
    EXPECT_EQ(some->time_s.back(), whole->time_s.back());
    for (std::size_t i = 0; i < some->time_s.size(); ++i) {
        const auto at = static_cast<std::size_t>(std::lround(some->time_s[i] / 0.01));
        EXPECT_EQ(some->response_rad.p95[i], whole->response_rad.p95[at]);
    }
}

} // namespace
} // namespace halbench::control
