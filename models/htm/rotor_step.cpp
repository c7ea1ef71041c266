#include "models/htm/rotor_step.h"

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

RotorLag lagOver(const Motion& motion, double t) {
    const double x = motion.damping_per_s * t;
    return {lagMean(x), lagRamp(x), std::exp(-x)};
}

double travel_rad(const Motion& motion, const RotorLag& lag, double speed_rad_s, double t) {
    return t * (speed_rad_s * lag.mean + motion.acceleration_rad_s2 * t * lag.ramp);
}

/// The integral of omega^2 over t.
double squareIntegral_rad2_s(const Motion& motion, const RotorLag& lag, double w0, double t) {
    const double x = motion.damping_per_s * t;
    const double a0 = motion.acceleration_rad_s2;
    return t *
           (w0 * w0 * lagMean(2.0 * x) + w0 * a0 * t * lag.mean * lag.mean + a0 * a0 * t * t * lagSquare(x));
}

} // namespace

template <typename OnStretch>
void RotorStep::follow(RotorState& state, double torque_Nm, OnStretch onStretch) const {
    double left_s = m_duration_s;
    while (left_s > 0.0) {
        double direction = std::copysign(1.0, state.speed_rad_s);
        if (state.speed_rad_s == 0.0) {
            direction = std::copysign(1.0, torque_Nm);
            if (std::fabs(torque_Nm) <= staticFriction_Nm(m_config, state, direction)) {
                return;
            }
        }
        const double friction_Nm = direction * kineticFriction_Nm(m_config, state, direction);
        const Motion motion{(torque_Nm - friction_Nm) / m_config.inertia_kg_m2,
                            m_config.viscousDamping_Nm_s / m_config.inertia_kg_m2};
        const double rest_s = timeOfRest_s(motion, state.speed_rad_s);
        const double t = std::fmin(left_s, rest_s);
        const RotorLag lag = t == m_duration_s ? m_whole : lagOver(motion, t);
        const double way_rad = travel_rad(motion, lag, state.speed_rad_s, t);
        onStretch(motion, lag, friction_Nm, t, way_rad);
        state.angle_rad += way_rad;
        state.speed_rad_s = rest_s <= left_s
                                ? 0.0
                                : state.speed_rad_s * lag.decay + motion.acceleration_rad_s2 * t * lag.mean;
        left_s -= t;
    }
}

RotorStep::RotorStep(const RotorConfig& config, double duration_s)
    : m_config(config), m_duration_s(duration_s),
      m_whole(lagOver({0.0, config.viscousDamping_Nm_s / config.inertia_kg_m2}, duration_s)) {
    HB_ASSERT(config.inertia_kg_m2 > 0.0 && duration_s >= 0.0);
}

void RotorStep::move(RotorState& state, double torque_Nm) const {
    follow(state, torque_Nm, [](const Motion&, const RotorLag&, double, double, double) {});
}

RotorEnergy RotorStep::moveCounted(RotorState& state, double torque_Nm) const {
    RotorEnergy energy;
    follow(state, torque_Nm,
           [&](const Motion& motion, const RotorLag& lag, double friction_Nm, double t, double way_rad) {
               energy.electricalWork_J += torque_Nm * way_rad;
               energy.frictionLoss_J += friction_Nm * way_rad;
               energy.viscousLoss_J +=
                   m_config.viscousDamping_Nm_s * squareIntegral_rad2_s(motion, lag, state.speed_rad_s, t);
           });
    return energy;
}

} // namespace halbench::models
