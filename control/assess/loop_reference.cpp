#include "control/assess/loop_reference.h"

#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

ReferencePoint evaluateReference(const LoopReference& reference, double time_s) {
    switch (reference.shape) {
    case LoopReference::Shape::Step:
        return {reference.amplitude_rad, 0.0, 0.0};
    case LoopReference::Shape::Ramp: {
        const double reached_rad = reference.rate_rad_s * time_s;
        const double end_rad = std::fabs(reference.amplitude_rad);
        if (end_rad > 0.0 && std::fabs(reached_rad) >= end_rad) {
            return {std::copysign(end_rad, reference.rate_rad_s), 0.0, 0.0};
        }
        return {reached_rad, reference.rate_rad_s, 0.0};
    }
    case LoopReference::Shape::Sine: {
        const double omega_rad_s = 2.0 * Pi * reference.frequency_Hz;
        const double sine = std::sin(omega_rad_s * time_s);
        return {reference.amplitude_rad * sine,
                reference.amplitude_rad * omega_rad_s * std::cos(omega_rad_s * time_s),
                -reference.amplitude_rad * omega_rad_s * omega_rad_s * sine};
    }
    case LoopReference::Shape::Staircase: {
        const double steps =
            1.0 + std::floor(time_s / reference.period_s + 1e-9); // exact multiples count as begun
        return {reference.amplitude_rad * std::min(steps, static_cast<double>(reference.count)), 0.0, 0.0};
    }
    }
    return {};
}

} // namespace halbench::control
