#pragma once

#include "app/documents/model_file.h"
#include "app/documents/result_header.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/tune/tune_axes.h"

#include <string>
#include <vector>

namespace halbench::app {

/// halbench.gains/1 of several axes: `axes[]`, each `axis`, `position_unit`, `effort_unit` and the members
/// that the gains of a single loop have at the top level, keys and units in those of the axis ("kp" in
/// "N/m", `final_error_m`); `joint` {draws, unstable_fraction} or null.
JsonValue axisGainsDocument(ResultHeader header, const TuneAxesResult& result);
/// halbench.analysis/1 of several axes, likewise.
JsonValue axisAnalysisDocument(ResultHeader header, const TuneAxesResult& result);
/// The same without the header, for the steps of a run.
JsonValue axisGainsBody(const TuneAxesResult& result);
JsonValue axisAnalysisBody(const TuneAxesResult& result);

/// `applied` of the same: kept, before, after, and `axes[]` {axis, predicted, agreement, verification,
/// cross_axes}.
JsonValue appliedAxesBody(const ApplyAxesResult& result);

/// A body of numbers in rad and A with the keys and units of an axis.
JsonValue inUnitsOf(const LoopAxis& axis, const JsonValue& body);

/// Gains of the loops of several axes.
struct AxisGainsFile {
    std::optional<devices::DeviceInfo> device; ///< for which they were found
    std::vector<std::string> axes;
    std::vector<GainsFile> gains; ///< one for each of `axes`
};

/// Whether a text holds gains of several axes, and not those of a motor.
bool isAxisGains(const std::string& text);

/// Errors: FileSystem; InvalidInput naming file, axis and key (no axes, another unit); of parseFilteredGains.
Result<AxisGainsFile> readAxisGains(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<AxisGainsFile> parseAxisGains(const std::string& text, const std::string& origin);

} // namespace halbench::app
