#include "control/analysis/step_metrics.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace halbench::control {
namespace {

struct Curve {
    std::vector<double> time_s;
    std::vector<double> value;
};

Curve sampled(double duration_s, double period_s, const std::function<double(double)>& function) {
    Curve curve;
    for (int i = 0; i * period_s <= duration_s; ++i) {
        curve.time_s.push_back(i * period_s);
        curve.value.push_back(function(i * period_s));
    }
    return curve;
}

TEST(StepMetrics, ofASecondOrderSystemAreTheClosedForms) {
    const double zeta = 0.3;
    const double w = 10.0;
    const double wd = w * std::sqrt(1.0 - zeta * zeta);
    const auto curve = sampled(4.0, 1e-4, [&](double t) {
        return 2.0 - 2.0 * std::exp(-zeta * w * t) * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t));
    });
    const auto metrics = measureStep(curve.time_s, curve.value, 0.0, 2.0);
    ASSERT_TRUE(metrics.has_value());
    // Half a sample beside the peak: w^2 h^2/8 of the step, 1.25e-5 %.
    EXPECT_NEAR(metrics->overshoot_percent, 100.0 * std::exp(-Pi * zeta / std::sqrt(1.0 - zeta * zeta)),
                1e-4);
    EXPECT_NEAR(metrics->peakTime_s.value(), Pi / wd, 1e-4); // one sample
    EXPECT_NEAR(metrics->finalError_rad, 0.0, 1e-4);
}

// Second route: the last sample outside the band. This response enters it for good from above.
TEST(StepMetrics, settlingCountsFromTheLastTimeOutsideTheBandOnEitherSide) {
    const auto curve =
        sampled(6.0, 1e-3, [](double t) { return 1.0 + 8.0 * (t - 0.5) * std::exp(-2.0 * t); });
    double last_s = 0.0;
    for (std::size_t i = 0; i < curve.time_s.size(); ++i) {
        last_s = std::abs(curve.value[i] - 1.0) > 0.02 ? curve.time_s[i] : last_s;
    }
    ASSERT_GT(curve.value[static_cast<std::size_t>(last_s * 1000.0)], 1.0);
    const auto metrics = measureStep(curve.time_s, curve.value, 0.0, 1.0);
    ASSERT_TRUE(metrics.has_value());
    EXPECT_NEAR(metrics->settlingTime_s.value(), last_s + 0.5e-3, 0.5e-3 + 1e-9);
}

TEST(StepMetrics, ofALagAreTheLogarithms) {
    const auto curve = sampled(10.0, 1e-3, [](double t) { return 1.0 - std::exp(-t); });
    const auto metrics = measureStep(curve.time_s, curve.value, 0.0, 1.0);
    ASSERT_TRUE(metrics.has_value());
    EXPECT_NEAR(metrics->riseTime_s.value(), std::log(9.0), 1e-6); // linear interpolation over 1 ms
    EXPECT_NEAR(metrics->settlingTime_s.value(), std::log(50.0), 1e-6);
    EXPECT_EQ(metrics->overshoot_percent, 0.0);
    EXPECT_FALSE(metrics->peakTime_s.has_value());
    EXPECT_NEAR(metrics->finalError_rad, std::exp(-10.0), 1e-12);
}

TEST(StepMetrics, aDownwardStepIsTheMirrorImage) {
    const auto curve = sampled(10.0, 1e-3, [](double t) { return 3.0 - 2.0 * (1.0 - std::exp(-t)); });
    const auto metrics = measureStep(curve.time_s, curve.value, 3.0, 1.0);
    ASSERT_TRUE(metrics.has_value());
    EXPECT_NEAR(metrics->riseTime_s.value(), std::log(9.0), 1e-6); // linear interpolation over 1 ms
    EXPECT_LT(metrics->finalError_rad, 0.0);
}

TEST(StepMetrics, aMotorStuckShortOfItsTargetNeitherRisesNorSettles) {
    const auto curve = sampled(2.0, 1e-3, [](double t) { return 0.8 * (1.0 - std::exp(-9.0 * t)); });
    const auto metrics = measureStep(curve.time_s, curve.value, 0.0, 1.0);
    ASSERT_TRUE(metrics.has_value());
    EXPECT_FALSE(metrics->riseTime_s.has_value());
    EXPECT_FALSE(metrics->settlingTime_s.has_value());
    EXPECT_NEAR(metrics->finalError_rad, 0.2, 1e-6); // 0.8 exp(-18) is left
}

TEST(StepMetrics, timesCountFromTheInstantOfTheStep) {
    auto curve = sampled(10.0, 1e-3, [](double t) { return 1.0 - std::exp(-t); });
    for (double& time : curve.time_s) {
        time += 100.0;
    }
    EXPECT_NEAR(measureStep(curve.time_s, curve.value, 0.0, 1.0)->settlingTime_s.value(), std::log(50.0),
                1e-6);
}

TEST(StepMetrics, refusesWhatIsNoStep) {
    const std::vector<double> two = {0.0, 1.0};
    const std::vector<double> one = {0.0};
    const std::vector<double> bad = {0.0, std::numeric_limits<double>::quiet_NaN()};
    const std::vector<double> back = {1.0, 0.0};
    EXPECT_EQ(measureStep(two, one, 0.0, 1.0).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(measureStep(one, one, 0.0, 1.0).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(measureStep(two, bad, 0.0, 1.0).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(measureStep(two, two, 1.0, 1.0).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(measureStep(back, two, 0.0, 1.0).error().code, ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::control
