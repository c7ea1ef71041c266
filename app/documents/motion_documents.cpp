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

double inUnit(double position, const std::string& unit) {
    return unit == "deg" ? radiansToDegrees(position) : position;
}

JsonValue runOf(const MoveRepetition& repetition, std::size_t run, const std::string& unit) {
    JsonValue entry = JsonValue::object();
    entry.set("start_" + unit, finiteOrNull(inUnit(repetition.start[run], unit)));
    entry.set("max_error_" + unit, finiteOrNull(inUnit(repetition.maxError[run], unit)));
    entry.set("peak_to_peak_" + unit, finiteOrNull(inUnit(repetition.peakToPeak[run], unit)));
    return entry.set("settling_time_s", finiteOrNull(repetition.windowTime_s[run]));
}

JsonValue settlingBody(const std::optional<SettlingTimes>& times) {
    if (!times) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("count", times->count).set("least_s", times->least_s).set("median_s", times->median_s);
    body.set("mean_s", times->mean_s).set("deviation_s", times->deviation_s);
    return body.set("largest_s", times->largest_s);
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
        body.set(fmt::format("{}_{}", name, unit), finiteOrNull(inUnit(position, unit)));
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
    if (unit != "deg") { // boards with one axis have no travels
        body.set("rest_rms_" + unit, finiteOrNull(figures.restRms));
        body.set(fmt::format("ramp_end_speed_{}_s", unit), finiteOrNull(figures.rampEndSpeed));
    }
    body.set("lock_time_s", finiteOrNull(figures.lockTime_s));
    body.set("gain", finiteOrNull(figures.gain_ratio));
    return body.set("phase_deg", finiteOrNull(figures.phase_deg));
}

namespace {

JsonValue stairsBody(const MoveResult& result, const std::string& unit) {
    JsonValue stairs = JsonValue::array();
    for (std::size_t i = 0; i < result.figures().stairs.size(); ++i) {
        const StairFigures& stair = result.figures().stairs[i];
        JsonValue entry = JsonValue::object();
        entry.set("rise_time_s", finiteOrNull(stair.riseTime_s));
        entry.set("settling_time_s", finiteOrNull(stair.settlingTime_s));
        entry.set("overshoot_percent", finiteOrNull(stair.overshoot_percent));
        entry.set("mean_" + unit, finiteOrNull(stair.mean));
        stairs.push(entry.set("measured_mean_" + unit, finiteOrNull(result.measured.stairs[i].mean)));
    }
    return stairs;
}

JsonValue rowsBody(const MoveResult& result, const std::string& unit) {
    JsonValue rows = JsonValue::array();
    for (std::size_t i = 0; i < result.figures().rows.size(); ++i) {
        const RowFigures& row = result.figures().rows[i];
        const RowFigures& measured = result.measured.rows[i];
        JsonValue entry = JsonValue::object();
        entry.set("line", static_cast<double>(row.line)).set("arrival_s", finiteOrNull(row.arrival_s));
        entry.set("error_" + unit, finiteOrNull(row.error));
        entry.set("measured_error_" + unit, finiteOrNull(measured.error));
        entry.set("settling_time_s", finiteOrNull(row.settlingTime_s));
        rows.push(entry.set("measured_settling_time_s", finiteOrNull(measured.settlingTime_s)));
    }
    return rows;
}

} // namespace

JsonValue contourBody(const ContourResult& contour) {
    const std::string& unit = contour.unit;
    const ContourError& error = contour.truth ? *contour.truth : contour.measured;
    JsonValue body = JsonValue::object();
    body.set("rms_" + unit, finiteOrNull(error.rms)).set("peak_" + unit, finiteOrNull(error.peak));
    body.set("measured_rms_" + unit, finiteOrNull(contour.measured.rms));
    return body.set("measured_peak_" + unit, finiteOrNull(contour.measured.peak));
}

JsonValue moveBody(const MoveResult& result) {
    const bool isOneOfSeveral = result.isOneOfSeveral();
    const std::string unit = isOneOfSeveral ? result.axis.positionUnit : std::string("deg");
    JsonValue body = moveFigures(result.figures(), unit);
    const JsonValue measured = moveFigures(result.measured, unit);
    for (const JsonMember& figure : measured.members()) {
        body.set("measured_" + figure.key, figure.value);
    }
    if (isOneOfSeveral) {
        body.set("lock_threshold_" + unit, finiteOrNull(result.lockThreshold));
        body.set("peak_effort_" + suffixOf(result.axis.effortUnit), finiteOrNull(result.peakEffort));
        body.set("travel_s", finiteOrNull(result.travel_s));
        body.set("stairs", result.measured.stairs.empty() ? JsonValue() : stairsBody(result, unit));
        body.set("rows", result.measured.rows.empty() ? JsonValue() : rowsBody(result, unit));
    } else {
        body.set("lock_threshold_deg", degreesOrNull(result.lockThreshold));
    }
    body.set("peak_current_A", finiteOrNull(result.peakCurrent_A));
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

namespace {

JsonValue crossAxes(const MoveResult& result) {
    JsonValue others = JsonValue::array();
    for (const CrossAxisPeak& other : result.others) {
        const std::string& unit = other.axis.positionUnit;
        JsonValue entry = JsonValue::object();
        entry.set("axis", other.axis.id);
        entry.set("peak_" + unit, finiteOrNull(other.truth ? *other.truth : other.measured));
        entry.set("measured_peak_" + unit, finiteOrNull(other.measured));
        const auto& restRms = other.truth ? other.trueRestRms : other.measuredRestRms;
        entry.set("rest_rms_" + unit, finiteOrNull(restRms));
        others.push(entry.set("measured_rest_rms_" + unit, finiteOrNull(other.measuredRestRms)));
    }
    return others;
}

JsonValue movedAxis(const MoveResult& result, const std::optional<MoveFigures>& predicted) {
    JsonValue entry = JsonValue::object();
    entry.set("axis", result.axis.id).set("figures", moveBody(result));
    entry.set("predicted", predicted ? moveFigures(*predicted, result.axis.positionUnit) : JsonValue());
    return entry.set("cross_axes", crossAxes(result));
}

/// As if a further axis of a path or table were the one that moved.
MoveResult asMoved(const PartnerResult& partner, const MoveResult& result) {
    MoveResult moved;
    moved.axis = partner.axis;
    moved.measured = partner.measured;
    moved.truth = partner.truth;
    moved.peakEffort = partner.peakEffort;
    moved.lockThreshold = result.lockThreshold;
    moved.others = result.others;
    moved.partners = result.partners;
    moved.travel_s = result.travel_s;
    moved.peakCurrent_A = result.peakCurrent_A;
    moved.highestTemperature_degC = result.highestTemperature_degC;
    return moved;
}

} // namespace

JsonValue movedAxes(const MoveResult& result, const std::optional<MoveFigures>& predicted) {
    JsonValue axes = JsonValue::array();
    axes.push(movedAxis(result, predicted));
    for (const PartnerResult& partner : result.partners) {
        axes.push(movedAxis(asMoved(partner, result), std::nullopt));
    }
    return axes;
}

JsonValue repetitionBody(const MoveRepetition& repetition, const std::string& unit) {
    const std::vector<double>& swings = repetition.peakToPeak;
    const auto [least, most] = std::minmax_element(swings.begin(), swings.end());
    JsonValue runs = JsonValue::array();
    for (std::size_t run = 0; run < swings.size(); ++run) {
        runs.push(runOf(repetition, run, unit));
    }
    JsonValue body = JsonValue::object();
    body.set("count", repetition.config.count);
    const std::optional<double>& window = repetition.config.settled;
    body.set("settled_" + unit, unit == "deg" ? degreesOrNull(window) : finiteOrNull(window));
    body.set("alternate", repetition.config.alternates);
    body.set("settled_fraction", finiteOrNull(repetition.settled_ratio()));
    body.set("settling_time", settlingBody(repetition.settlingTimes()));
    body.set("least_peak_to_peak_" + unit, finiteOrNull(inUnit(*least, unit)));
    body.set("median_peak_to_peak_" + unit, finiteOrNull(inUnit(median(swings), unit)));
    body.set("largest_peak_to_peak_" + unit, finiteOrNull(inUnit(*most, unit)));
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
