#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"

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
