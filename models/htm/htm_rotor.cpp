#include "models/htm/htm_rotor.h"

#include "control/base/assert.h"

#include <cmath>
#include <limits>

namespace halbench::models {
namespace {

// (1 - e^-x)/x and (x - 1 + e^-x)/x^2: the shape functions of a first-order lag, smooth through x = 0 (no
// viscous friction). Below 1/16 the alternating series is summed: 9 terms leave less than 1e-17.
double lagMean(double x) {
    return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

double seriesFrom(double x, int firstFactorial, double (*weight)(int)) {
    double power = 1.0;
    double factorial = 1.0;
    for (int i = 2; i <= firstFactorial; ++i) {
        factorial *= i;
    }
    double sum = 0.0;
    for (int n = 0; n < 9; ++n) {
        sum += weight(n) * power / factorial;
        power *= -x;
        factorial *= firstFactorial + n + 1;
    }
    return sum;
}

double lagRamp(double x) {
    if (x < 0.0625) {
        return seriesFrom(x, 2, [](int) { return 1.0; });
    }
    return (x - 1.0 + std::exp(-x)) / (x * x);
}

// (1 - 2 lagMean(x) + lagMean(2x))/x^2: mean square of the lag's step response over (a t)^2.
double lagSquare(double x) {
    if (x < 0.0625) {
        return seriesFrom(x, 3, [](int n) { return std::ldexp(1.0, n + 2) - 2.0; });
    }
    return (1.0 - 2.0 * lagMean(x) + lagMean(2.0 * x)) / (x * x);
}

// Acceleration a0 without damping, damping rate a: motion until the next event.
struct Motion {
    double acceleration_rad_s2;
    double damping_per_s;
};

double timeOfRest_s(const Motion& motion, double speed_rad_s) {
    const double ratio_s = -speed_rad_s / motion.acceleration_rad_s2;
    if (!(ratio_s > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    return motion.damping_per_s == 0.0 ? ratio_s
                                       : std::log1p(motion.damping_per_s * ratio_s) / motion.damping_per_s;
}

struct Travel {
    double angle_rad;
    double speed_rad_s;
    double squareIntegral_rad2_s; // integral of omega^2
};

Travel travel(const Motion& motion, double speed_rad_s, double t) {
    const double x = motion.damping_per_s * t;
    const double mean = lagMean(x);
    const double a0 = motion.acceleration_rad_s2;
    const double w0 = speed_rad_s;
    return {t * (w0 * mean + a0 * t * lagRamp(x)), w0 * std::exp(-x) + a0 * t * mean,
            t * (w0 * w0 * lagMean(2.0 * x) + w0 * a0 * t * mean * mean + a0 * a0 * t * t * lagSquare(x))};
}

double frictionHere_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    const double perTurn =
        config.perTurn_ratio == 0.0
            ? 1.0
            : 1.0 + config.perTurn_ratio * std::sin(state.angle_rad + config.perTurnPhase_rad);
    return config.coulombFriction_Nm * state.friction_ratio * perTurn *
           (1.0 + direction * config.asymmetry_ratio);
}

} // namespace

double kineticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    const double friction = frictionHere_Nm(config, state, direction);
    if (config.stribeckSpeed_rad_s == 0.0) {
        return friction;
    }
    const double ratio = state.speed_rad_s / config.stribeckSpeed_rad_s;
    return friction * (1.0 + (config.staticFriction_ratio - 1.0) * std::exp(-ratio * ratio));
}

double staticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    return config.staticFriction_ratio * frictionHere_Nm(config, state, direction);
}

RotorEnergy stepRotor(const RotorConfig& config, RotorState& state, double torque_Nm, double duration_s) {
    HB_ASSERT(config.inertia_kg_m2 > 0.0 && duration_s >= 0.0);
    RotorEnergy energy;
    double left_s = duration_s;
    while (left_s > 0.0) {
        double direction = std::copysign(1.0, state.speed_rad_s);
        if (state.speed_rad_s == 0.0) {
            direction = std::copysign(1.0, torque_Nm);
            if (std::fabs(torque_Nm) <= staticFriction_Nm(config, state, direction)) {
                return energy;
            }
        }
        const double friction_Nm = kineticFriction_Nm(config, state, direction);
        const Motion motion{(torque_Nm - direction * friction_Nm) / config.inertia_kg_m2,
                            config.viscousDamping_Nm_s / config.inertia_kg_m2};
        const double rest_s = timeOfRest_s(motion, state.speed_rad_s);
        const double t = std::fmin(left_s, rest_s);
        const Travel way = travel(motion, state.speed_rad_s, t);
        energy.electricalWork_J += torque_Nm * way.angle_rad;
        energy.frictionLoss_J += direction * friction_Nm * way.angle_rad;
        energy.viscousLoss_J += config.viscousDamping_Nm_s * way.squareIntegral_rad2_s;
        state.angle_rad += way.angle_rad;
        state.speed_rad_s = rest_s <= left_s ? 0.0 : way.speed_rad_s;
        left_s -= t;
    }
    return energy;
}

double kineticEnergy_J(const RotorConfig& config, const RotorState& state) {
    return 0.5 * config.inertia_kg_m2 * state.speed_rad_s * state.speed_rad_s;
}

} // namespace halbench::models
