#include "app/procedures/tune/loop_prediction.h"

#include "control/base/units.h"
#include "control/lti/frequency_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

/// The least damped oscillation of the closed loop below the Nyquist frequency.
void takeDominantPair(AnalysisResult& result, const control::TimeBase& base) {
    for (const control::Damping& mode : control::damping(result.roots.closedLoop, base)) {
        const bool isPair = mode.pole.imag() > 0.0;
        if (isPair && (!result.dominantDamping_ratio || mode.damping_ratio < *result.dominantDamping_ratio)) {
            result.dominantDamping_ratio = mode.damping_ratio;
            result.dominantFrequency_rad_s = mode.naturalFrequency_rad_s;
        }
    }
}

/// Which way the gain has to go, all gains together.
std::string stabilityHint(const std::optional<control::StableGains>& stable) {
    if (!stable) {
        return "only friction and the current limit bound the motion, and no common factor on these gains "
               "gives stability: change their ratio or the filters, or use method recommended";
    }
    return stable->to_ratio <= 1.0
               ? fmt::format("only friction and the current limit bound the motion; stable below {:.3g} "
                             "times these gains: reduce K_P, or use method recommended",
                             stable->to_ratio)
               : fmt::format("only friction and the current limit bound the motion; stable above {:.3g} "
                             "times these gains: increase them, or use method recommended",
                             stable->from_ratio);
}

/// From 5000 times below the Nyquist frequency, and a decade below the lowest crossing.
double bodeFrom_rad_s(double nyquist_rad_s, const std::vector<control::Crossing>& crossings) {
    constexpr double Decades_ratio = 5000.0; // 0.01 Hz for a loop of 100 Hz
    const double usual_rad_s = nyquist_rad_s / Decades_ratio;
    const bool isLower = !crossings.empty() && crossings.front().frequency_rad_s < usual_rad_s;
    return isLower ? 0.1 * crossings.front().frequency_rad_s : usual_rad_s;
}

Result<AnalysisResult::Bode> bodeOf(const control::DeltaSystem& openLoop,
                                    const std::vector<control::Crossing>& crossings) {
    constexpr int Points = 400;
    // The held rotor has a zero just inside z = -1: nearly all of the 90 degrees by which it turns the phase
    // lie in the last percent, because at the Nyquist frequency every sampled response is real. That says
    // nothing about the loop and would be read as a resonance; up to here it is 13 degrees for the published
    // motor.
    constexpr double End_ratio = 0.99;
    const double nyquist_rad_s = Pi / openLoop.timeBase().period_s();
    const auto response = control::frequencyResponse(
        [&openLoop](double frequency_rad_s) { return openLoop.atFrequency(frequency_rad_s); },
        openLoop.timeBase(),
        control::logarithmicFrequencies(bodeFrom_rad_s(nyquist_rad_s, crossings), End_ratio * nyquist_rad_s,
                                        Points));
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

Result<AnalysisResult::Roots> rootsOf(const control::DeltaSystem& openLoop,
                                      std::vector<std::complex<double>> closedLoop) {
    auto locus = control::rootLocus(openLoop, RootLocusMost_ratio);
    if (!locus) {
        return failure(locus.error());
    }
    return AnalysisResult::Roots{control::poles(openLoop), control::zeros(openLoop), std::move(closedLoop),
                                 *std::move(locus), openLoop.timeBase().period_s()};
}

} // namespace

Result<void> takeOpenLoop(AnalysisResult& result, const control::DeltaSystem& openLoop,
                          std::vector<std::complex<double>> closedLoop) {
    result.poleRadius = 0.0;
    for (const std::complex<double>& pole : closedLoop) {
        result.poleRadius = std::max(result.poleRadius, std::abs(pole));
    }
    result.isStable = result.poleRadius < 1.0;
    result.crossings = control::allCrossings(openLoop);
    result.stableGains = control::stableGains(openLoop, result.crossings);
    result.margins =
        control::withStableGains(control::smallestMargins(openLoop), result.crossings, result.stableGains);
    auto bode = bodeOf(openLoop, result.crossings);
    auto roots = rootsOf(openLoop, std::move(closedLoop));
    if (!bode || !roots) {
        return failure(!bode ? bode.error() : roots.error());
    }
    result.bode = *std::move(bode);
    result.roots = *std::move(roots);
    takeDominantPair(result, openLoop.timeBase());
    return {};
}

void takeStep(AnalysisResult& result, control::LoopStep step, int pointsPerSample) {
    result.step = step.metrics;
    result.stepCurve = {std::move(step.time_s), std::move(step.response_rad), std::move(step.current_A),
                        pointsPerSample};
}

StepExtent stepExtent(const AnalysisResult& result, double period_s) {
    constexpr double TimeConstants = 6.0;
    constexpr double UsualSamples = 2000.0;
    constexpr double MostSamples = 100000.0; // some milliseconds of work
    const auto samplesOf = [](double radius) {
        return -TimeConstants / std::log(std::clamp(radius, 1e-9, 1.0 - 1e-12));
    };
    const double all = samplesOf(result.poleRadius);
    double shape = all; // until nothing but one slow exponential is left, which makes no peak any more
    std::vector<std::complex<double>> poles = result.roots.closedLoop;
    std::sort(poles.begin(), poles.end(),
              [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
    if (poles.size() > 1 && poles[0].imag() == 0.0 && poles[0].real() > 0.0) {
        shape = 1.5 * samplesOf(std::abs(poles[1])); // 9 time constants: 1e-4 of what they were
    }
    const double first = std::clamp(std::min(all, std::max(shape, UsualSamples)), 100.0, MostSamples);
    return {first * period_s, std::clamp(all, first, MostSamples) * period_s,
            std::min(all, shape) <= MostSamples};
}

int stepPointsPerSample(double duration_s, double period_s) {
    constexpr double Points = 20000.0;
    return static_cast<int>(std::clamp(std::floor(Points * period_s / duration_s + 1e-6), 1.0, 10.0));
}

void withholdStep(AnalysisResult& result) {
    if (!result.step) {
        return;
    }
    result.step.reset();
    result.warnings.push_back(
        {"step_too_long",
         fmt::format(
             "no figures of the step: its slowest part decays by {:.3g} per sample, too slow to simulate",
             1.0 - result.poleRadius),
         "use gains with faster poles, or a longer sampling period"});
}

double peakCurrent_A(const AnalysisResult::Step& step) {
    double peak_A = 0.0;
    for (const double current_A : step.current_A) {
        peak_A = std::max(peak_A, std::abs(current_A));
    }
    return peak_A;
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

Result<void> checkPositionGains(const control::PidGains& parallel) {
    if (parallel.proportional <= 0.0 || parallel.integral < 0.0 || parallel.derivative < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("K_P = {:.4g}, K_I = {:.4g}, K_D = {:.4g} is not a valid position loop",
                                   parallel.proportional, parallel.integral, parallel.derivative),
                       "K_P must be positive, K_I and K_D not negative");
    }
    return {};
}

void addStabilityWarnings(AnalysisResult& result, double proportional_A_per_rad) {
    if (!result.isStable) {
        result.warnings.push_back(
            {"unstable", fmt::format("the sampled loop is unstable: pole radius {:.4f}", result.poleRadius),
             stabilityHint(result.stableGains)});
    }
    // A limit of zero is none: K_D alone makes the loop unstable, which `unstable` says.
    if (result.proportionalLimit_A_per_rad > 0.0 &&
        proportional_A_per_rad > result.proportionalLimit_A_per_rad) {
        result.warnings.push_back(
            {"above_sampled_limit",
             fmt::format(
                 "K_P = {:.4g} A/rad is {:.3g} times the limit of {:.4g} A/rad at this sampling and delay",
                 proportional_A_per_rad, proportional_A_per_rad / result.proportionalLimit_A_per_rad,
                 result.proportionalLimit_A_per_rad),
             "the rotor makes at best small steps; large steps end in a limit cycle"});
    }
    constexpr double LittleDamping_ratio = 0.15;
    if (result.isStable && result.dominantDamping_ratio.value_or(1.0) < LittleDamping_ratio) {
        result.warnings.push_back(
            {"little_damping",
             fmt::format(
                 "the loop is nearly undamped (zeta = {:.3g} at {:.4g} rad/s): damping is by friction only",
                 *result.dominantDamping_ratio, *result.dominantFrequency_rad_s),
             "a PI loop has little damping on this motor; add derivative action: method recommended"});
    }
    constexpr double LeastPhaseMargin_deg = 20.0;
    constexpr double LeastGainMargin_ratio = 1.5;
    if (result.isStable &&
        (result.margins.phaseMargin_deg < LeastPhaseMargin_deg ||
         std::abs(std::log(result.margins.gainMargin_ratio)) < std::log(LeastGainMargin_ratio))) {
        result.warnings.push_back(
            {"small_margin",
             fmt::format("small margins: phase {:.3g} deg, gain factor {:.3g}",
                         result.margins.phaseMargin_deg, result.margins.gainMargin_ratio),
             "usual minimum: 30 deg and factor 2"});
    }
}

void addDelayWarning(AnalysisResult& result, double poleRadiusOneSampleLater) {
    if (result.isStable && poleRadiusOneSampleLater >= 1.0) {
        result.warnings.push_back(
            {"delay_sensitive",
             fmt::format("one more sample of delay makes this loop unstable: delay margin {:.3g} ms",
                         1e3 * result.margins.delayMargin_s),
             "check the delay (delay.samples), or use a slower loop"});
    }
}

void addFrictionWarning(AnalysisResult& result, bool hasIntegral) {
    const double band_deg = radiansToDegrees(result.frictionBand_rad);
    constexpr double NotableBand_deg =
        0.64; // the accuracy that the published loop claims (htm-theory.md 6.7)
    if (band_deg > NotableBand_deg) {
        result.warnings.push_back(
            {"friction_band",
             fmt::format("friction holds the rotor within +-{:.3g} deg of the reference", band_deg),
             hasIntegral ? "only the integral action removes the standstill error, slowly; the micro-step "
                           "assist or a larger K_P narrows the band"
                         : "the micro-step assist or a larger K_P narrows the band"});
    }
}

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
                 "the stray field of the coils is not compensated and couples the current into the angle: "
                 "with this gain the loop can alternate every sample",
                 "switch the compensation on (stray.enabled)"});
        }
        return;
    }
    if (!stray->error_T_per_A) {
        if (allowed_percent < 100.0) {
            result.warnings.push_back({"stray_field_not_calibrated",
                                       fmt::format("this gain requires a stray coefficient known to better "
                                                   "than {:.0f} %; its error is unknown",
                                                   allowed_percent),
                                       "calibrate the stray field first"});
        }
        return;
    }
    if (perTesla * std::abs(*stray->error_T_per_A) >= WarnFrom_ratio) {
        result.warnings.push_back(
            {"stray_field_error",
             fmt::format("error of the stray coefficient {:.0f} %, this gain requires less than {:.0f} %",
                         100.0 * std::abs(*stray->error_T_per_A) / coefficient_T_per_A, allowed_percent),
             "calibrate the stray field again, or lower the gains"});
    }
}

void addSaturationNote(AnalysisResult& result, double perRadian_A, double currentLimit_A) {
    const double largest_deg = radiansToDegrees(currentLimit_A / perRadian_A);
    const double height_deg = radiansToDegrees(LargeStepHeight_rad);
    constexpr double NotableOvershoot_percent = 15.0;
    const auto overshoot_percent = result.largeStep->overshoot_percent();
    if (result.isStable && !overshoot_percent) {
        result.warnings.push_back({"large_step_not_arrived",
                                   fmt::format("with friction and current limit a step of {:.0f} deg is not "
                                               "settled after {:.3g} s: overshoot unknown",
                                               height_deg, result.largeStep->duration_s()),
                                   "use a faster loop, or one with more integral action"});
    }
    if (result.isStable && overshoot_percent.value_or(0.0) > NotableOvershoot_percent &&
        largest_deg < height_deg) {
        result.warnings.push_back(
            {"large_steps_overshoot",
             fmt::format("steps above {:.3g} deg reach the current limit of {:.3g} A; with limit and "
                         "friction a step of {:.0f} deg overshoots by {:.3g} %",
                         largest_deg, currentLimit_A, height_deg, *overshoot_percent),
             "use a ramp for large moves, or a slower loop"});
    }
}

void addRobustnessWarnings(std::vector<Finding>& warnings, const control::Robustness& robust, bool isStable,
                           bool hasCovariance) {
    if (!hasCovariance) {
        warnings.push_back({"model_without_covariance",
                            "the model has no covariance: robustness assumes an exactly known motor",
                            "identify the motor to get its uncertainty"});
    }
    if (isStable && robust.unstable_fraction > 0.0) {
        warnings.push_back(
            {"not_robust",
             fmt::format("{:.3g} % of the motors within the model's uncertainty are unstable with this loop",
                         100.0 * robust.unstable_fraction),
             "identify more precisely, or choose a slower loop"});
    }
}

} // namespace halbench::app
