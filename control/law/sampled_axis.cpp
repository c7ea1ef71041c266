#include "control/law/sampled_axis.h"

#include <cmath>

namespace halbench::control {

double heldSpeedShare(double x) {
    return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

double heldAngleShare(double x) {
    if (std::abs(x) > 0.5) {
        return (x + std::expm1(-x)) / (x * x);
    }
    // sum (-x)^n/(n+2)!: 16 terms leave less than 1e-19 at |x| = 0.5
    double term = 0.5;
    double sum = 0.0;
    for (int n = 0; n < 16; ++n) {
        sum += term;
        term *= -x / static_cast<double>(n + 3);
    }
    return sum;
}

SampledAxis::SampledAxis(const PositionPlant& plant, double interval_s) {
    const double x = plant.dampingRate_1_s * interval_s;
    decay_ratio = std::exp(-x);
    coast_s = interval_s * heldSpeedShare(x);
    drive_rad_s_A = plant.accelerationGain_rad_s2_A * coast_s;
    push_rad_A = plant.accelerationGain_rad_s2_A * interval_s * interval_s * heldAngleShare(x);
}

RotorState advance(const PositionPlant& plant, const RotorState& state, double current_A, double time_s) {
    const double x = plant.dampingRate_1_s * time_s;
    const double acceleration_rad_s2 = plant.accelerationGain_rad_s2_A * current_A;
    const double coasting_s = time_s * heldSpeedShare(x);
    return {state.angle_rad + state.speed_rad_s * coasting_s +
                acceleration_rad_s2 * time_s * time_s * heldAngleShare(x),
            state.speed_rad_s * std::exp(-x) + acceleration_rad_s2 * coasting_s};
}

} // namespace halbench::control
