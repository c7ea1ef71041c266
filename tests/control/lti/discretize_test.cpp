#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "control/lti/hold_matrices.h"
#include "control/lti/responses.h"
#include "control/lti/state_response.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

// help: htm-theory.md 3.7
TEST(Discretize, zeroOrderHoldGivesThePublishedSampledPlant) {
    const auto plant = continuous({26.0}, {1.0, 1.23e-3 / 5.5e-4, 0.0});
    const auto sampled = discretize(plant, 0.01, Hold::Zoh{});
    ASSERT_TRUE(sampled.has_value());
    ASSERT_EQ(sampled->numerator().size(), 2u);
    // Half a unit of the last printed digit.
    EXPECT_NEAR(sampled->numerator()[0], 1.2903630e-3, 0.5e-10);
    EXPECT_NEAR(sampled->numerator()[1], 1.2807798e-3, 0.5e-10);
    EXPECT_NEAR(sampled->denominator()[2], 0.9778846, 0.5e-7);
    EXPECT_NEAR(sampled->denominator()[1], -1.9778846, 0.5e-7);
}

TEST(Discretize, zeroOrderHoldKeepsTheStepResponseAtTheSamples) {
    const auto system = continuous({3.0, 1.0}, {1.0, 0.8, 4.0});
    const auto sampled = discretize(system, 0.3, Hold::Zoh{});
    ASSERT_TRUE(sampled.has_value());
    const auto answer = simulate(*sampled, std::vector<double>(20, 1.0));
    // y = 1/4 + e^(-0.4 t) (A cos wt + B sin wt), from the partial fractions of (3 s + 1)/(s (s^2 + 0.8 s +
    // 4))
    const double w = std::sqrt(4.0 - 0.16);
    const double A = -0.25;
    const double B = (3.0 - 0.4 * 0.25) / w;
    for (std::size_t k = 0; k < answer.size(); ++k) {
        const double t = 0.3 * static_cast<double>(k);
        const double expected = 0.25 + std::exp(-0.4 * t) * (A * std::cos(w * t) + B * std::sin(w * t));
        EXPECT_NEAR(answer[k], expected, 1e-12);
    }
}

TEST(Discretize, firstOrderHoldKeepsTheRampResponseAtTheSamples) {
    const auto sampled = discretize(continuous({1.0}, {1.0, 2.0}), 0.25, Hold::Foh{});
    ASSERT_TRUE(sampled.has_value());
    std::vector<double> ramp;
    for (int k = 0; k < 20; ++k) {
        ramp.push_back(0.25 * k);
    }
    const auto answer = simulate(*sampled, ramp);
    for (std::size_t k = 0; k < answer.size(); ++k) {
        const double t = ramp[k];
        EXPECT_NEAR(answer[k], t / 2.0 - 0.25 * (1.0 - std::exp(-2.0 * t)), 1e-13);
    }
}

TEST(Discretize, tustinReplacesTheDerivativeByTheBilinearQuotient) {
    const auto system = continuous({1.0, 5.0}, {1.0, 3.0, 7.0});
    const double T = 0.1;
    const auto sampled = discretize(system, T, Hold::Tustin{});
    ASSERT_TRUE(sampled.has_value());
    for (const double w : {0.1, 1.0, 10.0, 30.0}) {
        const std::complex<double> s(0.0, 2.0 / T * std::tan(w * T / 2.0));
        EXPECT_LT(std::abs(sampled->atFrequency(w) - system.at(s)), 1e-12);
    }
}

TEST(Discretize, prewarpedTustinIsExactAtThePrewarpFrequencyAndAtZero) {
    const auto notch = continuous({1.0, 0.2, 400.0}, {1.0, 20.0, 400.0});
    const auto sampled = discretize(notch, 0.05, Hold::Tustin{20.0});
    ASSERT_TRUE(sampled.has_value());
    EXPECT_LT(std::abs(sampled->atFrequency(20.0) - notch.atFrequency(20.0)), 1e-12);
    EXPECT_NEAR(sampled->dcGain(), 1.0, 1e-12);
}

// T h(k T) of 3/(s + 2) is 3 T exp(-2 k T).
TEST(Discretize, theImpulseRuleKeepsTheImpulseResponseAtTheSamples) {
    const double T = 0.1;
    const auto sampled = discretize(continuous({3.0}, {1.0, 2.0}), T, Hold::Impulse{});
    ASSERT_TRUE(sampled.has_value());
    std::vector<double> impulse(20, 0.0);
    impulse.front() = 1.0;
    const auto answer = simulate(*sampled, impulse);
    for (std::size_t k = 0; k < answer.size(); ++k) {
        EXPECT_NEAR(answer[k], 3.0 * T * std::exp(-2.0 * T * static_cast<double>(k)), 1e-15);
    }
    EXPECT_EQ(discretize(continuous({1.0, 1.0}, {1.0, 2.0}), T, Hold::Impulse{}).error().code,
              ErrorCode::InvalidInput);
}

// (s + 1)/((s + 2)(s + 3)): z = e^-0.1 over e^-0.2, e^-0.3, gain 1/6 at rest; the one zero at infinity stays.
TEST(Discretize, matchedPolesAndZerosAreTheExponentials) {
    const double T = 0.1;
    const auto sampled = discretize(continuous({1.0, 1.0}, {1.0, 5.0, 6.0}), T, Hold::Matched{});
    ASSERT_TRUE(sampled.has_value());
    const double K = (1.0 - std::exp(-0.2)) * (1.0 - std::exp(-0.3)) / (1.0 - std::exp(-0.1)) / 6.0;
    const std::complex<double> z = std::polar(1.0, 0.7);
    const auto expected = K * (z - std::exp(-0.1)) / ((z - std::exp(-0.2)) * (z - std::exp(-0.3)));
    EXPECT_LT(std::abs(sampled->at(z) - expected), 1e-13);
}

// Two zeros at infinity: one goes to -1. An integrator keeps its rate: (z - 1)/T G(z) -> 1/2 at z = 1.
TEST(Discretize, matchedIntegratorsKeepTheirRate) {
    const double T = 0.05;
    const auto sampled = discretize(continuous({1.0}, {1.0, 2.0, 0.0}), T, Hold::Matched{});
    ASSERT_TRUE(sampled.has_value());
    const std::complex<double> z(1.0 + 1e-7, 0.0);
    EXPECT_NEAR(((z - 1.0) / T * sampled->at(z)).real(), 0.5, 1e-6); // 1e-7 beside the pole
    EXPECT_LT(std::abs(sampled->at({-1.0, 0.0})), 1e-15);
}

// The other route for random systems: what was sampled comes back, for every rule that can be undone.
TEST(Discretize, everyRuleComesBack) {
    Random random(31);
    const HoldMethod rules[] = {Hold::Zoh{},       Hold::Foh{},     Hold::Tustin{},
                                Hold::Tustin{3.0}, Hold::Impulse{}, Hold::Matched{}};
    for (int round = 0; round < 60; ++round) {
        const bool isDirect = round % 4 == 0;
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(4)), true, isDirect);
        for (const HoldMethod& rule : rules) {
            if (isDirect && std::holds_alternative<Hold::Impulse>(rule)) {
                continue;
            }
            const auto sampled = discretize(toStateSpace(system), 0.02, rule);
            ASSERT_TRUE(sampled.has_value());
            const auto back = toContinuous(*sampled, rule);
            ASSERT_TRUE(back.has_value()) << round << " rule " << rule.index();
            for (const double w : {0.1, 2.0, 20.0}) {
                const auto expected = system.atFrequency(w);
                // The sampled poles lie within 0.006 of 1: some three digits are paid for the way back, and
                // more where the value is the small difference of large parts or several zeros lie at -1
                // (matched).
                const double tolerance = std::holds_alternative<Hold::Matched>(rule) ? 1e-6 : 1e-9;
                EXPECT_LT(std::abs(StatePath(*back).atFrequency(w) - expected),
                          tolerance * (1.0 + std::abs(expected)))
                    << round << " rule " << rule.index();
            }
        }
    }
}

TEST(Discretize, transferFunctionsComeBackToo) {
    const auto system = continuous({2.0, 3.0}, {1.0, 0.4, 5.0});
    for (const HoldMethod& rule : {HoldMethod(Hold::Zoh{}), HoldMethod(Hold::Foh{}),
                                   HoldMethod(Hold::Tustin{}), HoldMethod(Hold::Matched{})}) {
        const auto back = toContinuous(*discretize(system, 0.1, rule), rule);
        ASSERT_TRUE(back.has_value());
        EXPECT_LT(std::abs(back->atFrequency(2.0) - system.atFrequency(2.0)), 1e-10);
    }
}

TEST(Discretize, doesNotInventAContinuousSystem) {
    const TimeBase base = TimeBase::sampled(0.1);
    const auto ringing = *TransferFunction::make({1.0}, {1.0, 0.5}, base);
    EXPECT_EQ(toContinuous(ringing, Hold::Zoh{}).error().code, ErrorCode::Refused);
    EXPECT_EQ(toContinuous(ringing, Hold::Matched{}).error().code, ErrorCode::Refused);
    EXPECT_TRUE(toContinuous(ringing, Hold::Tustin{}).has_value());
    EXPECT_EQ(toContinuous(TransferFunction::delay(1, 0.1), Hold::Foh{}).error().code, ErrorCode::Refused);
    EXPECT_EQ(toContinuous(*TransferFunction::make({1.0}, {1.0, 1.0}, base), Hold::Tustin{}).error().code,
              ErrorCode::Refused);
    EXPECT_EQ(toContinuous(continuous({1.0}, {1.0, 1.0}), Hold::Zoh{}).error().code, ErrorCode::InvalidInput);
}

TEST(Discretize, refusesWhatCannotBeSampled) {
    const auto system = continuous({1.0}, {1.0, 2.0});
    EXPECT_EQ(discretize(system, 0.0, Hold::Zoh{}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(discretize(system, std::numeric_limits<double>::quiet_NaN(), Hold::Zoh{}).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(discretize(system, 0.1, Hold::Tustin{100.0}).error().code, ErrorCode::OutOfRange);
    const auto sampled = discretize(system, 0.1, Hold::Zoh{});
    EXPECT_EQ(discretize(*sampled, 0.1, Hold::Zoh{}).error().code, ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::control
