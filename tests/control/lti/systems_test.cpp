#include "control/base/units.h"
#include "control/lti/frequency_response.h"
#include "control/lti/responses.h"
#include "control/lti/state_space.h"
#include "control/lti/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

const TimeBase Continuous = TimeBase::continuous();

TransferFunction make(Polynomial numerator, Polynomial denominator, TimeBase base = Continuous) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), base);
}

TEST(TransferFunction, refusesToMixTimeBases) {
    const auto sampled = make({1.0}, {1.0, -0.5}, TimeBase::sampled(0.01));
    EXPECT_EQ(series(make({1.0}, {1.0, 1.0}), sampled).error().code, ErrorCode::InvalidInput);
    const auto slower = make({1.0}, {1.0, -0.5}, TimeBase::sampled(0.02));
    EXPECT_EQ(parallel(slower, sampled).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(feedback(slower, sampled).error().code, ErrorCode::InvalidInput);
}

TEST(TransferFunction, refusesWhatIsNoSystem) {
    EXPECT_EQ(TransferFunction::make({1.0}, {0.0}, Continuous).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(TransferFunction::make({1.0, 0.0}, {1.0}, Continuous).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(TransferFunction::make({std::nan("")}, {1.0}, Continuous).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(TimeBase::sampledChecked(-1.0).error().code, ErrorCode::OutOfRange);
}

TEST(TransferFunction, combinesAsTheValuesDo) {
    const auto first = make({2.0, 1.0}, {1.0, 3.0, 5.0});
    const auto second = make({4.0}, {1.0, 6.0});
    const std::complex<double> s(0.3, 1.7);
    const auto a = first.at(s);
    const auto b = second.at(s);
    EXPECT_LT(std::abs(series(first, second)->at(s) - a * b), 1e-14);
    EXPECT_LT(std::abs(parallel(first, second)->at(s) - (a + b)), 1e-14);
    EXPECT_LT(std::abs(feedback(first, second)->at(s) - a / (1.0 + a * b)), 1e-14);
}

TEST(TransferFunction, refusesAnAlgebraicLoop) {
    EXPECT_EQ(feedback(TransferFunction::gain(-1.0, Continuous), TransferFunction::gain(1.0, Continuous))
                  .error()
                  .code,
              ErrorCode::InvalidInput);
}

TEST(TransferFunction, stabilityLooksAtTheRightRegion) {
    EXPECT_TRUE(isStable(make({1.0}, {1.0, 2.0})));
    EXPECT_FALSE(isStable(make({1.0}, {1.0, 0.0})));
    EXPECT_FALSE(isStable(make({1.0}, {1.0, 2.0}, TimeBase::sampled(1.0))));
    EXPECT_TRUE(isStable(make({1.0}, {1.0, 0.5}, TimeBase::sampled(1.0))));
}

TEST(TransferFunction, dampingOfASampledPoleIsThatOfItsContinuousImage) {
    const double T = 0.02;
    const std::complex<double> s = std::polar(30.0, Pi - std::acos(0.2));
    const auto system =
        make({1.0}, fromRoots({std::exp(s * T), std::exp(std::conj(s) * T)}), TimeBase::sampled(T));
    for (const Damping& mode : damping(system)) {
        EXPECT_NEAR(mode.naturalFrequency_rad_s, 30.0, 1e-9);
        EXPECT_NEAR(mode.damping_ratio, 0.2, 1e-10);
    }
}

TEST(TransferFunction, delayTurnsThePhaseAndLeavesTheMagnitude) {
    const auto delay = TransferFunction::delay(3, 0.01);
    EXPECT_LT(std::abs(delay.atFrequency(20.0) - std::polar(1.0, -0.6)), 1e-14);
    const auto pade = TransferFunction::padeDelay(0.03, 4);
    // The error of the order n approximation is about 2 (n!)^2 x^(2n+1)/((2n)! (2n+1)!), 2e-9 at x = 0.6.
    EXPECT_LT(std::abs(pade.atFrequency(20.0) - std::polar(1.0, -0.6)), 5e-9);
}

TEST(TransferFunction, dcGainOfAnIntegratorIsInfinite) {
    EXPECT_EQ(make({1.0}, {1.0, 0.0}).dcGain(), std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ(make({1.0}, {1.0, -0.5}, TimeBase::sampled(1.0)).dcGain(), 2.0);
}

TEST(StateSpace, goesThereAndBack) {
    const auto system = make({2.0, 3.0, 5.0, 7.0}, {1.0, 4.0, 6.0, 9.0});
    const auto back = toTransferFunction(toStateSpace(system));
    ASSERT_TRUE(back.has_value());
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(back->numerator()[i], system.numerator()[i], 1e-12);
        EXPECT_NEAR(back->denominator()[i], system.denominator()[i], 1e-12);
    }
}

TEST(StateSpace, polesOfBothDescriptionsAgree) {
    const auto system = make({1.0}, {1.0, 2.0, 7.0, 5.0});
    const auto byRoots = poles(system);
    for (const auto& pole : poles(toStateSpace(system))) {
        double nearest = HUGE_VAL;
        for (const auto& root : byRoots) {
            nearest = std::min(nearest, std::abs(root - pole));
        }
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(StateSpace, refusesMatricesThatDoNotFit) {
    const Eigen::MatrixXd two = Eigen::MatrixXd::Identity(2, 2);
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
    EXPECT_EQ(makeStateSpace(two, one, one, one, Continuous).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(makeStateSpace(one * std::nan(""), one, one, one, Continuous).error().code,
              ErrorCode::NotFinite);
    EXPECT_TRUE(makeStateSpace(one, one, one, one, Continuous).has_value());
}

TEST(FrequencyResponse, unwrapsThePhaseOfALoopWithDelay) {
    const double T = 0.01;
    const auto integrator = make({T}, {1.0, -1.0}, TimeBase::sampled(T));
    const auto loop = series(integrator, TransferFunction::delay(5, T));
    const auto response = frequencyResponse(*loop, logarithmicFrequencies(0.1, Pi / T, 400));
    ASSERT_TRUE(response.has_value());
    const auto phase = phase_deg(*response);
    // T/(z-1) has the phase -90 deg - w T/2, each sample of delay adds -w T.
    for (std::size_t i = 0; i < phase.size(); ++i) {
        EXPECT_NEAR(phase[i], -90.0 - radiansToDegrees(5.5 * response->frequency_rad_s[i] * T), 1e-6);
    }
    EXPECT_NEAR(magnitude_dB(*response).back(), 20.0 * std::log10(T / 2.0), 1e-9);
}

// 1/(s^2 (s + 1)) starts just below -180 deg and ends at -270 deg; its argument starts above +90.
TEST(FrequencyResponse, phaseOfALoopWithTwoIntegratorsStartsBelowMinusOneEighty) {
    const auto loop = make({1.0}, {1.0, 1.0, 0.0, 0.0});
    const auto response = frequencyResponse(loop, logarithmicFrequencies(0.01, 100.0, 50));
    ASSERT_TRUE(response.has_value());
    const auto phase = phase_deg(*response);
    for (std::size_t i = 0; i < phase.size(); ++i) {
        EXPECT_NEAR(phase[i], -180.0 - radiansToDegrees(std::atan(response->frequency_rad_s[i])), 1e-9);
    }
}

TEST(FrequencyResponse, refusesFrequenciesBeyondNyquist) {
    const auto system = make({1.0}, {1.0, -0.5}, TimeBase::sampled(0.01));
    EXPECT_EQ(frequencyResponse(system, {400.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(frequencyResponse(system, {0.0}).error().code, ErrorCode::OutOfRange);
}

TEST(Responses, stepOfAFirstOrderLagIsTheExponential) {
    const auto response = stepResponse(make({6.0}, {1.0, 2.0}), 2.0, 0.1);
    ASSERT_TRUE(response.has_value());
    ASSERT_EQ(response->time_s.size(), 21u);
    for (std::size_t i = 0; i < response->value.size(); ++i) {
        EXPECT_NEAR(response->value[i], 3.0 * (1.0 - std::exp(-2.0 * response->time_s[i])), 1e-13);
    }
}

TEST(Responses, sampledStepFollowsTheDifferenceEquation) {
    const auto response = stepResponse(make({1.0, 0.0}, {1.0, -0.5}, TimeBase::sampled(0.1)), 0.5, 1.0);
    ASSERT_TRUE(response.has_value());
    for (std::size_t k = 0; k < response->value.size(); ++k) {
        EXPECT_NEAR(response->value[k], 2.0 - std::pow(0.5, static_cast<double>(k)), 1e-14);
    }
    EXPECT_EQ(stepResponse(make({1.0}, {1.0, 2.0}), -1.0, 0.1).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
