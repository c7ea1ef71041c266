#include "app/procedures/analyse.h"

#include "app/procedures/large_step.h"
#include "control/base/units.h"
#include "control/design/board_gains.h"
#include "control/lti/frequency_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr double LargeStep_deg = 100.0;

using control::PidGains;
using control::TransferFunction;

Result<PidGains> checkedGains(const control::PositionLaw& law) {
    auto gains = control::boardGains(law.gains);
    if (!gains) {
        return gains;
    }
    if (gains->proportional <= 0.0 || gains->integral < 0.0 || gains->derivative < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("K_P = {:.4g}, K_I = {:.4g}, K_D = {:.4g} is no position loop",
                                   gains->proportional, gains->integral, gains->derivative),
                       "K_P must be positive, K_I and K_D not negative");
    }
    return gains;
}

Result<void> checkConditions(const LoopConditions& conditions) {
    if (!std::isfinite(conditions.currentLimit_A) || conditions.currentLimit_A <= 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a current limit of {} A is not possible", conditions.currentLimit_A));
    }
    const auto& stray = conditions.stray;
    if (stray && (!std::isfinite(stray->amplitude_T) || !std::isfinite(stray->coefficient_T_per_A) ||
                  stray->amplitude_T <= 0.0 || !std::isfinite(stray->error_T_per_A.value_or(0.0)))) {
        return failure(ErrorCode::OutOfRange,
                       "the stray field of the coils is not described by finite numbers");
    }
    return control::checkTiming(conditions.timing);
}

/// The least damped oscillation of the closed loop below the Nyquist frequency.
void takeDominantPair(AnalysisResult& result, const TransferFunction& closedLoop) {
    for (const control::Damping& mode : control::damping(closedLoop)) {
        const bool isPair = mode.pole.imag() > 0.0;
        if (isPair && (!result.dominantDamping_ratio || mode.damping_ratio < *result.dominantDamping_ratio)) {
            result.dominantDamping_ratio = mode.damping_ratio;
            result.dominantFrequency_rad_s = mode.naturalFrequency_rad_s;
        }
    }
}

Result<AnalysisResult::Bode> bodeOf(const TransferFunction& openLoop) {
    constexpr int Points = 400;
    constexpr double Decades_ratio = 5000.0; // 0.01 Hz for a loop of 100 Hz
    // The held rotor has a zero just inside z = -1: nearly all of the 90 degrees by which it turns the phase
    // lie in the last percent, because at the Nyquist frequency every sampled response is real. That says
    // nothing about the loop and would be read as a resonance; up to here it is 13 degrees for the published
    // motor.
    constexpr double End_ratio = 0.99;
    const double nyquist_rad_s = Pi / openLoop.timeBase().period_s();
    const auto response = control::frequencyResponse(
        openLoop,
        control::logarithmicFrequencies(nyquist_rad_s / Decades_ratio, End_ratio * nyquist_rad_s, Points));
    if (!response) {
        return failure(response.error());
    }
    AnalysisResult::Bode bode;
    for (const double frequency_rad_s : response->frequency_rad_s) {
        bode.frequency_Hz.push_back(frequency_rad_s / (2.0 * Pi));
    }
    bode.magnitude_dB = control::magnitude_dB(*response);
    bode.phase_deg = control::phase_deg(*response);
    return bode;
}

/// Six time constants of the slowest pole, between 100 and 2000 samples: a pole slower still is one that the
/// integral of a friction-free loop hardly excites.
double stepDuration_s(const AnalysisResult& result, double period_s) {
    constexpr double TimeConstants = 6.0;
    const double samples = -TimeConstants / std::log(std::min(result.poleRadius, 1.0 - 1e-9));
    return std::clamp(samples, 100.0, 2000.0) * period_s;
}

Result<void> takeStep(AnalysisResult& result, const control::PositionPlant& plant, const PidGains& gains,
                      const control::LoopTiming& timing) {
    auto step = control::linearStep(plant, gains, timing, 1.0, stepDuration_s(result, timing.period_s));
    if (!step) {
        return failure(step.error());
    }
    result.step = step->metrics;
    result.stepCurve = {std::move(step->time_s), std::move(step->response_rad), std::move(step->current_A)};
    return {};
}

void addStabilityWarnings(AnalysisResult& result, const PidGains& gains) {
    if (!result.isStable) {
        result.warnings.push_back(
            {"unstable", fmt::format("the sampled loop is unstable: pole radius {:.4f}", result.poleRadius),
             "only friction and the current limit bound it; lower K_P or use method recommended"});
    }
    if (gains.proportional > result.proportionalLimit_A_per_rad) {
        result.warnings.push_back(
            {"above_sampled_limit",
             fmt::format(
                 "K_P = {:.4g} A/rad is {:.3g} times the limit of {:.4g} A/rad at this sampling and delay",
                 gains.proportional, gains.proportional / result.proportionalLimit_A_per_rad,
                 result.proportionalLimit_A_per_rad),
             "the rotor rests and makes small steps at best; large steps end in a limit cycle"});
    }
    constexpr double LittleDamping_ratio = 0.15;
    if (result.isStable && result.dominantDamping_ratio.value_or(1.0) < LittleDamping_ratio) {
        result.warnings.push_back(
            {"little_damping",
             fmt::format(
                 "the loop is nearly undamped (zeta = {:.3g} at {:.4g} rad/s): only friction damps it",
                 *result.dominantDamping_ratio, *result.dominantFrequency_rad_s),
             "a PI loop cannot do better on this motor; derivative action can: method recommended"});
    }
    constexpr double LeastPhaseMargin_deg = 20.0;
    constexpr double LeastGainMargin_ratio = 1.5;
    if (result.isStable &&
        (result.margins.phaseMargin_deg < LeastPhaseMargin_deg ||
         std::abs(std::log(result.margins.gainMargin_ratio)) < std::log(LeastGainMargin_ratio))) {
        result.warnings.push_back(
            {"small_margin",
             fmt::format("small margins: {:.3g} deg of phase, a factor {:.3g} of gain",
                         result.margins.phaseMargin_deg, result.margins.gainMargin_ratio),
             "the usual least are 30 deg and a factor 2"});
    }
}

void addDelayWarning(AnalysisResult& result, const control::PositionPlant& plant, const PidGains& gains,
                     const control::LoopTiming& timing) {
    const auto later = control::sampledOpenLoop(plant, gains, {timing.period_s, timing.delay_samples + 1});
    if (result.isStable && later && control::poleRadius(*later) >= 1.0) {
        result.warnings.push_back(
            {"delay_sensitive",
             fmt::format("one more sample of delay makes this loop unstable: its delay margin is {:.3g} ms",
                         1e3 * result.margins.delayMargin_s),
             "make sure that the delay is known (delay.samples), or choose a slower loop"});
    }
}

void addFrictionWarning(AnalysisResult& result, const PidGains& gains) {
    const double band_deg = radiansToDegrees(result.frictionBand_rad);
    constexpr double NotableBand_deg =
        0.64; // the accuracy that the published loop claims (htm-theory.md 6.7)
    if (band_deg > NotableBand_deg) {
        result.warnings.push_back(
            {"friction_band",
             fmt::format("friction holds the rotor within +-{:.3g} deg of the reference", band_deg),
             gains.integral > 0.0
                 ? "only the integral removes the rest, slowly; the micro-step assist or a larger K_P "
                   "narrows the band"
                 : "the micro-step assist or a larger K_P narrows the band"});
    }
}

/// (K_P + K_D/T_s) |error of k_s| / B_0 < 1 (help: htm-theory.md 8.4); the warning begins where the
/// recommended preset's does, at 20 % of its 35 %.
void addStrayWarning(AnalysisResult& result, const std::optional<StrayField>& stray) {
    if (!stray || stray->coefficient_T_per_A == 0.0) {
        return;
    }
    constexpr double WarnFrom_ratio = 0.20 / 0.35;
    const double perTesla = result.highFrequencyGain_A_per_rad / stray->amplitude_T;
    const double coefficient_T_per_A = std::abs(stray->coefficient_T_per_A);
    const double allowed_percent = 100.0 / (perTesla * coefficient_T_per_A);
    if (!stray->isCompensated) {
        if (perTesla * coefficient_T_per_A >= WarnFrom_ratio) {
            result.warnings.push_back(
                {"stray_field_not_compensated",
                 "the stray field of the coils is not compensated and feeds the current back "
                 "into the angle: this gain can make it alternate every sample",
                 "switch the compensation on (stray.enabled)"});
        }
        return;
    }
    if (!stray->error_T_per_A) {
        if (allowed_percent < 100.0) {
            result.warnings.push_back({"stray_field_not_calibrated",
                                       fmt::format("this gain needs the stray coefficient to better than "
                                                   "{:.0f} %, and its error is not known",
                                                   allowed_percent),
                                       "calibrate the stray field first"});
        }
        return;
    }
    if (perTesla * std::abs(*stray->error_T_per_A) >= WarnFrom_ratio) {
        result.warnings.push_back(
            {"stray_field_error",
             fmt::format("the stray coefficient is known to {:.0f} %, this gain needs better than {:.0f} %",
                         100.0 * std::abs(*stray->error_T_per_A) / coefficient_T_per_A, allowed_percent),
             "calibrate the stray field again, or lower the gains"});
    }
}

void addSaturationNote(AnalysisResult& result, const PidGains& gains, double currentLimit_A) {
    const double largest_deg = radiansToDegrees(currentLimit_A / gains.proportional);
    constexpr double NotableOvershoot_percent = 15.0;
    if (result.isStable && result.largeStep->metrics.overshoot_percent > NotableOvershoot_percent &&
        largest_deg < LargeStep_deg) {
        result.warnings.push_back(
            {"large_steps_overshoot",
             fmt::format("steps above {:.3g} deg reach the current limit of {:.3g} A; with it and with "
                         "friction a step "
                         "of {:.0f} deg overshoots by {:.3g} %",
                         largest_deg, currentLimit_A, LargeStep_deg,
                         result.largeStep->metrics.overshoot_percent),
             "lead large moves along a ramp, or choose a slower loop"});
    }
}

Result<AnalysisResult::Roots> rootsOf(const TransferFunction& openLoop) {
    auto locus = control::rootLocus(openLoop, RootLocusMost_ratio);
    if (!locus) {
        return failure(locus.error());
    }
    return AnalysisResult::Roots{control::poles(openLoop), control::zeros(openLoop),
                                 control::closedLoopPoles(openLoop), *std::move(locus),
                                 openLoop.timeBase().period_s()};
}

/// Everything that the open loop tells.
Result<AnalysisResult> predictLoop(const control::PositionPlant& plant, const PidGains& gains,
                                   const control::LoopTiming& timing) {
    const auto openLoop = control::sampledOpenLoop(plant, gains, timing);
    if (!openLoop) {
        return failure(openLoop.error());
    }
    AnalysisResult result;
    result.poleRadius = control::poleRadius(*openLoop);
    result.isStable = result.poleRadius < 1.0;
    result.margins = control::smallestMargins(*openLoop);
    result.crossings = control::allCrossings(*openLoop);
    result.proportionalLimit_A_per_rad =
        control::proportionalLimit_A_per_rad(plant, timing, gains.derivative);
    result.highFrequencyGain_A_per_rad = gains.proportional + gains.derivative / timing.period_s;
    const auto closedLoop = control::feedback(*openLoop, TransferFunction::gain(1.0, openLoop->timeBase()));
    auto bode = bodeOf(*openLoop);
    auto roots = rootsOf(*openLoop);
    if (!closedLoop || !bode || !roots) {
        return failure(!closedLoop ? closedLoop.error() : !bode ? bode.error() : roots.error());
    }
    takeDominantPair(result, *closedLoop);
    result.bode = std::move(*bode);
    result.roots = std::move(*roots);
    return result;
}

} // namespace

Result<AnalysisResult> runAnalysis(const MotorEstimate& estimate, const control::PositionLaw& law,
                                   const LoopConditions& conditions) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant) {
        return failure(plant.error());
    }
    const auto gains = checkedGains(law);
    if (!gains) {
        return failure(gains.error());
    }
    if (const auto valid = checkConditions(conditions); !valid) {
        return failure(valid.error());
    }
    auto result = predictLoop(*plant, *gains, conditions.timing);
    if (!result) {
        return result;
    }
    const auto stepped =
        result->isStable ? takeStep(*result, *plant, *gains, conditions.timing) : Result<void>{};
    const auto largeStep = predictLargeStep(*plant, law, conditions, degreesToRadians(LargeStep_deg));
    if (!stepped || !largeStep) {
        return failure(stepped ? largeStep.error() : stepped.error());
    }
    result->largeStep = *largeStep;
    result->frictionBand_rad = control::frictionBand_rad(*plant, law);
    addStabilityWarnings(*result, *gains);
    addDelayWarning(*result, *plant, *gains, conditions.timing);
    addFrictionWarning(*result, *gains);
    addStrayWarning(*result, conditions.stray);
    addSaturationNote(*result, *gains, conditions.currentLimit_A);
    result->quality.verdict = result->isStable ? Verdict::Good : Verdict::Doubtful;
    result->quality.findings = result->warnings;
    return result;
}

} // namespace halbench::app
