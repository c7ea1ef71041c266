#pragma once

#include "tests/app/procedures/recorded_motor.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

/// Motors at random, each with one or two things that the model lacks.
inline RecordedMotor motorBeyondTheModel(std::uint64_t seed) {
    Random random(9000 + seed);
    const auto between = [&random](double low, double high) {
        return low * std::exp(random.uniform() * std::log(high / low));
    };
    RecordedMotor motor;
    motor.inertia_kg_m2 = between(3e-4, 8e-4);
    motor.damping_Nm_s = between(8e-4, 2.4e-3);
    motor.friction_Nm = between(8e-3, 2.6e-2);
    motor.torque_Nm_per_A = between(1.1e-2, 2.1e-2);
    const auto isDrawn = [&random](std::uint64_t one) { return random.below(one) == 0; };
    const std::uint64_t kind = seed % 5;
    if (kind == 0 || isDrawn(8)) { // at 25 rad/s 5 to 80 % of the viscous torque
        motor.square_Nm_s2 = between(0.05, 0.8) * motor.damping_Nm_s / 25.0;
        motor.text += fmt::format(" square {:.2f}", motor.square_Nm_s2 * 25.0 / motor.damping_Nm_s);
    }
    if (kind == 1 || isDrawn(8)) {
        motor.stribeck_ratio = 1.0 + between(0.1, 1.5);
        motor.stribeckSpeed_rad_s = between(0.5, 10.0);
        motor.static_ratio = motor.stribeck_ratio;
        motor.text +=
            fmt::format(" Stribeck {:.2f} at {:.2f}", motor.stribeck_ratio, motor.stribeckSpeed_rad_s);
    }
    if (kind == 2 || isDrawn(8)) {
        motor.static_ratio = std::max(motor.static_ratio, between(1.3, 2.5));
        motor.text += fmt::format(" static {:.2f}", motor.static_ratio);
    }
    if (kind == 3 || isDrawn(8)) {
        motor.asymmetry_ratio = (isDrawn(2) ? -1.0 : 1.0) * between(0.03, 0.3);
        motor.text += fmt::format(" asymmetry {:.2f}", motor.asymmetry_ratio);
    }
    if (kind == 4 || isDrawn(8)) {
        for (int order = 1; order <= 6; ++order) {
            motor.perTurn_ratio.push_back(isDrawn(2) ? between(0.03, 0.3) : 0.0);
            motor.text += fmt::format(" turn{} {:.2f}", order, motor.perTurn_ratio.back());
        }
    }
    return motor;
}

/// Verdict, and whether c, K_f and phi lie within three standard errors, 1.53 of the half width of 95 %: of
/// 600 intervals two miss that by chance.
struct BeyondModelOutcome {
    bool isGood = false;
    bool isRight = true;
    std::string text;
};

inline BeyondModelOutcome identifiedBeyondTheModel(const RecordedMotor& motor, std::uint64_t seed) {
    IdentifyConfig config;
    config.given.inertia_kg_m2 = motor.inertia_kg_m2;
    config.seed = seed;
    const auto result = identifyRecording(recordedExcitation(motor, seed, config), config);
    BeyondModelOutcome outcome;
    if (!result) {
        outcome.text = result.error().message;
        return outcome;
    }
    outcome.isGood = result->quality.verdict == Verdict::Good;
    outcome.text = motor.text;
    const auto judge = [&outcome](const char* name, const control::Estimate& estimate, double truth) {
        if (!estimate.interval95) {
            return;
        }
        const double half = 0.5 * (estimate.interval95->second - estimate.interval95->first);
        const double error = *estimate.value - truth;
        outcome.isRight = outcome.isRight && std::fabs(error) < 1.53 * half;
        outcome.text +=
            fmt::format(" {} {:+.2f} % = {:+.2f} half widths", name, 100.0 * error / truth, error / half);
    };
    judge("c", result->viscousDamping, motor.damping_Nm_s);
    judge("Kf", result->coulombFriction, motor.friction_Nm);
    judge("phi", result->torqueConstant, motor.torque_Nm_per_A);
    for (const Finding& finding : result->quality.findings) {
        outcome.text += " " + finding.code;
    }
    return outcome;
}

/// How many are good and yet wrong; each is told.
inline int countWrongAndGood(std::uint64_t firstSeed, std::uint64_t lastSeed) {
    int wrong = 0;
    for (std::uint64_t seed = firstSeed; seed <= lastSeed; ++seed) {
        const BeyondModelOutcome outcome = identifiedBeyondTheModel(motorBeyondTheModel(seed), seed);
        if (outcome.isGood && !outcome.isRight) {
            fmt::print("seed {}:{}\n", seed, outcome.text);
            ++wrong;
        }
    }
    return wrong;
}

} // namespace halbench::app
