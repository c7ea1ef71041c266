#include "control/base/random.h"
#include "control/identify/transient_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

// resources/help/htm-theory.md section 2, over J
constexpr double A = 1.23e-3 / 5.5e-4;
constexpr double F = 2.05e-2 / 5.5e-4;
constexpr double K = 26.0;
constexpr double Noise_rad = 0.06 * M_PI / 180.0;

// Closed forms of section 7.3 at 100 Hz.
TransientRecord coastDown(double speed, double noise, Random& random) {
    TransientRecord record;
    const double stop = std::log1p(A * speed / F) / A;
    for (int i = 0; i < 60; ++i) {
        const double t = i * 0.01;
        const double moving = std::min(t, stop);
        record.time_s.push_back(t);
        record.angle_rad.push_back(0.7 - F / A * moving + (speed + F / A) * -std::expm1(-A * moving) / A +
                                   noise * random.gaussian());
    }
    return record;
}

TransientRecord runUp(double current, double noise, Random& random, int samples = 300,
                      bool knowsRest = true) {
    TransientRecord record;
    record.current_A = current;
    record.startsAtRest = knowsRest;
    const double w = (K * current - F) / A;
    for (int i = 0; i < samples; ++i) {
        const double t = i * 0.01;
        record.time_s.push_back(t);
        record.angle_rad.push_back(-0.2 + w * t - w * -std::expm1(-A * t) / A + noise * random.gaussian());
    }
    return record;
}

TEST(TransientFit, returnsTheTruthOnNoiseFreeData) {
    Random random(1);
    const std::vector<TransientRecord> records{runUp(2.0, 0.0, random), runUp(3.0, 0.0, random),
                                               runUp(4.0, 0.0, random), coastDown(28.0, 0.0, random)};
    const auto fit = fitTransients(records);
    ASSERT_TRUE(fit && fit->torque_rad_s2_A);
    // property 10 of resources/help/htm-theory.md section 10
    EXPECT_NEAR(fit->damping_per_s / A, 1.0, 1e-9);
    EXPECT_NEAR(fit->friction_rad_s2 / F, 1.0, 1e-9);
    EXPECT_NEAR(*fit->torque_rad_s2_A / K, 1.0, 1e-9);
}

struct Spread {
    double damping = 0.0;
    double friction = 0.0;
    double correlation = 0.0;
};

Spread spreadOfCoastDowns(double speed, int runs) {
    Random random(7);
    Spread spread;
    double product = 0.0;
    for (int i = 0; i < runs; ++i) {
        const auto fit = fitTransients(std::vector<TransientRecord>{coastDown(speed, Noise_rad, random)});
        EXPECT_TRUE(fit);
        const double a = fit->damping_per_s / A - 1.0;
        const double f = fit->friction_rad_s2 / F - 1.0;
        spread.damping += a * a / runs;
        spread.friction += f * f / runs;
        product += a * f / runs;
    }
    spread.damping = std::sqrt(spread.damping);
    spread.friction = std::sqrt(spread.friction);
    spread.correlation = product / (spread.damping * spread.friction);
    return spread;
}

TEST(TransientFit, oneCoastDownIsAsPreciseAsTheTheorySays) {
    // resources/help/htm-theory.md section 7.3; a spread from 150 runs is known to 6 %: three sigma and the
    // rounding of the printed figure make 22 %
    const Spread fast = spreadOfCoastDowns(28.0, 150);
    EXPECT_NEAR(fast.damping / 0.0033, 1.0, 0.22);
    EXPECT_NEAR(fast.friction / 0.0021, 1.0, 0.22);
    EXPECT_NEAR(fast.correlation, -0.98, 0.02); // (1 - r^2)/sqrt(150), and the last digit
    const Spread slow = spreadOfCoastDowns(10.0, 150);
    EXPECT_NEAR(slow.damping / 0.054, 1.0, 0.22);
    EXPECT_NEAR(slow.friction / 0.014, 1.0, 0.22);
}

TEST(TransientFit, runUpsAndACoastDownGiveAllRatiosToTwoParts) {
    Random random(3);
    // run-ups of one second, start speed unknown: the theory does not say how long they were
    const std::vector<TransientRecord> records{
        runUp(2.0, Noise_rad, random, 100, false), runUp(3.0, Noise_rad, random, 100, false),
        runUp(4.0, Noise_rad, random, 100, false), coastDown(28.0, Noise_rad, random)};
    const auto fit = fitTransients(records);
    ASSERT_TRUE(fit && fit->torque_rad_s2_A);
    // "about 2e-4" each, 1 sigma, within a factor of two and a half; the error itself within four sigma
    for (const auto& [value, truth, place] :
         {std::tuple(fit->damping_per_s, A, 0), std::tuple(fit->friction_rad_s2, F, 1),
          std::tuple(*fit->torque_rad_s2_A, K, 2)}) {
        const double sigma = std::sqrt(fit->covariance(place, place)) / truth;
        EXPECT_GT(sigma, 0.5e-4);
        EXPECT_LT(sigma, 4e-4);
        EXPECT_LT(std::fabs(value / truth - 1.0), 4.0 * sigma);
    }
    EXPECT_NEAR(fit->angleNoise_rad / Noise_rad, 1.0, 0.08); // 360 rows: two of 3.8 %
}

TEST(TransientFit, runUpsAtOneCurrentAreRefused) {
    Random random(4);
    const auto fit = fitTransients(
        std::vector<TransientRecord>{runUp(3.0, Noise_rad, random), runUp(3.0, Noise_rad, random)});
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, ErrorCode::Refused);
    EXPECT_FALSE(fitTransients({}));
}

} // namespace
} // namespace halbench::control
