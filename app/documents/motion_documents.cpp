#include "app/documents/result_documents.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace halbench::app {

namespace {

JsonValue degreesOrNull(const std::optional<double>& angle_rad) {
    // A limit that was written in degrees reads as it was written.
    return angle_rad ? finiteOrNull(std::round(radiansToDegrees(*angle_rad) * 1e9) * 1e-9) : JsonValue();
}

std::string suffixOf(const std::string& symbol) {
    const std::optional<Unit> unit = findUnit(symbol);
    return std::string(unit ? unit->suffix : std::string_view(symbol));
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

JsonValue runOf(const MoveRepetition& repetition, std::size_t run) {
    JsonValue entry = JsonValue::object();
    entry.set("start_deg", finiteOrNull(radiansToDegrees(repetition.start_rad[run])));
    entry.set("max_error_deg", finiteOrNull(radiansToDegrees(repetition.maxError_rad[run])));
    return entry.set("peak_to_peak_deg", finiteOrNull(radiansToDegrees(repetition.peakToPeak_rad[run])));
}

JsonValue agreementOf(const VerificationBand& band, bool isWithin) {
    JsonValue body = JsonValue::object();
    body.set("within", isWithin);
    body.set("friction_band_deg", finiteOrNull(radiansToDegrees(band.friction_rad)));
    body.set("allowed_error_deg", finiteOrNull(radiansToDegrees(band.allowed_rad)));
    body.set("allowed_overshoot_percent", finiteOrNull(band.allowedOvershoot_percent));
    body.set("largest_difference_deg", finiteOrNull(radiansToDegrees(band.largestOff_rad)));
    return body.set("largest_difference_s", finiteOrNull(band.largestOffTime_s));
}

} // namespace

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
    JsonValue readings = JsonValue::array();
    for (const HallPoint& point : result.hallPoints) {
        JsonValue entry = JsonValue::object();
        readings.push(entry.set("a_T", point.a_T).set("b_T", point.b_T));
    }
    JsonValue body = JsonValue::object();
    body.set("figures", figures)
        .set("before", toJson(result.before))
        .set("proposed", toJson(result.proposed));
    body.set("applied", result.isApplied);
    body.set("residual_before_deg", finiteOrNull(radiansToDegrees(result.residualBefore_rad)));
    body.set("residual_after_deg", finiteOrNull(radiansToDegrees(result.residualAfter_rad)));
    body.set("static_friction", friction).set("hall_points", readings);
    return body.set("duration_s", result.duration_s);
}

JsonValue moveFigures(const MoveFigures& figures, const std::string& unit) {
    JsonValue body = JsonValue::object();
    const auto setPosition = [&](const char* name, double position) {
        body.set(fmt::format("{}_{}", name, unit),
                 finiteOrNull(unit == "deg" ? radiansToDegrees(position) : position));
    };
    body.set("rise_time_s", finiteOrNull(figures.riseTime_s));
    body.set("overshoot_percent", finiteOrNull(figures.overshoot_percent));
    body.set("peak_time_s", finiteOrNull(figures.peakTime_s));
    body.set("settling_time_s", finiteOrNull(figures.settlingTime_s));
    setPosition("final_error", figures.finalError);
    setPosition("max_error", figures.maxError);
    setPosition("rms_error", figures.rmsError);
    setPosition("mean_error", figures.meanError);
    setPosition("peak_error", figures.peakError);
    setPosition("first_second_error", figures.firstSecondError);
    setPosition("peak_to_peak", figures.peakToPeak);
    body.set("lock_time_s", finiteOrNull(figures.lockTime_s));
    body.set("gain", finiteOrNull(figures.gain_ratio));
    return body.set("phase_deg", finiteOrNull(figures.phase_deg));
}

JsonValue moveBody(const MoveResult& result) {
    const bool isOneOfSeveral = !result.others.empty();
    const std::string unit = isOneOfSeveral ? result.axis.positionUnit : std::string("deg");
    JsonValue body = moveFigures(result.figures(), unit);
    const JsonValue measured = moveFigures(result.measured, unit);
    for (const JsonMember& figure : measured.members()) {
        body.set("measured_" + figure.key, figure.value);
    }
    if (isOneOfSeveral) {
        body.set("lock_threshold_" + unit, finiteOrNull(result.lockThreshold));
        body.set("peak_effort_" + suffixOf(result.axis.effortUnit), finiteOrNull(result.peakEffort));
    } else {
        body.set("lock_threshold_deg", degreesOrNull(result.lockThreshold));
    }
    body.set("peak_current_A", finiteOrNull(result.peakCurrent_A));
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

JsonValue movedAxes(const MoveResult& result) {
    JsonValue others = JsonValue::array();
    for (const CrossAxisPeak& other : result.others) {
        const std::string& unit = other.axis.positionUnit;
        JsonValue entry = JsonValue::object();
        entry.set("axis", other.axis.id);
        entry.set("peak_" + unit, finiteOrNull(other.truth ? *other.truth : other.measured));
        others.push(entry.set("measured_peak_" + unit, finiteOrNull(other.measured)));
    }
    JsonValue entry = JsonValue::object();
    entry.set("axis", result.axis.id).set("figures", moveBody(result));
    entry.set("predicted", JsonValue()); // no model of such an axis is known yet
    JsonValue axes = JsonValue::array();
    return axes.push(entry.set("cross_axes", others));
}

JsonValue repetitionBody(const MoveRepetition& repetition) {
    const std::vector<double>& swings_rad = repetition.peakToPeak_rad;
    const auto [least, most] = std::minmax_element(swings_rad.begin(), swings_rad.end());
    JsonValue runs = JsonValue::array();
    for (std::size_t run = 0; run < swings_rad.size(); ++run) {
        runs.push(runOf(repetition, run));
    }
    JsonValue body = JsonValue::object();
    body.set("count", repetition.config.count);
    body.set("settled_deg", degreesOrNull(repetition.config.settled_rad));
    body.set("settled_fraction", finiteOrNull(repetition.settled_ratio()));
    body.set("least_peak_to_peak_deg", finiteOrNull(radiansToDegrees(*least)));
    body.set("median_peak_to_peak_deg", finiteOrNull(radiansToDegrees(median(swings_rad))));
    body.set("largest_peak_to_peak_deg", finiteOrNull(radiansToDegrees(*most)));
    return body.set("runs", runs);
}

JsonValue applyBody(const ApplyResult& result) {
    JsonValue body = JsonValue::object();
    body.set("kept", result.isKept).set("before", toJson(result.before)).set("after", toJson(result.after));
    body.set("predicted", result.predicted ? moveFigures(*result.predicted) : JsonValue());
    body.set("agreement", result.band ? agreementOf(*result.band, result.isKept) : JsonValue());
    return body.set("verification", result.verification ? moveBody(*result.verification) : JsonValue());
}

JsonValue liveApplyBody(const LiveApplyResult& result) {
    JsonValue steps = JsonValue::array();
    for (const LiveStepResult& step : result.steps) {
        JsonValue entry = JsonValue::object();
        entry.set("values", toJson(step.values)).set("within", step.isWithin);
        entry.set("widening_ratio", finiteOrNull(step.widening_ratio));
        entry.set("gain_margin_ratio_p5", finiteOrNull(step.robust.gainMargin_ratio_p5));
        entry.set("phase_margin_deg_p5", finiteOrNull(step.robust.phaseMargin_deg_p5));
        entry.set("unstable_fraction", finiteOrNull(step.robust.unstable_fraction));
        steps.push(entry);
    }
    JsonValue body = applyBody(result.apply);
    body.set("planned_steps", static_cast<std::uint64_t>(result.plannedSteps));
    return body.set("steps", steps);
}

} // namespace halbench::app
