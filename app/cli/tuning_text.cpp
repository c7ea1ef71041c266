#include "app/cli/tuning_text.h"

#include "app/cli/command_support.h"
#include "app/cli/judgement_text.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/result_documents.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

namespace {

std::string boundLine(const char* name, const control::BoundUse& use, const char* unit) {
    return fmt::format("{:<26} {:.4g}{} of {:.4g}{}: {}\n", name, use.value, unit, use.bound, unit,
                       use.isActive() ? "at its bound" : "the bound is not reached");
}

/// Which of them keeps the error from being less.
std::string boundLines(const control::LeastErrorBounds& bounds) {
    std::string text = boundLine("bound on Ms", bounds.sensitivity, "");
    if (bounds.current) {
        const std::string name = fmt::format("step of {:.4g} deg", radiansToDegrees(bounds.step_rad));
        text += boundLine(name.c_str(), *bounds.current, " A");
    }
    return text;
}

/// The same controller as times; a form that it has not says why.
std::string formLine(const char* name, const control::PidGains& gains, control::PidForm form) {
    const auto timed = control::convert(gains, form, control::GainUnit::PerRadian);
    if (!timed) {
        return fmt::format("{:<26} none: {}\n", name, timed.error().message);
    }
    const std::string integral = std::isfinite(timed->integral) ? fmt::format("T_i {:.6g} s", timed->integral)
                                                                : std::string("no integral action");
    return fmt::format("{:<26} K {:.6g} A/rad, {}, T_d {:.6g} s\n", name, timed->proportional, integral,
                       timed->derivative);
}

} // namespace

std::string gainsText(const TuneResult& result) {
    std::string text = fmt::format("method {}\n", result.method);
    const JsonValue body = gainsBody(result);
    for (const JsonMember& gain : body.find("gains")->members()) {
        if (gain.value.isObject() && gain.value.find("value") != nullptr) { // else the weights: below
            text += fmt::format("{:<26} {:.6g} {}\n", gain.key, gain.value.find("value")->number(),
                                gain.value.find("unit")->text());
        }
    }
    text += result.filtered ? shapingLines(*result.filtered) : std::string();
    text += formLine("in standard form", result.law.gains, control::PidForm::Standard);
    text += formLine("in series form", result.law.gains, control::PidForm::Series);
    const AnalysisResult& predicted = result.predicted;
    const bool hasNone = !predicted.isStable && std::isinf(predicted.margins.gainMargin_ratio);
    const std::string gainMargin =
        hasNone ? std::string("none") : fmt::format("{:.3g}", predicted.margins.gainMargin_ratio);
    text += fmt::format("{}, gain margin {}, phase margin {:.4g} deg\n",
                        predicted.isStable ? "stable" : "UNSTABLE", gainMargin,
                        predicted.margins.phaseMargin_deg);
    text += fmt::format("delay margin {:.3g} ms\n", 1e3 * predicted.margins.delayMargin_s);
    text += proofLines(result);
    text += result.bounds ? boundLines(*result.bounds) : std::string();
    return text + cycleLines(result) + disturbanceLines(result) + intervalLines(result.robust) +
           loopFindingLines(result.quality, true);
}

std::string agreementLine(const ApplyResult& applied) {
    if (!applied.band || !applied.verification) {
        return {};
    }
    return fmt::format(
        "at rest {:.3g} deg from the set-point (allowed {:.3g}, friction band {:.3g}), "
        "at most {:.3g} deg off the prediction, at {:.3g} s\n",
        radiansToDegrees(std::abs(applied.verification->measured.finalError)),
        radiansToDegrees(applied.band->allowed_rad), radiansToDegrees(applied.band->friction_rad),
        radiansToDegrees(std::abs(applied.band->largestOff_rad)), applied.band->largestOffTime_s);
}

} // namespace halbench::app
