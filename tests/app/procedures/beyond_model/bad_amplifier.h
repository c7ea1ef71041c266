#pragma once

#include "tests/app/procedures/beyond_model/beyond_model.h"

namespace halbench::app {

/// Motors at random that the model describes.
inline RecordedMotor healthyMotor(Random& random) {
    const auto between = [&random](double low, double high) {
        return low * std::exp(random.uniform() * std::log(high / low));
    };
    RecordedMotor motor;
    motor.inertia_kg_m2 = between(3e-4, 8e-4);
    motor.damping_Nm_s = between(8e-4, 2.4e-3);
    motor.friction_Nm = between(8e-3, 2.6e-2);
    motor.torque_Nm_per_A = between(1.1e-2, 2.1e-2);
    return motor;
}

/// One of them on an amplifier, or with bearings, of the `kind` modulo eight.
inline RecordedMotor motorOnABadAmplifier(std::uint64_t seed) {
    Random random(31000 + seed);
    const auto between = [&random](double low, double high) { return low + random.uniform() * (high - low); };
    RecordedMotor motor = healthyMotor(random);
    const double size = between(0.0, 1.0);
    switch (seed % 8) {
    case 0: { // clipped, the same both ways
        const double limit_A = 2.0 + 1.9 * size;
        motor.amplifier = [limit_A](double current_A, double) {
            return std::clamp(current_A, -limit_A, limit_A);
        };
        motor.text = fmt::format("clip {:.2f}", limit_A);
        break;
    }
    case 1: { // clipped in one direction
        const double limit_A = 2.0 + 1.9 * size;
        const bool isForward = random.below(2) == 0;
        motor.amplifier = [limit_A, isForward](double current_A, double) {
            return isForward ? std::min(current_A, limit_A) : std::max(current_A, -limit_A);
        };
        motor.text = fmt::format("clip {} {:.2f}", isForward ? "forward" : "reverse", limit_A);
        break;
    }
    case 2: { // a gain for each direction
        const double gain = 0.7 + 0.29 * size;
        motor.amplifier = [gain](double current_A, double) {
            return current_A < 0.0 ? gain * current_A : current_A;
        };
        motor.text = fmt::format("gain reverse {:.2f}", gain);
        break;
    }
    case 3: { // dead zone
        const double dead_A = 0.02 + 0.6 * size;
        motor.amplifier = [dead_A](double current_A, double) {
            return std::copysign(std::max(std::fabs(current_A) - dead_A, 0.0), current_A);
        };
        motor.text = fmt::format("dead zone {:.2f}", dead_A);
        break;
    }
    case 4: { // soft saturation
        const double scale_A = 3.0 + 9.0 * size;
        motor.amplifier = [scale_A](double current_A, double) {
            return scale_A * std::tanh(current_A / scale_A);
        };
        motor.text = fmt::format("tanh {:.2f}", scale_A);
        break;
    }
    case 5: { // bearings loaded by the torque
        motor.loadFriction_Nm_A2 = motor.torque_Nm_per_A * (0.005 + 0.08 * size);
        motor.text = fmt::format("load {:.3f}", motor.loadFriction_Nm_A2 / motor.torque_Nm_per_A);
        break;
    }
    case 6: { // supply of `limit_A` ohms, which the back-EMF of `perSpeed` takes off
        const double limit_A = 3.0 + 3.0 * size;
        const double perSpeed = between(0.02, 0.15);
        motor.amplifier = [limit_A, perSpeed](double current_A, double speed_rad_s) {
            const double most_A = std::max(limit_A - perSpeed * std::fabs(speed_rad_s), 0.0);
            return std::clamp(current_A, -most_A, most_A);
        };
        motor.text = fmt::format("supply {:.2f} A - {:.3f} w", limit_A, perSpeed);
        break;
    }
    default: { // gain that bends with the current
        const double bend_per_A = (random.below(2) == 0 ? -1.0 : 1.0) * (0.005 + 0.08 * size);
        motor.amplifier = [bend_per_A](double current_A, double) {
            return current_A * (1.0 + bend_per_A * std::fabs(current_A));
        };
        motor.text = fmt::format("bend {:.3f}", bend_per_A);
        break;
    }
    }
    return motor;
}

/// How many are good and yet wrong; each is told.
inline int countWrongAndGoodOnBadAmplifiers(std::uint64_t firstSeed, std::uint64_t lastSeed) {
    int wrong = 0;
    for (std::uint64_t seed = firstSeed; seed <= lastSeed; ++seed) {
        const BeyondModelOutcome outcome = identifiedBeyondTheModel(motorOnABadAmplifier(seed), seed);
        if (outcome.isGood && !outcome.isRight) {
            fmt::print("seed {}:{}\n", seed, outcome.text);
            ++wrong;
        }
    }
    return wrong;
}

} // namespace halbench::app
