#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/base/axis_model.h"

#include <optional>
#include <string>

namespace halbench::app {

/// Schema of a model with axes; the motor's is halbench.identification/1.
inline constexpr const char* AxisModelSchema = "halbench.axis-model/1";

/// A model document of a device with several axes:
///     axes[] {axis, position_unit, effort_unit, sample_period_s, delay_samples,
///             parameters {damping_rate, acceleration_gain, breakaway_effort: {value, unit, ci95, source}}},
///     covariance {names: ["x.damping_rate", ...], matrix}
/// with the header of every result. Further members are of the actuator (its own constants) and are not
/// read here. Documented in resources/help/command-line.md, "Results".
struct AxisModelFile {
    ResultHeader header;
    AxisModel model;
};

/// `header.schema` is set here.
JsonValue axisModelDocument(ResultHeader header, const AxisModel& model);
/// The same without the header, for the steps of a run.
JsonValue axisModelBody(const AxisModel& model);

/// The model in the body of a step; nothing where it holds no axes. Errors: of parseAxisModel without a
/// schema.
Result<std::optional<AxisModel>> axisModelOf(const JsonValue& body, const std::string& origin);

/// Whether a text is such a document, in any version, and not the model of a motor.
bool isAxisModel(const std::string& text);

/// Errors: FileSystem; InvalidInput naming file and key; Refused when the estimate was refused; those of
/// checkAxisModel, with the file named first.
Result<AxisModelFile> readAxisModelFile(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<AxisModelFile> parseAxisModel(const std::string& text, const std::string& origin);

} // namespace halbench::app
