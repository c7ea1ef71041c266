#include "devices/firmware/control/hb_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

constexpr double Pi = std::numbers::pi;

hb_reference_config shape(hb_shape kind) {
    hb_reference_config config{};
    config.shape = static_cast<std::uint8_t>(kind);
    config.amplitude = 2.0F;
    config.duration_s = 10.0F;
    config.period_s = 1.0F;
    config.count = 5;
    config.frequency_Hz = 0.5F;
    config.frequency_end_Hz = 8.0F;
    return config;
}

struct Point {
    double value, speed, acceleration;
};

/// Runs the generator beside the closed form and compares every millisecond.
void expectShape(const hb_reference_config& config, bool is_position, double tolerance,
                 const std::function<Point(double)>& expected) {
    hb_reference reference{};
    hb_plateau_config plateaus{};
    plateaus.count = 1;
    plateaus.dwell_s = 1.0F;
    hb_reference_start(&reference, &config, &plateaus, is_position ? 1 : 0);
    for (int tick = 0; reference.running; ++tick) {
        const hb_reference_point point = hb_reference_evaluate(&reference);
        const Point want = expected(tick * 1e-3);
        ASSERT_NEAR(static_cast<double>(point.value), want.value, tolerance) << tick;
        if (is_position) {
            ASSERT_NEAR(static_cast<double>(point.speed), want.speed, 60 * tolerance) << tick;
            ASSERT_NEAR(static_cast<double>(point.acceleration), want.acceleration, 3600 * tolerance) << tick;
        }
        hb_reference_advance(&reference);
    }
}

TEST(Reference, makesAStep) {
    expectShape(shape(HB_SHAPE_STEP), true, 0.0, [](double) { return Point{2.0, 0.0, 0.0}; });
}

TEST(Reference, makesARampWithAndWithoutAnEnd) {
    hb_reference_config config = shape(HB_SHAPE_RAMP);
    config.rate = -0.5F;
    expectShape(config, true, 1e-6, [](double t) {
        return t < 4.0 ? Point{-0.5 * t, -0.5, 0.0} : Point{-2.0, 0.0, 0.0};
    });
    config.amplitude = 0.0F;
    expectShape(config, true, 1e-6, [](double t) { return Point{-0.5 * t, -0.5, 0.0}; });
}

TEST(Reference, makesASineThatStartsAtPhaseZero) {
    const hb_reference_config config = shape(HB_SHAPE_SINE);
    const double w = 2 * Pi * 0.5;
    expectShape(config, true, 1e-6, [w](double t) {
        return Point{2 * std::sin(w * t), 2 * w * std::cos(w * t), -2 * w * w * std::sin(w * t)};
    });
}

TEST(Reference, makesAStaircase) {
    hb_reference_config config = shape(HB_SHAPE_STAIRCASE);
    expectShape(config, true, 1e-6, [](double t) {
        return Point{2.0 * (1 + std::floor(t + 1e-9)), 0.0, 0.0};
    });
}

TEST(Reference, countsTheSegmentsOfAStaircaseAndEndsBehindTheLast) {
    hb_reference reference{};
    const hb_reference_config config = shape(HB_SHAPE_STAIRCASE);
    const hb_plateau_config plateaus{};
    hb_reference_start(&reference, &config, &plateaus, 1);
    for (int tick = 0; tick < 5000; ++tick) {
        hb_reference_evaluate(&reference);
        ASSERT_EQ(reference.segment, 1 + tick / 1000);
        ASSERT_EQ(reference.running, 1);
        hb_reference_advance(&reference);
    }
    EXPECT_EQ(reference.running, 0);
    EXPECT_EQ(reference.segment, 0);
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 10.0F); // held
}

TEST(Reference, sweepsAChirpLinearly) {
    const hb_reference_config config = shape(HB_SHAPE_CHIRP);
    // Phase error: 1e4 ticks of up to half a unit of 2^-32 turn plus float frequency, 3e-5 rad on
    // amplitude 2.
    expectShape(config, true, 1e-4, [](double t) {
        const double k = (8.0 - 0.5) / 10.0;
        const double phase = 2 * Pi * (0.5 * t + k * t * t / 2);
        const double w = 2 * Pi * (0.5 + k * t);
        return Point{2 * std::sin(phase), 2 * w * std::cos(phase),
                     2 * 2 * Pi * k * std::cos(phase) - 2 * w * w * std::sin(phase)};
    });
}

TEST(Reference, makesAMultisineWithSchroederPhases) {
    const hb_reference_config config = shape(HB_SHAPE_MULTISINE);
    expectShape(config, true, 1e-4, [](double t) {
        Point sum{0, 0, 0};
        for (int k = 1; k <= 5; ++k) {
            const double w = 2 * Pi * (0.5 + (8.0 - 0.5) * (k - 1) / 4.0);
            const double phase = w * t - Pi * k * (k - 1) / 5.0;
            sum.value += 2 / std::sqrt(5.0) * std::sin(phase);
            sum.speed += 2 / std::sqrt(5.0) * w * std::cos(phase);
            sum.acceleration -= 2 / std::sqrt(5.0) * w * w * std::sin(phase);
        }
        return sum;
    });
}

TEST(Reference, drawsOtherPhasesFromASeedButTheSameEveryTime) {
    const auto run = [](std::uint32_t seed) {
        hb_reference_config config = shape(HB_SHAPE_MULTISINE);
        config.seed = seed;
        const hb_plateau_config plateaus{};
        hb_reference reference{};
        hb_reference_start(&reference, &config, &plateaus, 0);
        for (int i = 0; i < 123; ++i) {
            hb_reference_advance(&reference);
        }
        return hb_reference_evaluate(&reference).value;
    };
    EXPECT_EQ(run(7), run(7));
    EXPECT_NE(run(7), run(8));
    EXPECT_NE(run(7), run(0));
}

TEST(Reference, walksThroughThePlateausAndEndsAtZeroCurrent) {
    hb_reference_config config = shape(HB_SHAPE_PLATEAUS);
    hb_plateau_config plateaus{};
    plateaus.count = 3;
    plateaus.dwell_s = 0.25F;
    plateaus.current_A[0] = 1.5F;
    plateaus.current_A[1] = -2.5F;
    plateaus.current_A[2] = 4.0F;
    hb_reference reference{};
    hb_reference_start(&reference, &config, &plateaus, 0);
    for (int tick = 0; tick < 750; ++tick) {
        ASSERT_EQ(hb_reference_evaluate(&reference).value, plateaus.current_A[tick / 250]);
        ASSERT_EQ(reference.segment, 1 + tick / 250);
        hb_reference_advance(&reference);
    }
    EXPECT_EQ(reference.running, 0);
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 0.0F);
}

TEST(Reference, aStartWhileItRunsBeginsWithTheFirstSegmentAndTimeZero) {
    const hb_reference_config config = shape(HB_SHAPE_STAIRCASE);
    const hb_plateau_config plateaus{};
    hb_reference reference{};
    hb_reference_start(&reference, &config, &plateaus, 1);
    for (int tick = 0; tick < 2500; ++tick) {
        hb_reference_evaluate(&reference);
        hb_reference_advance(&reference);
    }
    EXPECT_EQ(reference.segment, 3);
    hb_reference_start(&reference, &config, &plateaus, 1);
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 8.0F); // the first step from the third
    EXPECT_EQ(reference.segment, 1);
    EXPECT_EQ(reference.ticks, 0U);
    EXPECT_EQ(reference.running, 1);
}

TEST(Reference, aPositionGoesOnFromWhereTheLastOneIsHeld) {
    hb_reference_config config = shape(HB_SHAPE_RAMP);
    config.rate = 0.5F;
    config.amplitude = 0.0F;
    config.duration_s = 1.0F;
    const hb_plateau_config plateaus{};
    hb_reference reference{};
    for (int start = 0; start < 3; ++start) {
        hb_reference_start(&reference, &config, &plateaus, 1);
        EXPECT_EQ(hb_reference_evaluate(&reference).value, 0.5F * static_cast<float>(start));
        for (int tick = 0; tick < 1000; ++tick) {
            hb_reference_advance(&reference);
        }
        EXPECT_EQ(reference.running, 0);
    }
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 1.5F);
    hb_reference_clear(&reference); // entering a mode
    hb_reference_start(&reference, &config, &plateaus, 1);
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 0.0F);
}

TEST(Reference, aCurrentStartsFromZeroEveryTime) {
    const hb_reference_config config = shape(HB_SHAPE_STAIRCASE);
    const hb_plateau_config plateaus{};
    hb_reference reference{};
    for (int start = 0; start < 2; ++start) {
        hb_reference_start(&reference, &config, &plateaus, 0);
        EXPECT_EQ(hb_reference_evaluate(&reference).value, 2.0F);
        for (int tick = 0; tick < 1500; ++tick) {
            hb_reference_advance(&reference);
        }
    }
}

TEST(Reference, addsBaseMotionByMode) {
    hb_reference_config config = shape(HB_SHAPE_NONE);
    config.base = 3.0F;
    // 30 at the end: float has steps of 1.9e-6 there, and time is rounded likewise
    expectShape(config, true, 4e-6, [](double t) { return Point{3.0 * t, 3.0, 0.0}; });
    expectShape(config, false, 0.0, [](double) { return Point{3.0, 0.0, 0.0}; });
}

TEST(Reference, keepsTheSettingsOfItsStart) {
    hb_reference_config config = shape(HB_SHAPE_STEP);
    const hb_plateau_config plateaus{};
    hb_reference reference{};
    hb_reference_start(&reference, &config, &plateaus, 1);
    config.amplitude = 99.0F;
    EXPECT_EQ(hb_reference_evaluate(&reference).value, 2.0F);
}

} // namespace
