#include "app/documents/filtered_gains.h"
#include "app/documents/result_documents.h"
#include "control/assess/loop_assessment.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::app {

namespace {

/// Which way the gain goes to the nearest limit of stability.
JsonValue gainLimitOf(double gainMargin_ratio) {
    if (!std::isfinite(gainMargin_ratio)) {
        return {};
    }
    return gainMargin_ratio < 1.0 ? "decrease" : "increase";
}

JsonValue marginsOf(const control::StabilityMargins& margins) {
    JsonValue body = JsonValue::object();
    body.set("gain_margin_ratio", finiteOrNull(margins.gainMargin_ratio));
    body.set("gain_limit", gainLimitOf(margins.gainMargin_ratio));
    body.set("phase_margin_deg", finiteOrNull(margins.phaseMargin_deg));
    body.set("gain_crossover_rad_s", finiteOrNull(margins.gainCrossover_rad_s));
    body.set("phase_crossover_rad_s", finiteOrNull(margins.phaseCrossover_rad_s));
    body.set("delay_margin_s", finiteOrNull(margins.delayMargin_s));
    return body.set("modulus_margin", finiteOrNull(margins.modulusMargin));
}

JsonValue crossingsOf(const std::vector<control::Crossing>& crossings) {
    JsonValue list = JsonValue::array();
    for (const control::Crossing& crossing : crossings) {
        const bool isGain = crossing.kind == control::Crossing::Kind::Gain;
        JsonValue entry = JsonValue::object();
        entry.set("kind", isGain ? "gain" : "phase").set("frequency_rad_s", crossing.frequency_rad_s);
        entry.set("phase_margin_deg", isGain ? finiteOrNull(crossing.phaseMargin_deg) : JsonValue());
        entry.set("delay_margin_s", isGain ? finiteOrNull(crossing.delayMargin_s) : JsonValue());
        entry.set("gain_margin_ratio", isGain ? JsonValue() : finiteOrNull(crossing.gainMargin_ratio));
        list.push(entry);
    }
    return list;
}

JsonValue stepOf(const std::optional<control::StepMetrics>& step) {
    if (!step) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("rise_time_s", finiteOrNull(step->riseTime_s));
    body.set("overshoot_percent", finiteOrNull(step->overshoot_percent));
    body.set("peak_time_s", finiteOrNull(step->peakTime_s));
    body.set("settling_time_s", finiteOrNull(step->settlingTime_s));
    return body.set("final_error_rad", finiteOrNull(step->finalError_rad));
}

JsonValue largeStepOf(const std::optional<LargeStep>& step) {
    if (!step) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("amplitude_deg", radiansToDegrees(step->amplitude_rad));
    const JsonValue figures = stepOf(step->metrics);
    for (const JsonMember& figure : figures.members()) {
        const bool isOvershoot = figure.key == "overshoot_percent"; // of which the whole step has to be known
        body.set(figure.key, isOvershoot ? finiteOrNull(step->overshoot_percent()) : figure.value);
    }
    return body;
}

JsonValue toJson(const std::optional<control::Robustness::Interval>& interval) {
    if (!interval) {
        return {};
    }
    JsonValue body = JsonValue::object();
    return body.set("p5", finiteOrNull(interval->p5)).set("p95", finiteOrNull(interval->p95));
}

/// Null for a model without uncertainty: a point is not an interval. Each null when no draw is stable.
JsonValue intervalsOf(const control::Robustness& robust) {
    if (!robust.isUncertain) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("gain_margin_ratio", toJson(robust.gainMargin_ratio));
    body.set("phase_margin_deg", toJson(robust.phaseMargin_deg));
    body.set("delay_margin_s", toJson(robust.delayMargin_s));
    body.set("modulus_margin", toJson(robust.modulusMargin));
    return body.set("gain_crossover_rad_s", toJson(robust.gainCrossover_rad_s));
}

JsonValue valueWithUnit(double value, const char* unit) {
    JsonValue entry = JsonValue::object();
    return entry.set("value", value).set("unit", unit);
}

JsonValue gainsOf(const control::PositionLaw& law) {
    JsonValue gains = JsonValue::object();
    gains.set("kp", valueWithUnit(law.gains.proportional, "A/rad"));
    gains.set("ki", valueWithUnit(law.gains.integral, "A/(rad*s)"));
    gains.set("kd", valueWithUnit(law.gains.derivative, "A*s/rad"));
    gains.set("filter_s", law.gains.filter_s ? valueWithUnit(*law.gains.filter_s, "s") : JsonValue());
    gains.set("feedforward_inertia", valueWithUnit(law.inertia_A_s2_rad, "A*s^2/rad"));
    gains.set("feedforward_viscous", valueWithUnit(law.viscous_A_s_rad, "A*s/rad"));
    gains.set("feedforward_coulomb", valueWithUnit(law.coulomb_A, "A"));
    gains.set("feedforward_coulomb_speed", valueWithUnit(law.coulombSpeed_rad_s, "rad/s"));
    gains.set("stiction_current", valueWithUnit(law.stictionCurrent_A, "A"));
    gains.set("stiction_threshold", valueWithUnit(law.stictionThreshold_rad, "rad"));
    return gains.set("stiction_speed", valueWithUnit(law.stictionSpeed_rad_s, "rad/s"));
}

/// The same gains as times, for programs and controllers that read them so; null where that form has none
/// (series: complex zeros) and for an integral time without integral action.
JsonValue formOf(const control::PidGains& gains, control::PidForm form) {
    const auto timed = control::convert(gains, form, control::GainUnit::PerRadian);
    if (!timed) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("k", valueWithUnit(timed->proportional, "A/rad"));
    body.set("ti", std::isfinite(timed->integral) ? valueWithUnit(timed->integral, "s") : JsonValue());
    return body.set("td", valueWithUnit(timed->derivative, "s"));
}

JsonValue formsOf(const control::PidGains& gains) {
    JsonValue forms = JsonValue::object();
    forms.set("standard", formOf(gains, control::PidForm::Standard));
    return forms.set("series", formOf(gains, control::PidForm::Series));
}

JsonValue boundOf(const control::BoundUse& use) {
    JsonValue body = JsonValue::object();
    body.set("value", finiteOrNull(use.value)).set("bound", use.bound);
    return body.set("active", use.isActive());
}

/// Null for a method that keeps none.
JsonValue boundsOf(const std::optional<control::LeastErrorBounds>& bounds) {
    if (!bounds) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("max_sensitivity", boundOf(bounds->sensitivity));
    body.set("current_A", bounds->current ? boundOf(*bounds->current) : JsonValue());
    return body.set("step_deg",
                    bounds->current ? JsonValue(radiansToDegrees(bounds->step_rad)) : JsonValue());
}

/// What a design is judged by beside its margins; null for a loop that grows beyond all numbers.
JsonValue proofOf(const TuneResult& result) {
    const auto& assessment = result.assessment;
    if (!assessment) {
        return {};
    }
    const auto ifStable = [&](double value) {
        return assessment->isStable ? finiteOrNull(value) : JsonValue();
    };
    JsonValue body = JsonValue::object();
    body.set("max_sensitivity", finiteOrNull(assessment->peaks.Ms_ratio));
    body.set("max_complementary_sensitivity", finiteOrNull(assessment->peaks.Mt_ratio));
    body.set("noise_gain_A_per_rad", finiteOrNull(assessment->noiseGain_A_per_rad));
    body.set("peak_current_A_per_rad", ifStable(assessment->peakCurrent_A));
    body.set("largest_linear_step_rad", ifStable(assessment->largestStep_rad));
    body.set("pole_radius_one_sample_later", finiteOrNull(assessment->poleRadiusOneSampleLater));
    return body.set("bounds", boundsOf(result.bounds));
}

JsonValue robustOf(const control::Robustness& robust) {
    JsonValue body = JsonValue::object();
    body.set("draws", robust.draws);
    body.set("gain_margin_ratio_p5", finiteOrNull(robust.gainMargin_ratio_p5));
    body.set("phase_margin_deg_p5", finiteOrNull(robust.phaseMargin_deg_p5));
    body.set("unstable_fraction", finiteOrNull(robust.unstable_fraction));
    return body.set("intervals", intervalsOf(robust));
}

/// Null where they are not predicted.
JsonValue cyclesOf(const std::optional<std::vector<PredictedCycle>>& cycles) {
    if (!cycles) {
        return {};
    }
    JsonValue list = JsonValue::array();
    for (const PredictedCycle& cycle : *cycles) {
        JsonValue entry = JsonValue::object();
        entry.set("amplitude_rad", cycle.amplitude_rad).set("frequency_hz", cycle.frequency_Hz);
        list.push(entry.set("stable", cycle.isStable).set("accuracy_ratio", cycle.accuracy_ratio));
    }
    return list;
}

/// Null for an unstable loop; its intervals null for a model without covariance.
JsonValue disturbanceOf(const std::optional<Disturbance>& disturbance) {
    if (!disturbance) {
        return {};
    }
    const control::LoadStep& step = disturbance->step;
    JsonValue body = JsonValue::object();
    body.set("load_A", disturbance->load_A).set("peak_rad", finiteOrNull(step.peak_rad));
    body.set("peak_time_s", finiteOrNull(step.peakTime_s)).set("recovery_time_s", step.recoveryTime_s);
    body.set("final_rad", finiteOrNull(step.final_rad));
    if (!disturbance->band) {
        return body.set("intervals", JsonValue());
    }
    JsonValue intervals = JsonValue::object();
    intervals.set("peak_rad", toJson(std::optional(disturbance->band->peak_rad)));
    return body.set("intervals", intervals.set("recovery_time_s", toJson(disturbance->band->recoveryTime_s)));
}

} // namespace

void setJudgement(JsonValue& body, const TuneResult& result) {
    body.set("proof", proofOf(result)).set("robust", robustOf(result.robust));
    body.set("limit_cycles", cyclesOf(result.cycles));
    body.set("friction_release_s", finiteOrNull(result.release_s));
    body.set("disturbance", disturbanceOf(result.disturbance));
}

JsonValue analysisBody(const AnalysisResult& result) {
    JsonValue body = JsonValue::object();
    body.set("stable", result.isStable).set("pole_radius", finiteOrNull(result.poleRadius));
    body.set("dominant_frequency_rad_s", finiteOrNull(result.dominantFrequency_rad_s));
    body.set("dominant_damping_ratio", finiteOrNull(result.dominantDamping_ratio));
    body.set("margins", marginsOf(result.margins)).set("crossings", crossingsOf(result.crossings));
    body.set("step", stepOf(result.step)).set("large_step", largeStepOf(result.largeStep));
    body.set("proportional_limit_A_per_rad", finiteOrNull(result.proportionalLimit_A_per_rad));
    body.set("friction_band_rad", finiteOrNull(result.frictionBand_rad));
    body.set("high_frequency_gain_A_per_rad", finiteOrNull(result.highFrequencyGain_A_per_rad));
    return body.set("warnings", toJson(result.warnings));
}

JsonValue amplifierBody(const AmplifierAnalysis& result) {
    JsonValue body = JsonValue::object();
    body.set("gain_A_per_V", result.gain_A_per_V).set("lag_at_10hz_deg", result.lagAt10Hz_deg);
    body.set("cutoff_hz", finiteOrNull(result.cutoff_Hz));
    body.set("magnitude_at_1khz_db", result.magnitudeAt1kHz_dB);
    body.set("phase_at_1khz_deg", result.phaseAt1kHz_deg);
    body.set("shunt_power_W", result.shuntPower_W);
    return body.set("shunt_power_each_W", result.shuntPowerEach_W);
}

JsonValue motorAnalysisBody(const MotorAnalysis& result) {
    JsonValue figures = JsonValue::object();
    for (const ComputedFigure& figure : result.figures) {
        JsonValue entry = JsonValue::object();
        figures.set(figure.key, entry.set("value", finiteOrNull(figure.value)).set("unit", figure.unit));
    }
    JsonValue body = JsonValue::object();
    return body.set("what", result.subject).set("figures", figures);
}

JsonValue gainsBody(const TuneResult& result) {
    JsonValue targets = JsonValue::object();
    targets.set("zeta", result.targets.zeta).set("omega_rad_s", result.targets.omega_rad_s);
    targets.set("bandwidth_hz", result.targets.bandwidth_Hz);
    targets.set("phase_margin_deg", result.targets.phaseMargin_deg);
    targets.set("max_sensitivity", result.targets.mostMs_ratio);
    targets.set("current_limit_A", result.targets.currentLimit_A);
    targets.set("step_deg", result.targets.step_deg);
    targets.set("ultimate_gain_A_per_rad", result.targets.ultimateGain_A_per_rad);
    targets.set("ultimate_period_s", result.targets.ultimatePeriod_s);
    JsonValue body = JsonValue::object();
    body.set("method", result.method).set("targets", targets);
    body.set("form", control::pidFormName(result.law.gains.form));
    body.set("sample_period_s", result.conditions.timing.period_s);
    body.set("delay_samples", result.conditions.timing.delay_samples);
    body.set("gains", gainsOf(result.law)).set("forms", formsOf(result.law.gains));
    if (result.filtered) {
        setShaping(body, *result.filtered);
    }
    body.set("predicted", analysisBody(result.predicted));
    setJudgement(body, result);
    return body.set("warnings", toJson(result.warnings));
}

} // namespace halbench::app
