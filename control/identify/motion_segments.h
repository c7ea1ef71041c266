#pragma once

#include "control/base/result.h"

#include <span>
#include <vector>

namespace halbench::control {

/// A stretch of motion in one direction under one constant current: run-up, plateau or coast-down.
struct MotionSegment {
    std::vector<double> time_s;
    std::vector<double> angle_rad; ///< unwrapped, as measured
    double current_A = 0.0;
    int direction = 1; ///< +1 or -1
};

/// One stretch of constant current, moving or not: indices into the recording, `end` not included.
struct CurrentPlateau {
    std::size_t begin = 0;
    std::size_t end = 0;
    double current_A = 0.0;
};

struct SegmentConfig {
    double slowest_rad_s = 3.0; ///< slower motion is left out: friction is not constant there
    double settle_s = 0.012;    ///< after a change of current: the amplifier and the sample that straddles it
    double shortest_s = 0.12;   ///< shorter stretches are left out
    double sameCurrent_A = 1e-3; ///< a current that moves less than this is constant
};

/// Cuts a recording where the current changes, or where `marker` does (pass an empty span when there is
/// none). Errors: InvalidInput (columns of different length, time not increasing), NotFinite.
Result<std::vector<CurrentPlateau>> findPlateaus(std::span<const double> time_s,
                                                 std::span<const double> current_A,
                                                 std::span<const double> marker, const SegmentConfig& config);

/// The moving part of each plateau: its longest run of samples faster than `slowest_rad_s` in one direction.
std::vector<MotionSegment> findMotion(std::span<const double> time_s, std::span<const double> angle_rad,
                                      std::span<const CurrentPlateau> plateaus, const SegmentConfig& config);

} // namespace halbench::control
