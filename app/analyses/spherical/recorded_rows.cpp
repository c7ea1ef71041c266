#include "app/analyses/spherical/recorded_rows.h"

#include "app/actuators/spherical/sensing_columns.h"
#include "app/analyses/spherical/orientation_readings.h"
#include "app/documents/text/names.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

template <typename Names>
bool hasColumns(const Recording& recording, const Names& names, const char* unit) {
    return std::all_of(names.begin(), names.end(), [&recording, unit](const std::string& name) {
        return sensingColumn(recording, name, unit, ColumnsWithoutUnit::Refused).has_value();
    });
}

} // namespace

Result<RecordedRows> recordedRows(const devices::RecordedFile& file, const std::string& origin,
                                  const SensingBoard& board, int count) {
    AnalysisValues values;
    values.flags["truth"] = hasColumns(file.recording, splitList(UsualTruthSignals), "rad");
    const Result<OrientationReadings> readings = orientationReadings(values, file, origin);
    if (!readings) {
        return failure(readings.error());
    }
    RecordedRows taken;
    taken.rows = readings->time_s.size();
    const std::size_t wanted = std::min(taken.rows, static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t row = i * taken.rows / wanted;
        if (readings->used[row] != models::AllChannels) {
            ++taken.incomplete;
            continue;
        }
        taken.readings_T.push_back(models::correctedReadings_T(board.calibration, readings->readings_T[row],
                                                               readings->coilCurrent_A[row]));
        if (!readings->truth.empty()) {
            taken.truth.push_back(readings->truth[row]);
        }
    }
    if (taken.readings_T.empty()) {
        return failure(ErrorCode::InvalidInput, origin + ": no row has all nine readings",
                       "estimate the rows with 'halbench orient', which does without some of them");
    }
    return taken;
}

bool hasFieldReadings(const Recording& recording) {
    return recording.rows() > 0 && hasColumns(recording, defaultReadingNames(), "T");
}

double rowsLimit_ratio(const SensingBoard& board, double noise_T) {
    return 1.0 + std::pow(board.tolerance_T / noise_T, 2);
}

} // namespace halbench::app
