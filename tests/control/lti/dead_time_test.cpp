#include "control/base/units.h"
#include "control/lti/dead_time.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

TEST(DeadTime, turnsThePhaseExactlyAndLeavesTheMagnitude) {
    const auto lag = continuous({2.0}, {0.5, 1.0});
    const auto late = *DeadTimeSystem::make(lag, 0.3);
    for (const double w : {0.1, 1.0, 10.0, 500.0}) {
        EXPECT_LT(std::abs(late.atFrequency(w) - lag.atFrequency(w) * std::polar(1.0, -0.3 * w)), 1e-15);
    }
}

TEST(DeadTime, combinesAsTheValuesDo) {
    const auto first = *DeadTimeSystem::make(continuous({2.0, 1.0}, {1.0, 3.0, 5.0}), 0.2);
    const auto second = *DeadTimeSystem::make(continuous({4.0}, {1.0, 6.0}), 0.05);
    const auto third = *DeadTimeSystem::make(continuous({1.0}, {1.0, 1.0}), 0.2);
    const std::complex<double> s(-0.1, 1.7);
    EXPECT_LT(std::abs(series(first, second)->at(s) - first.at(s) * second.at(s)), 1e-14);
    EXPECT_LT(std::abs(parallel(first, third)->at(s) - first.at(s) - third.at(s)), 1e-14);
    EXPECT_EQ(parallel(first, second).error().code, ErrorCode::InvalidInput);
    const auto closed = feedbackResponse(first, second, {0.5, 7.0});
    ASSERT_TRUE(closed.has_value());
    const auto a = first.atFrequency(7.0);
    EXPECT_LT(std::abs(closed->value[1] - a / (1.0 + a * second.atFrequency(7.0))), 1e-14);
}

TEST(DeadTime, refusesWhatIsNone) {
    const auto lag = continuous({2.0}, {0.5, 1.0});
    EXPECT_EQ(DeadTimeSystem::make(lag, -0.1).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(DeadTimeSystem::make(lag, std::nan("")).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(DeadTimeSystem::make(*discretize(lag, 0.1, Hold::Zoh{}), 0.1).error().code,
              ErrorCode::InvalidInput);
    const auto late = *DeadTimeSystem::make(lag, 0.1);
    EXPECT_EQ(frequencyResponse(late, {-1.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(discretize(late, 0.0).error().code, ErrorCode::OutOfRange);
}

// Both sides of the same thing: the held step, later by the dead time. y = 1 - exp(-(t - 0.37)/0.5)
TEST(DeadTime, sampledStepOfALagIsTheShiftedExponentialForAnyFractionOfASample) {
    for (const double deadTime_s : {0.0, 0.03, 0.1, 0.37, 0.4}) {
        const auto late = *DeadTimeSystem::make(continuous({1.0}, {0.5, 1.0}), deadTime_s);
        const auto sampled = discretize(late, 0.1);
        ASSERT_TRUE(sampled.has_value());
        const auto answer = simulate(*sampled, std::vector<double>(40, 1.0));
        for (std::size_t k = 0; k < answer.size(); ++k) {
            const double t = std::max(0.0, 0.1 * static_cast<double>(k) - deadTime_s);
            EXPECT_NEAR(answer[k], 1.0 - std::exp(-t / 0.5), 1e-13) << deadTime_s << " at " << k;
        }
    }
}

// Second route: at four times the rate a dead time of 3/4 sample is three whole samples.
TEST(DeadTime, aFractionOfASampleIsThatOfAFasterSampling) {
    Random random(11);
    for (int round = 0; round < 30; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(5)), true, round % 3 == 0);
        const double T = 0.02;
        const auto slow = discretize(*DeadTimeSystem::make(system, 1.75 * T), T);
        ASSERT_TRUE(slow.has_value());
        std::vector<double> input;
        std::vector<double> fastInput;
        for (int k = 0; k < 60; ++k) {
            input.push_back(random.gaussian());
            fastInput.insert(fastInput.end(), 4, input.back());
        }
        const auto fast =
            *series(*discretize(system, T / 4.0, Hold::Zoh{}), TransferFunction::delay(7, T / 4.0));
        const auto expected = simulate(fast, fastInput);
        const auto answer = simulate(*slow, input);
        for (std::size_t k = 0; k < answer.size(); ++k) {
            // The polynomials of order 5 at a fast rate keep some 9 digits of the slow poles.
            EXPECT_NEAR(answer[k], expected[4 * k], 1e-7 * (1.0 + std::abs(expected[4 * k])));
        }
    }
}

// The error of the order 5 approximation, 2 (5!)^2 x^11/(10! 11!), is 2e-10 at x = w deadTime = 1.
TEST(DeadTime, padeAgreesWithTheExactDeadTimeWhereItIsGood) {
    const auto late = *DeadTimeSystem::make(continuous({1.0}, {1.0, 1.0}), 0.2);
    const auto rational = withPade(late, 5);
    ASSERT_TRUE(rational.has_value());
    for (const double w : {0.1, 1.0, 5.0}) {
        EXPECT_LT(std::abs(rational->atFrequency(w) - late.atFrequency(w)), 1e-9);
    }
}

} // namespace
} // namespace halbench::control
