#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/loop_uncertainty.h"
#include "control/lti/frequency_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

MotorEstimate uncertainMotor(double deviation_ratio = 0.02) {
    MotorEstimate estimate;
    const double c = 1.23e-3 / 5.5e-4;
    estimate.values = {{"c_over_J", c}, {"phi_over_J", 26.0}, {"Kf_over_phi", 1.434}};
    estimate.covarianceNames = {"c_over_J", "phi_over_J", "Kf_over_phi"};
    const auto square = [&](double value) { return std::pow(deviation_ratio * value, 2); };
    estimate.covariance = {{square(c), 0, 0}, {0, square(26.0), 0}, {0, 0, square(1.434)}};
    return estimate;
}

control::PositionLaw recommended() {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 60.0;
    law.gains.derivative = 1.4;
    return law;
}

/// Straight over the logarithm of the frequency, as a picture joins its points.
double joined(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const auto after = std::lower_bound(x.begin() + 1, x.end() - 1, at);
    const auto i = static_cast<std::size_t>(after - x.begin());
    return y[i - 1] + (y[i] - y[i - 1]) * std::log(at / x[i - 1]) / std::log(x[i] / x[i - 1]);
}

TEST(LoopUncertainty, itsFewFrequenciesAreEnoughForAPicture) {
    for (const int delay_samples : {0, 2}) {
        const LoopConditions conditions{{0.01, delay_samples}, 4.0, {}};
        const auto predicted = runAnalysis(uncertainMotor(), recommended(), conditions);
        ASSERT_TRUE(predicted.has_value());
        const auto uncertainty =
            loopUncertainty(uncertainMotor(), recommended(), conditions, *predicted, {1000, 1});
        ASSERT_TRUE(uncertainty.has_value());
        std::vector<double> all_rad_s;
        for (const double frequency_Hz : predicted->bode.frequency_Hz) {
            all_rad_s.push_back(2.0 * M_PI * frequency_Hz);
        }
        const auto plants =
            control::drawPlants(*uncertainPlantFromEstimate(uncertainMotor()), 1000, Random(1));
        const auto whole = control::loopBands(*plants, recommended().gains, conditions.timing, all_rad_s);
        ASSERT_TRUE(plants && whole);
        const control::LoopBands& some = uncertainty->loop;
        EXPECT_LT(some.frequency_rad_s.size(), 100u);
        for (std::size_t i = 0; i < all_rad_s.size(); ++i) {
            const auto at = [&](const std::vector<double>& y) {
                return joined(some.frequency_rad_s, y, all_rad_s[i]);
            };
            // A tenth of a pixel of a picture of 200 pixels for 150 dB and 180 degrees, where the band of
            // this motor is 6 pixels wide.
            EXPECT_NEAR(at(some.magnitude_dB.p95), whole->magnitude_dB.p95[i], 0.08);
            EXPECT_NEAR(at(some.phase_deg.p5), whole->phase_deg.p5[i], 0.5);
        }
    }
}

TEST(LoopUncertainty, theCurvesOfTheMotorItselfLieInside) {
    const LoopConditions conditions;
    const auto predicted = runAnalysis(uncertainMotor(), recommended(), conditions);
    ASSERT_TRUE(predicted.has_value());
    const auto uncertainty =
        loopUncertainty(uncertainMotor(), recommended(), conditions, *predicted, {1000, 1});
    ASSERT_TRUE(uncertainty && uncertainty->step);
    const control::StepBand& step = *uncertainty->step;
    for (std::size_t i = 1; i < step.time_s.size(); ++i) {
        // The curve has ten points a sample. All motors cross where their bands are narrow: some more there.
        const auto at = static_cast<std::size_t>(std::lround(step.time_s[i] / 0.001));
        const double own = predicted->stepCurve.response_rad.at(at);
        EXPECT_GE(own, step.response_rad.p5[i] - 1e-3);
        EXPECT_LE(own, step.response_rad.p95[i] + 1e-3);
    }
    const auto large = largeStepBand(uncertainMotor(), recommended(), conditions, {1.745, 5.0}, {1000, 1});
    ASSERT_TRUE(large.has_value());
    double width_rad = 0.0;
    for (std::size_t i = 0; i < large->time_s.size(); ++i) {
        EXPECT_LE(large->response_rad.p5[i], large->response_rad.p95[i]);
        width_rad = std::max(width_rad, large->response_rad.p95[i] - large->response_rad.p5[i]);
    }
    EXPECT_GT(width_rad, 0.005);
    EXPECT_LT(width_rad, 0.5);
}

TEST(LoopUncertainty, ofAMotorWithoutCovarianceNothingIsKnown) {
    MotorEstimate exact = uncertainMotor();
    exact.covarianceNames.clear();
    exact.covariance.clear();
    const auto predicted = runAnalysis(exact, recommended(), {});
    ASSERT_TRUE(predicted.has_value());
    const auto uncertainty = loopUncertainty(exact, recommended(), {}, *predicted, {1000, 1});
    ASSERT_FALSE(uncertainty.has_value());
    EXPECT_EQ(uncertainty.error().code, ErrorCode::Refused);
    EXPECT_FALSE(largeStepBand(exact, recommended(), {}, {1.745, 5.0}, {1000, 1}).has_value());
}

TEST(LoopUncertainty, anUnstableLoopHasABandOverFrequencyAndNoStep) {
    control::PositionLaw law = recommended();
    law.gains.proportional = 400.0;
    const auto predicted = runAnalysis(uncertainMotor(), law, {});
    ASSERT_TRUE(predicted && !predicted->isStable);
    const auto uncertainty = loopUncertainty(uncertainMotor(), law, {}, *predicted, {1000, 1});
    ASSERT_TRUE(uncertainty.has_value());
    EXPECT_FALSE(uncertainty->step.has_value());
}

// With nothing filtered the filtered law has the bands of the board's, with a filter others around its own
// curve.
TEST(LoopUncertainty, isThatOfTheLawWhicheverItIs) {
    const LoopConditions conditions{{0.01, 0}, 4.0, {}};
    control::FilteredLaw law;
    law.gains = recommended().gains;
    const LoopLaw same{recommended(), law};
    law.filters = {control::LowPassFilter{200.0, 1}};
    const LoopLaw filtered{recommended(), law};
    const auto predicted = runAnalysis(uncertainMotor(), filtered, conditions);
    const auto board = runAnalysis(uncertainMotor(), recommended(), conditions);
    ASSERT_TRUE(predicted && board);
    const UncertaintyDraws draws{1000, 1};
    const auto own = loopUncertainty(uncertainMotor(), same, conditions, *board, draws);
    const auto expected = loopUncertainty(uncertainMotor(), recommended(), conditions, *board, draws);
    const auto other = loopUncertainty(uncertainMotor(), filtered, conditions, *predicted, draws);
    ASSERT_TRUE(own && expected && other && own->step && expected->step && other->step);
    EXPECT_NEAR(own->loop.magnitude_dB.p5[30], expected->loop.magnitude_dB.p5[30], 1e-9);
    EXPECT_NEAR(own->step->response_rad.p95[20], expected->step->response_rad.p95[20], 1e-10);
    const auto& bands = other->loop;
    for (std::size_t i = 0; i < bands.frequency_rad_s.size(); ++i) {
        const auto at = std::min_element(predicted->bode.frequency_Hz.begin(),
                                         predicted->bode.frequency_Hz.end(), [&](double a, double b) {
                                             const double here_Hz = bands.frequency_rad_s[i] / (2.0 * M_PI);
                                             return std::abs(a - here_Hz) < std::abs(b - here_Hz);
                                         });
        const double curve_dB =
            predicted->bode.magnitude_dB[static_cast<std::size_t>(at - predicted->bode.frequency_Hz.begin())];
        EXPECT_LT(bands.magnitude_dB.p5[i], curve_dB) << i;
        EXPECT_GT(bands.magnitude_dB.p95[i], curve_dB) << i;
    }
    const auto large = largeStepBand(uncertainMotor(), filtered, conditions, {1.0, 5.0}, draws);
    const auto step = predictLargeStep(*plantFromEstimate(uncertainMotor()), filtered, conditions, 1.0);
    ASSERT_TRUE(large && step);
    EXPECT_LT(large->response_rad.p5[30], step->trace.angle_rad[300]);
    EXPECT_GT(large->response_rad.p95[30], step->trace.angle_rad[300]);
}

} // namespace
} // namespace halbench::app
