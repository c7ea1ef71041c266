#include "control/assess/filtered_loop.h"
#include "control/base/units.h"
#include "control/law/filtered_controller.h"
#include "control/law/filtered_law.h"
#include "control/law/filters.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

FilteredLaw recommendedLaw() {
    FilteredLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 120.0;
    law.gains.derivative = 2.0;
    return law;
}

/// Everything at once.
FilteredLaw filteredLaw() {
    FilteredLaw law = recommendedLaw();
    law.gains.filter_s = 0.004;
    law.proportionalWeight = 0.6;
    law.derivativeWeight = 0.3;
    law.filters = {NotchFilter{180.0, 0.1, 0.5}, LowPassFilter{250.0, 2}, LeadFilter{40.0, 15.0},
                   LagFilter{2.0, 1.5}};
    return law;
}

double magnitudeRatio(const FilteredLaw& one, const FilteredLaw& other, double frequency_rad_s) {
    const auto first = filteredOpenLoop(published(), one, NoDelay);
    const auto second = filteredOpenLoop(published(), other, NoDelay);
    return std::abs(first->atFrequency(frequency_rad_s) / second->atFrequency(frequency_rad_s));
}

// Pre-warped at its own frequency a filter is there what it is on paper, however near to Nyquist.
TEST(FilteredLaw, aNotchTakesItsDepthOutOfTheLoopAtItsFrequency) {
    for (const double frequency_rad_s : {30.0, 180.0, 300.0}) {
        FilteredLaw notched = recommendedLaw();
        notched.filters = {NotchFilter{frequency_rad_s, 0.2, 0.3}};
        EXPECT_NEAR(magnitudeRatio(notched, recommendedLaw(), frequency_rad_s), 0.2, 1e-9);
    }
}

TEST(FilteredLaw, aLowPassAddsItsKnownPhase) {
    // First order: Tustin at the angle theta = w T is 1/(1 + j tan(theta/2)/tan(theta_c/2)).
    FilteredLaw filtered = recommendedLaw();
    filtered.filters = {LowPassFilter{100.0, 1}};
    const auto plain = filteredOpenLoop(published(), recommendedLaw(), NoDelay);
    const auto loop = filteredOpenLoop(published(), filtered, NoDelay);
    const double crossover = *smallestMargins(*plain).gainCrossover_rad_s;
    const double ratio = std::tan(crossover * 0.005) / std::tan(0.5);
    const double added_rad = std::arg(loop->atFrequency(crossover) / plain->atFrequency(crossover));
    EXPECT_NEAR(added_rad, -std::atan(ratio), 1e-10);
    // ... and at its corner -3 dB and 45 degrees, the second order 90.
    EXPECT_NEAR(magnitudeRatio(filtered, recommendedLaw(), 100.0), std::sqrt(0.5), 1e-10);
    filtered.filters = {LowPassFilter{100.0, 2}};
    const auto second = sampledFilter(filtered.filters[0], 0.01);
    EXPECT_NEAR(std::arg(second->atFrequency(100.0)), -0.5 * Pi, 1e-10);
}

TEST(FilteredLaw, leadAndLagKeepTheirPhaseAndTheirGain) {
    const auto lead = sampledFilter(LeadFilter{60.0, 35.0}, 0.01);
    EXPECT_NEAR(radiansToDegrees(std::arg(lead->atFrequency(60.0))), 35.0, 1e-9);
    EXPECT_NEAR(std::abs(lead->atFrequency(60.0)), 1.0, 1e-12);
    EXPECT_NEAR(sampledFilter(LagFilter{5.0, 4.0}, 0.01)->dcGain(), 4.0, 1e-9);
}

// (z - 1)/((T + T_f) z - T_f): at low frequencies s/(1 + T_f s), with T_f = 0 the board's own difference.
TEST(FilteredLaw, theDerivativesFilterIsTheBackwardDifference) {
    FilteredLaw law;
    law.gains.derivative = 3.0;
    law.gains.filter_s = 0.03;
    const auto filtered = filteredController(law, 0.01);
    const std::complex<double> z = std::polar(1.0, 0.4);
    EXPECT_LT(std::abs(filtered->at(z) - 3.0 * (z - 1.0) / (0.04 * z - 0.03)), 1e-10);
    law.gains.filter_s = 0.0;
    const auto board = sampledController(law.gains, 0.01);
    EXPECT_LT(std::abs(filteredController(law, 0.01)->at(z) - board->at(z)), 1e-10);
}

// Second route: the difference equation one sample after the other against the transfer functions.
TEST(FilteredLaw, theDifferenceEquationIsBothOfItsTransferFunctions) {
    constexpr int Samples = 300;
    const FilteredLaw law = filteredLaw();
    std::vector<double> input(Samples);
    for (int k = 0; k < Samples; ++k) {
        input[static_cast<std::size_t>(k)] = std::sin(0.37 * k) + (k % 7 == 0 ? 1.0 : 0.0);
    }
    for (const bool isReference : {true, false}) {
        const auto path = isReference ? filteredReferencePath(law, 0.01) : filteredController(law, 0.01);
        ASSERT_TRUE(path);
        const std::vector<double> expected = simulate(*path, input);
        auto controller = FilteredController::make(law, 0.01);
        ASSERT_TRUE(controller);
        double largest = 0.0;
        for (const double value : expected) {
            largest = std::max(largest, std::abs(value));
        }
        for (std::size_t k = 0; k < input.size(); ++k) {
            const double current =
                isReference ? controller->step(input[k], 0.0) : controller->step(0.0, -input[k]);
            ASSERT_NEAR(current, expected[k], 1e-9 * largest) << k << (isReference ? " r" : " y");
        }
    }
}

TEST(FilteredLaw, aFormWithItsFilterIsTheSameController) {
    FilteredLaw law = filteredLaw();
    const auto parallel = filteredController(law, 0.01);
    law.gains = *convert(law.gains, PidForm::Series, GainUnit::PerDegree);
    const auto series = filteredController(law, 0.01);
    ASSERT_TRUE(series);
    for (const double w : {1.0, 30.0, 200.0}) {
        EXPECT_LT(std::abs(series->atFrequency(w) / parallel->atFrequency(w) - 1.0), 1e-9);
    }
}

TEST(FilteredLaw, whatIsNotPossibleIsRefused) {
    const auto codeOf = [](const FilteredLaw& law) {
        const auto gains = checkedGains(law, 0.01);
        return gains ? std::optional<ErrorCode>() : std::optional(gains.error().code);
    };
    EXPECT_EQ(codeOf(filteredLaw()), std::nullopt);
    FilteredLaw law = recommendedLaw();
    law.proportionalWeight = 1.2;
    EXPECT_EQ(codeOf(law), ErrorCode::OutOfRange);
    law.proportionalWeight = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(codeOf(law), ErrorCode::NotFinite);
    law = recommendedLaw();
    law.derivativeWeight = -0.1;
    EXPECT_EQ(codeOf(law), ErrorCode::OutOfRange);
    law = recommendedLaw();
    law.filters = {NotchFilter{315.0, 0.1, 0.5}}; // Nyquist lies at 314.16 rad/s
    EXPECT_EQ(codeOf(law), ErrorCode::OutOfRange);
    law.filters.assign(4, LowPassFilter{100.0, 1});
    EXPECT_EQ(codeOf(law), std::nullopt);
    law.filters.assign(5, LowPassFilter{100.0, 1});
    EXPECT_EQ(codeOf(law), ErrorCode::OutOfRange);
    for (const LagFilter& slow : {LagFilter{1e-300, 2.0}, LagFilter{1e-3, 1e8}}) {
        law.filters = {slow};
        EXPECT_EQ(codeOf(law), ErrorCode::OutOfRange);
    }
    law = recommendedLaw();
    law.gains.filter_s = -0.01;
    EXPECT_EQ(codeOf(law), ErrorCode::NotFinite);
    law = recommendedLaw();
    law.proportionalWeight = 0.5;
    law.gains.integral = 0.0; // would rest at half of the reference
    EXPECT_EQ(codeOf(law), ErrorCode::InvalidInput);
}

TEST(FilteredLaw, knowsWhatTheBoardCannotDo) {
    EXPECT_TRUE(isBoardLaw(recommendedLaw()));
    FilteredLaw law = recommendedLaw();
    law.gains.filter_s = 0.0;
    EXPECT_TRUE(isBoardLaw(law));
    law.gains.filter_s = 0.01;
    EXPECT_FALSE(isBoardLaw(law));
    law.gains.derivative = 0.0; // filters nothing
    EXPECT_TRUE(isBoardLaw(law));
    law = recommendedLaw();
    law.derivativeWeight = 1.0;
    EXPECT_FALSE(isBoardLaw(law));
}

} // namespace
} // namespace halbench::control
