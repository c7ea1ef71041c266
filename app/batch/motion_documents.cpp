#include "app/batch/result_documents.h"
#include "control/base/units.h"

namespace halbench::app {

JsonValue calibrationBody(const CalibrateResult& result) {
    JsonValue figures = JsonValue::object();
    for (const CalibrationFigure& figure : result.figures) {
        JsonValue entry = toJson(figure.estimate);
        figures.set(figure.name, entry.set("unit", figure.unit));
    }
    JsonValue friction = JsonValue::array();
    for (const StaticFrictionPoint& point : result.staticFriction) {
        JsonValue entry = JsonValue::object();
        friction.push(entry.set("angle_rad", point.angle_rad).set("current_A", point.current_A));
    }
    JsonValue body = JsonValue::object();
    body.set("figures", figures)
        .set("before", toJson(result.before))
        .set("proposed", toJson(result.proposed));
    body.set("applied", result.isApplied);
    body.set("residual_before_deg", finiteOrNull(radiansToDegrees(result.residualBefore_rad)));
    body.set("residual_after_deg", finiteOrNull(radiansToDegrees(result.residualAfter_rad)));
    return body.set("static_friction", friction);
}

JsonValue moveFigures(const MoveFigures& figures) {
    JsonValue body = JsonValue::object();
    body.set("rise_time_s", finiteOrNull(figures.riseTime_s));
    body.set("overshoot_percent", finiteOrNull(figures.overshoot_percent));
    body.set("peak_time_s", finiteOrNull(figures.peakTime_s));
    body.set("settling_time_s", finiteOrNull(figures.settlingTime_s));
    body.set("final_error_deg", finiteOrNull(radiansToDegrees(figures.finalError_rad)));
    body.set("max_error_deg", finiteOrNull(radiansToDegrees(figures.maxError_rad)));
    body.set("rms_error_deg", finiteOrNull(radiansToDegrees(figures.rmsError_rad)));
    body.set("mean_error_deg", finiteOrNull(radiansToDegrees(figures.meanError_rad)));
    body.set("peak_error_deg", finiteOrNull(radiansToDegrees(figures.peakError_rad)));
    body.set("first_second_error_deg", finiteOrNull(radiansToDegrees(figures.firstSecondError_rad)));
    body.set("gain", finiteOrNull(figures.gain_ratio));
    return body.set("phase_deg", finiteOrNull(figures.phase_deg));
}

JsonValue moveBody(const MoveResult& result) {
    JsonValue body = moveFigures(result.figures());
    const JsonValue measured = moveFigures(result.measured);
    for (const JsonMember& figure : measured.members()) {
        body.set("measured_" + figure.key, figure.value);
    }
    body.set("peak_current_A", finiteOrNull(result.peakCurrent_A));
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

JsonValue applyBody(const ApplyResult& result) {
    JsonValue body = JsonValue::object();
    body.set("kept", result.isKept).set("before", toJson(result.before)).set("after", toJson(result.after));
    body.set("predicted", result.predicted ? moveFigures(*result.predicted) : JsonValue());
    return body.set("verification", result.verification ? moveBody(*result.verification) : JsonValue());
}

} // namespace halbench::app
