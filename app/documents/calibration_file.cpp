#include "app/documents/calibration_file.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/model_file.h"
#include "control/base/units.h"

namespace halbench::app {

namespace {

std::vector<ParameterValue> valuesIn(const JsonValue& root, const char* key) {
    std::vector<ParameterValue> values;
    for (const JsonValue& entry : itemsIn(&root, key)) {
        if (const auto value = numberIn(&entry, "value")) {
            values.push_back({textIn(&entry, "name"), *value});
        }
    }
    return values;
}

std::vector<CalibrationFigure> figuresOf(const JsonValue* figures) {
    std::vector<CalibrationFigure> list;
    if (figures == nullptr || !figures->isObject()) {
        return list;
    }
    for (const JsonMember& entry : figures->members()) {
        list.push_back({entry.key, textIn(&entry.value, "unit"), estimateOf(&entry.value)});
    }
    return list;
}

CalibrateResult resultOf(const JsonValue& root) {
    CalibrateResult result;
    result.figures = figuresOf(member(&root, "figures"));
    result.before = valuesIn(root, "before");
    result.proposed = valuesIn(root, "proposed");
    result.isApplied = isTrueIn(&root, "applied");
    result.residualBefore_rad = degreesToRadians(numberIn(&root, "residual_before_deg").value_or(0.0));
    result.residualAfter_rad = degreesToRadians(numberIn(&root, "residual_after_deg").value_or(0.0));
    for (const JsonValue& entry : itemsIn(&root, "static_friction")) {
        const auto angle_rad = numberIn(&entry, "angle_rad");
        const auto current_A = numberIn(&entry, "current_A");
        if (angle_rad && current_A) {
            result.staticFriction.push_back({*angle_rad, *current_A});
        }
    }
    for (const JsonValue& entry : itemsIn(&root, "hall_points")) {
        const auto a_T = numberIn(&entry, "a_T");
        const auto b_T = numberIn(&entry, "b_T");
        if (a_T && b_T) {
            result.hallPoints.push_back({*a_T, *b_T});
        }
    }
    result.duration_s = numberIn(&root, "duration_s").value_or(0.0);
    result.quality = qualityOf(member(&root, "data_quality"));
    return result;
}

} // namespace

Result<CalibrationRecord> parseCalibrationRecord(const std::string& text, const std::string& origin) {
    if (const Result<CalibrationFile> judged = parseCalibration(text, origin); !judged) {
        return failure(judged.error());
    }
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    return CalibrationRecord{headerOf(*root), resultOf(*root)};
}

} // namespace halbench::app
