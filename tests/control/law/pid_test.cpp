#include "control/analysis/loop_functions.h"
#include "control/law/board_gains.h"
#include "control/law/pid.h"
#include "control/law/position_loop.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

// help: htm-theory.md 10, property 12
TEST(PidGains, tenPerDegreeIsFiveHundredSeventyThreePerRadian) {
    PidGains gains;
    gains.unit = GainUnit::PerDegree;
    gains.proportional = 10.0;
    const auto converted = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    ASSERT_TRUE(converted.has_value());
    EXPECT_NEAR(converted->proportional, 572.958, 0.5e-3);
}

TEST(PidGains, conversionsKeepTheFrequencyResponse) {
    PidGains gains;
    gains.proportional = 12.0;
    gains.integral = 8.0;
    gains.derivative = 0.9;
    const std::complex<double> s(0.0, 3.0);
    const auto wanted = 12.0 + 8.0 / s + 0.9 * s;
    const auto standard = convert(gains, PidForm::Standard, GainUnit::PerRadian);
    ASSERT_TRUE(standard.has_value());
    const auto asStandard =
        standard->proportional * (1.0 + 1.0 / (standard->integral * s) + standard->derivative * s);
    EXPECT_LT(std::abs(asStandard - wanted), 1e-13);
    const auto series = convert(*standard, PidForm::Series, GainUnit::PerRadian);
    ASSERT_TRUE(series.has_value());
    const auto asSeries =
        series->proportional * (1.0 + 1.0 / (series->integral * s)) * (1.0 + series->derivative * s);
    EXPECT_LT(std::abs(asSeries - wanted), 1e-12);
    const auto back = convert(*series, PidForm::Parallel, GainUnit::PerRadian);
    ASSERT_TRUE(back.has_value());
    EXPECT_NEAR(back->proportional, 12.0, 1e-12);
    EXPECT_NEAR(back->integral, 8.0, 1e-12);
    EXPECT_NEAR(back->derivative, 0.9, 1e-13);
}

TEST(PidGains, withoutIntegralActionTheIntegralTimeIsInfiniteAndComesBackAsZero) {
    PidGains gains;
    gains.proportional = 4.0;
    gains.derivative = 1.0;
    for (const PidForm form : {PidForm::Standard, PidForm::Series}) {
        const auto timed = convert(gains, form, GainUnit::PerDegree);
        ASSERT_TRUE(timed.has_value());
        EXPECT_TRUE(std::isinf(timed->integral));
        const auto back = convert(*timed, PidForm::Parallel, GainUnit::PerRadian);
        ASSERT_TRUE(back.has_value());
        EXPECT_EQ(back->integral, 0.0);
        EXPECT_NEAR(back->proportional, 4.0, 1e-14);
        EXPECT_NEAR(back->derivative, 1.0, 1e-14);
    }
}

// All three notations are one controller, with the filter on the derivative in each as its own definition has
// it.
TEST(PidGains, conversionsKeepTheFrequencyResponseWithTheFilter) {
    PidGains series;
    series.form = PidForm::Series;
    series.proportional = 12.0;
    series.integral = 0.8;
    series.derivative = 0.05;
    series.filter_s = 0.01;
    const auto parallel = convert(series, PidForm::Parallel, GainUnit::PerRadian);
    const auto standard = convert(*parallel, PidForm::Standard, GainUnit::PerDegree);
    const auto back = convert(*standard, PidForm::Series, GainUnit::PerRadian);
    ASSERT_TRUE(parallel && standard && back);
    EXPECT_NEAR(back->proportional, 12.0, 1e-12);
    EXPECT_NEAR(back->integral, 0.8, 1e-13);
    EXPECT_NEAR(back->derivative, 0.05, 1e-14);
    for (const double w : {0.1, 5.0, 300.0}) {
        const std::complex<double> s(0.0, w);
        const auto expected = 12.0 * (1.0 + 1.0 / (0.8 * s)) * (1.0 + 0.05 * s / (1.0 + 0.01 * s));
        for (const auto& gains : {series, *parallel, *standard, *back}) {
            const auto controller = continuousController(gains);
            ASSERT_TRUE(controller.has_value());
            EXPECT_LT(std::abs(controller->atFrequency(w) - expected), 1e-12 * std::abs(expected));
        }
    }
    series.filter_s.reset();
    EXPECT_EQ(continuousController(series).error().code, ErrorCode::InvalidInput);
    series.derivative = 0.0;
    series.integral = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(continuousController(series)->dcGain(), 12.0, 1e-13);
}

// The board differences the angle: backward Euler of s/(1 + T_f s) with T_f = 0. Any other filter would be
// another loop than the one that runs.
TEST(PidGains, reachTheBoardWithoutAFilterOrNotAtAll) {
    PidGains gains;
    gains.proportional = 40.0;
    gains.derivative = 1.4;
    const auto plain = sampledController(gains, 0.01);
    gains.filter_s = 0.0;
    ASSERT_TRUE(boardGains(gains).has_value());
    EXPECT_FALSE(boardGains(gains)->filter_s.has_value());
    EXPECT_EQ(sampledController(gains, 0.01)->numerator(), plain->numerator());
    gains.filter_s = 1e-3;
    for (const ErrorCode code : {boardGains(gains).error().code, sampledController(gains, 0.01).error().code,
                                 sampledOpenLoop(published(), gains, NoDelay).error().code,
                                 linearStep(published(), gains, NoDelay, 1.0, 1.0).error().code}) {
        EXPECT_EQ(code, ErrorCode::InvalidInput);
    }
    gains.derivative = 0.0; // a filter on nothing
    EXPECT_TRUE(boardGains(gains).has_value());
}

// The books' loop keeps the filter: K_D s/(1 + T_f s) falls off where K_D s does not.
TEST(PidGains, countTheirFilterInTheContinuousLoop) {
    PidGains gains;
    gains.proportional = 40.0;
    gains.derivative = 1.4;
    gains.filter_s = 0.02;
    const std::complex<double> s(0.0, 100.0);
    const auto expected =
        (40.0 + 1.4 * s / (1.0 + 0.02 * s)) * 26.0 / (s * (s + published().dampingRate_1_s));
    const auto loop = continuousOpenLoop(published(), gains);
    ASSERT_TRUE(loop.has_value());
    EXPECT_LT(std::abs(loop->atFrequency(100.0) - expected), 1e-12 * std::abs(expected));
}

TEST(PidGains, refusesTheSeriesFormForComplexZeros) {
    PidGains gains;
    gains.proportional = 1.0;
    gains.integral = 10.0;
    gains.derivative = 1.0;
    EXPECT_EQ(convert(gains, PidForm::Series, GainUnit::PerRadian).error().code, ErrorCode::InvalidInput);
    gains.proportional = 0.0;
    EXPECT_EQ(convert(gains, PidForm::Standard, GainUnit::PerRadian).error().code, ErrorCode::InvalidInput);
    gains.proportional = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(convert(gains, PidForm::Parallel, GainUnit::PerRadian).error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::control
