#pragma once

#include "app/analyses/analysis.h"
#include "models/spherical/orientation.h"
#include "models/spherical/spherical_sensing.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// Nine readings a row, and what may be used of them.
struct OrientationReadings {
    std::vector<double> time_s;
    std::vector<models::SphericalReadings> readings_T;
    std::vector<models::ChannelMask> used;        ///< without values that are missing, clipped or left out
    std::vector<double> coilCurrent_A;            ///< zero where `coil.current` is not recorded
    std::vector<models::OrientationAngles> truth; ///< empty without `truth`
    std::array<std::string, models::ChannelCount> names;
    std::array<std::size_t, models::ChannelCount> missing{}; ///< rows without a value, each channel
    std::array<std::size_t, models::ChannelCount> clipped{};
    std::array<std::size_t, models::ChannelCount> leftOut{}; ///< by the board, where `channels_left_out` is
    /// Without a given range: the magnitude at which readings pile up, and the channels that do. Readings
    /// there are left out. One channel may also be at rest there; several are saturated.
    std::optional<double> saturation_T;
    std::vector<std::size_t> saturated;
};

inline constexpr std::string_view UsualTruthSignals = "truth.alpha,truth.beta,truth.gamma";

/// Names of the readings when none are given: "field.0.r", "field.0.theta", ... "field.2.phi".
std::array<std::string, models::ChannelCount> defaultReadingNames();

/// Takes the columns named by the settings `readings`, `truth` and `truth_signals` out of a recording and
/// marks values that the board left out, at the end of `range_mT`, or where they pile up when no range is
/// given. Errors: UnknownName
/// (a missing column, a column in another unit), InvalidInput (no rows, not nine names, readings beyond 3 T,
/// a true angle that is no number).
Result<OrientationReadings> orientationReadings(const AnalysisValues& values,
                                                const devices::RecordedFile& file, const std::string& origin);

} // namespace halbench::app
