#pragma once

#include "app/documents/text/json_value.h"
#include "app/procedures/tune/analyse.h"
#include "control/design/design_methods.h"
#include "control/law/position_loop.h"
#include "devices/device.h"

#include <optional>
#include <string>
#include <utility>

namespace halbench::app {

/// MODEL.json as `identify --out` wrote it.
struct ModelFile {
    MotorEstimate estimate;
    std::optional<devices::DeviceInfo> device; ///< of which it was identified
    std::uint64_t seed = 1;
};

/// GAINS.json as `tune --out` wrote it, or with K, T_i and T_d of the standard or series form.
struct GainsFile {
    control::PositionLaw law; ///< of the board: parallel form
    control::LoopTiming timing;
    std::string method; ///< how they were found; empty: not said
    control::DesignTargets targets;
    std::string started;                            ///< when they were found, as the file says it
    std::optional<devices::DeviceInfo> device = {}; ///< for which; absent: not said
    /// What they ask for beyond the board's law: only of `parseFilteredGains` and `readFilteredGains`
    /// (filtered_gains.h). Then no board runs them.
    std::optional<control::FilteredLaw> filtered = {};

    LoopLaw loopLaw() const { return {law, filtered}; }
};

/// CAL.json as `calibrate --out` wrote it, as far as tuning needs it.
struct CalibrationFile {
    std::optional<std::pair<double, double>> stray95_T_per_A; ///< absent: not calibrated or refused
    double stray_T_per_A = 0.0;                               ///< the estimate itself
    bool isApplied = false;                                   ///< it runs on the board
    DataQuality quality;
};

/// Errors: FileSystem; InvalidInput naming file and key (no JSON, wrong schema, newer version, missing key,
/// wrong type, a number that is not finite); Refused when the file holds a refused estimate.
Result<ModelFile> readModelFile(const std::string& path);
Result<GainsFile> readGainsFile(const std::string& path);
Result<CalibrationFile> readCalibrationFile(const std::string& path);

/// Gains of several axes are none of a single loop. Error: InvalidInput.
Result<void> refuseAxes(const std::string& text, const std::string& origin);

/// The same from text; `origin` names it in messages.
Result<ModelFile> parseModel(const std::string& text, const std::string& origin);
Result<GainsFile> parseGains(const std::string& text, const std::string& origin);
Result<CalibrationFile> parseCalibration(const std::string& text, const std::string& origin);

} // namespace halbench::app
