#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/analyses/analysis.h"
#include "models/spherical/orientation.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Rows of a recording on which estimators are compared.
struct RecordedRows {
    std::vector<models::SphericalReadings> readings_T; ///< corrected by the calibration
    std::vector<models::OrientationAngles> truth;      ///< empty: the recording has no true angles
    std::size_t rows = 0;                              ///< of the recording
    std::size_t incomplete = 0; ///< of the chosen ones: a reading missing or clipped, left out
};

/// Evenly chosen, at most `count`. Errors: of orientationReadings(); InvalidInput when no chosen row has all
/// nine readings.
Result<RecordedRows> recordedRows(const devices::RecordedFile& file, const std::string& origin,
                                  const SensingBoard& board, int count);

/// Whether it has the nine columns, in units of a field.
bool hasFieldReadings(const Recording& recording);

/// How many times the chi-square limit the readings of this board may have: what its calibration leaves
/// counts as well (models::OrientationConfig).
double rowsLimit_ratio(const SensingBoard& board, double noise_T);

} // namespace halbench::app
