#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <vector>

namespace halbench::app {

/// A move as it was measured, from the start of its reference, the rotor at rest before; rows 1 ms apart,
/// angles from where the rotor was.
struct RecordedMove {
    std::vector<double> reference_rad;
    std::vector<double> position_rad;
    std::vector<double> current_A; ///< asked for, held after that instant

    std::size_t rows() const { return position_rad.size(); }
};

/// Of a recording with position, reference and current_command, from where reference.running says that the
/// reference begins, if it says that. Rows farther apart than 1 ms are put on it: the angle on straight
/// lines, the rest held. Errors: InvalidInput (a signal is missing, rows are missing, too short), NotFinite,
/// Refused (the rotor moves already when the recording begins).
Result<RecordedMove> recordedMove(const Recording& recording);

/// What remains of a recorded motion when a motor and its currents are taken away.
struct MotionRemainder {
    std::vector<double> acceleration_rad_s2; ///< all four smoothed alike
    std::vector<double> speed_rad_s;
    std::vector<double> direction_ratio; ///< -1 ... 1; 0 at rest
    std::vector<double> current_A;       ///< while it moves
    std::vector<double> moving_ratio;    ///< 0 at rest ... 1
    double resolution_rad = 0.0;         ///< of the angle: what smoothing takes off, rms
};

/// Smoothed by 10 ms, so that what is left of the noise of the angle is some hundredths of an ampere.
MotionRemainder remainderOf(const RecordedMove& move);

} // namespace halbench::app
