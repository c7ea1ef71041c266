#pragma once

#include "control/law/sampled_axis.h"
#include "control/robustness/batch_simulation.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// Exact motion of a few rotors over an interval of constant current, as `advance` has it. Lanes beyond the
/// last rotor repeat it.
struct BatchAxis {
    using Lanes = BatchState::Lanes;

    Lanes decay_ratio;   ///< of the speed
    Lanes coast_s;       ///< angle per speed
    Lanes drive_rad_s_A; ///< speed per current
    Lanes push_rad_A;    ///< angle per current

    BatchAxis(const std::vector<PositionPlant>& plants, std::size_t first, double interval_s) {
        for (int i = 0; i < LaneWidth; ++i) {
            const SampledAxis rotor(plants[std::min(first + static_cast<std::size_t>(i), plants.size() - 1)],
                                    interval_s);
            decay_ratio[i] = rotor.decay_ratio;
            coast_s[i] = rotor.coast_s;
            drive_rad_s_A[i] = rotor.drive_rad_s_A;
            push_rad_A[i] = rotor.push_rad_A;
        }
    }

    void move(Lanes& angle_rad, Lanes& speed_rad_s, const Lanes& current_A) const {
        angle_rad += speed_rad_s * coast_s + push_rad_A * current_A;
        speed_rad_s = speed_rad_s * decay_ratio + drive_rad_s_A * current_A;
    }
};

} // namespace halbench::control
