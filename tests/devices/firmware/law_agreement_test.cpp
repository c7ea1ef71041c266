#include "control/base/random.h"
#include "control/law/board_law_run.h"
#include "devices/firmware/control/hb_law.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

// The host's position law against the board's C, in single precision: not a bit may differ.

namespace halbench::control {
namespace {

using Law = BoardLaw<float>;

float uniform(Random& random, double low, double high) {
    return static_cast<float>(low + (high - low) * random.uniform());
}

/// A stable section: roots of d^2 + a1 d + a2 from two poles within the unit circle.
LawSection<float> randomSection(Random& random) {
    const double radius = 0.2 + 0.79 * random.uniform();
    const double angle = 3.0 * random.uniform();
    const double real = 1.0 - radius * std::cos(angle);
    const double imaginary = radius * std::sin(angle);
    LawSection<float> section;
    section.a1 = static_cast<float>(2.0 * real);
    section.a2 = static_cast<float>(real * real + imaginary * imaginary);
    section.b0 = uniform(random, 0.1, 2.0);
    section.b1 = uniform(random, -1.0, 1.0);
    section.b2 = uniform(random, 0.0, 0.5);
    return section;
}

Law randomLaw(Random& random) {
    const auto maybe = [&](double low, double high) {
        return random.uniform() < 0.5 ? 0.0F : uniform(random, low, high);
    };
    Law law;
    law.form = random.uniform() < 0.8   ? Law::Form::Positional
               : random.uniform() < 0.5 ? Law::Form::LiteralDifference
                                        : Law::Form::LiteralClampedMemory;
    law.kp_A_per_rad = uniform(random, 0.0, 60.0);
    law.ki_A_per_rad_s = maybe(0.0, 100.0);
    law.kd_As_per_rad = maybe(0.0, 2.0);
    law.referenceWeight = random.uniform() < 0.5 ? 1.0F : uniform(random, 0.0, 1.0);
    law.derivativeReferenceWeight = maybe(0.0, 1.0);
    law.derivativeFilter_s = maybe(1e-4, 0.1);
    for (int i = 0; i < HB_LAW_SECTIONS && random.uniform() < 0.5; ++i) {
        law.sections.push_back(randomSection(random));
    }
    law.inertia_As2_per_rad = maybe(0.0, 0.1);
    law.viscous_As_per_rad = maybe(0.0, 0.2);
    law.coulomb_A = maybe(0.0, 2.0);
    law.coulombSpeed_rad_s = uniform(random, 0.001, 1.0);
    law.stiction_A = maybe(0.0, 1.0);
    law.stictionThreshold_rad = uniform(random, 0.0, 0.1);
    law.stictionSpeed_rad_s = uniform(random, 0.0, 1.0);
    law.limit_A = uniform(random, 0.5, 5.0);
    law.period_s = uniform(random, 1e-3, 2e-2);
    law.delaySamples = static_cast<int>(3.0 * random.uniform());
    return law;
}

hb_law_config configOf(const Law& law) {
    hb_law_config config{};
    config.law = static_cast<std::uint8_t>(law.form);
    config.kp_A_per_rad = law.kp_A_per_rad;
    config.ki_A_per_rad_s = law.ki_A_per_rad_s;
    config.kd_As_per_rad = law.kd_As_per_rad;
    config.reference_weight = law.referenceWeight;
    config.derivative_reference_weight = law.derivativeReferenceWeight;
    config.derivative_filter_s = law.derivativeFilter_s;
    for (std::size_t i = 0; i < HB_LAW_SECTIONS; ++i) {
        const LawSection<float> section = i < law.sections.size() ? law.sections[i] : LawSection<float>();
        config.sections[i] = {section.b0, section.b1, section.b2, section.a1, section.a2};
    }
    config.inertia_As2_per_rad = law.inertia_As2_per_rad;
    config.viscous_As_per_rad = law.viscous_As_per_rad;
    config.coulomb_A = law.coulomb_A;
    config.coulomb_speed_rad_s = law.coulombSpeed_rad_s;
    config.stiction_A = law.stiction_A;
    config.stiction_threshold_rad = law.stictionThreshold_rad;
    config.stiction_speed_rad_s = law.stictionSpeed_rad_s;
    config.limit_A = law.limit_A;
    config.period_s = law.period_s;
    config.delay_samples = static_cast<std::uint8_t>(law.delaySamples);
    return config;
}

TEST(LawAgreement, hostAndBoardAreTheSameToTheBitOverRandomRuns) {
    Random random(20);
    for (int run = 0; run < 500; ++run) {
        const Law law = randomLaw(random);
        const hb_law_config config = configOf(law);
        BoardLawRun<float> host(law);
        hb_law board;
        hb_law_reset(&board);
        float reference_rad = uniform(random, -1.0, 1.0);
        float angle_rad = uniform(random, -1.0, 1.0);
        host.restAt(reference_rad, angle_rad);
        for (int sample = 0; sample < 400; ++sample) {
            const bool isMoving = random.uniform() < 0.5;
            const LawReference<float> reference{reference_rad, isMoving ? uniform(random, -2.0, 2.0) : 0.0F,
                                                isMoving ? uniform(random, -9.0, 9.0) : 0.0F};
            const bool isSaturated = random.uniform() < 0.1;
            const hb_law_input input{angle_rad, reference.value_rad, reference.speed_rad_s,
                                     reference.acceleration_rad_s2, static_cast<std::uint8_t>(isSaturated)};
            const float expected_A = hb_law_step(&board, &config, &input);
            const float found_A = host.step(reference, angle_rad, isSaturated);
            ASSERT_EQ(std::bit_cast<std::uint32_t>(found_A), std::bit_cast<std::uint32_t>(expected_A))
                << "run " << run << ", sample " << sample << ": " << found_A << " A, board " << expected_A;
            angle_rad += uniform(random, -0.05, 0.05);
            if (random.uniform() < 0.05) {
                reference_rad = uniform(random, -1.0, 1.0);
            }
        }
    }
}

// A slow filter in single precision: a low-pass of 0.02 Hz at 100 Hz passes a constant as it does in double
// precision. In powers of z its coefficients would have no digits left for 1 + a1 + a2 = 1.6e-6.
TEST(LawAgreement, slowFilterKeepsItsGainInSinglePrecision) {
    constexpr double Corner_rad_s = 2.0 * 3.14159265358979 * 0.02;
    constexpr double Period_s = 0.01;
    const double t = std::tan(0.5 * Corner_rad_s * Period_s);
    // (w/(s + w))^2 by Tustin's rule: with s = w/t d/(d + 2) it is t^2 (d + 2)^2/((1 + t) d + 2 t)^2.
    const double lead = (1.0 + t) * (1.0 + t);
    Law law;
    law.kp_A_per_rad = 1.0F;
    law.ki_A_per_rad_s = 0.0F;
    law.sections.push_back({static_cast<float>(t * t / lead), static_cast<float>(4.0 * t * t / lead),
                            static_cast<float>(4.0 * t * t / lead), static_cast<float>(4.0 * t / (1.0 + t)),
                            static_cast<float>(4.0 * t * t / lead)});
    hb_law board;
    hb_law_reset(&board);
    const hb_law_config config = configOf(law);
    const hb_law_input input{0.0F, 1.0F, 0.0F, 0.0F, 0};
    double largest = 0.0;
    for (int sample = 1; sample <= 10000; ++sample) {
        const double current_A = static_cast<double>(hb_law_step(&board, &config, &input));
        // Between the samples k - 1 and k, to which the rule of trapezoids belongs; the rule itself is off by
        // a share of w T/2 = 6e-4 of the slope.
        const double x = Corner_rad_s * Period_s * (sample - 0.5);
        largest = std::max(largest, std::abs(current_A - (1.0 - (1.0 + x) * std::exp(-x))));
    }
    EXPECT_LT(largest, 1e-3);
}

} // namespace
} // namespace halbench::control
