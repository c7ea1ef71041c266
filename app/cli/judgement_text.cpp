#include "app/cli/judgement_text.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

std::string proofLines(const TuneResult& result) {
    if (!result.assessment) {
        return {};
    }
    std::string text;
    const auto line = [&](const char* name, double value, const char* unit) {
        if (std::isfinite(value)) {
            text += fmt::format("{:<26} {:.4g}{}\n", name, value, unit);
        }
    };
    line("peak of sensitivity, Ms", result.assessment->peaks.Ms_ratio, "");
    line("noise gain", result.assessment->noiseGain_A_per_rad, " A/rad");
    if (result.assessment->isStable) {
        line("step within the limit", radiansToDegrees(result.assessment->largestStep_rad), " deg");
    }
    line("pole radius, 1 sample late", result.assessment->poleRadiusOneSampleLater, "");
    return text;
}

std::string cycleLines(const TuneResult& result) {
    std::string text = fmt::format("{:<26} +-{:.3g} deg\n", "friction band at rest",
                                   radiansToDegrees(result.predicted.frictionBand_rad));
    if (std::isfinite(result.release_s)) {
        text +=
            fmt::format("{:<26} {:.3g} s, from half of it\n", "the integral ends a rest", result.release_s);
    }
    if (!result.cycles) {
        return text + fmt::format("{:<26} not predicted for this law or motor\n", "limit cycles");
    }
    if (result.cycles->empty()) {
        return text + fmt::format("{:<26} none\n", "limit cycles");
    }
    for (const PredictedCycle& cycle : *result.cycles) {
        text += fmt::format("{:<26} +-{:.3g} deg at {:.3g} Hz, to {:.0f} %\n",
                            cycle.isStable ? "limit cycle" : "threshold of the next",
                            radiansToDegrees(cycle.amplitude_rad), cycle.frequency_Hz,
                            100.0 * cycle.accuracy_ratio);
    }
    return text;
}

std::string disturbanceLines(const TuneResult& result) {
    if (!result.disturbance) {
        return {};
    }
    const control::LoadStep& step = result.disturbance->step;
    const auto& band = result.disturbance->band;
    std::string text = fmt::format("load worth {:.4g} A\n", result.disturbance->load_A);
    const auto interval = [](const control::Robustness::Interval& spread, double factor) {
        return fmt::format(", {:.4g} to {:.4g} of 5 % to 95 %", factor * spread.p5, factor * spread.p95);
    };
    text += fmt::format("{:<26} {:.4g} deg{}\n", "moves it by at most", radiansToDegrees(step.peak_rad),
                        band ? interval(band->peak_rad, radiansToDegrees(1.0)) : std::string());
    const bool isKnown = band && band->recoveryTime_s;
    text += step.recoveryTime_s
                ? fmt::format("{:<26} {:.4g} s{}\n", "back to a tenth after", *step.recoveryTime_s,
                              isKnown ? interval(*band->recoveryTime_s, 1.0) : std::string())
                : fmt::format("{:<26} not in the time that was looked at\n", "back to a tenth");
    return text + fmt::format("{:<26} {:.4g} deg\n", "in the end", radiansToDegrees(step.final_rad));
}

std::string intervalLines(const control::Robustness& robust, const std::string& drawn) {
    if (!robust.isUncertain) {
        return "margins: no interval is known, the model has no covariance\n";
    }
    if (robust.unstable_fraction >= 1.0) {
        return fmt::format("unstable with all {} {} that the data allow\n", robust.draws, drawn);
    }
    std::string text =
        fmt::format("margins of 5 % to 95 % of {} {} that the data allow", robust.draws, drawn);
    text += robust.unstable_fraction > 0.0
                ? fmt::format(", without the {:.3g} % that are unstable\n", 100.0 * robust.unstable_fraction)
                : "\n";
    const auto line = [&text](const char* name, const std::optional<control::Robustness::Interval>& interval,
                              const char* unit) {
        if (interval) {
            text += fmt::format("{:<26} {:.4g} to {:.4g}{}\n", name, interval->p5, interval->p95, unit);
        }
    };
    line("gain margin", robust.gainMargin_ratio, "");
    line("phase margin", robust.phaseMargin_deg, " deg");
    line("delay margin", robust.delayMargin_s, " s");
    line("modulus margin", robust.modulusMargin, "");
    line("gain crossover", robust.gainCrossover_rad_s, " rad/s");
    return text;
}

} // namespace halbench::app
