#include "app/batch/tuning_text.h"

#include "app/batch/command_support.h"
#include "app/batch/judgement_text.h"
#include "app/batch/result_documents.h"
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

} // namespace

std::string gainsText(const TuneResult& result) {
    std::string text = fmt::format("method {}\n", result.method);
    const JsonValue body = gainsBody(result);
    for (const JsonMember& gain : body.find("gains")->members()) {
        if (gain.value.isObject()) {
            text += fmt::format("{:<26} {:.6g} {}\n", gain.key, gain.value.find("value")->number(),
                                gain.value.find("unit")->text());
        }
    }
    const AnalysisResult& predicted = result.predicted;
    text += fmt::format("{}, gain margin {:.3g}, phase margin {:.4g} deg\n",
                        predicted.isStable ? "stable" : "UNSTABLE", predicted.margins.gainMargin_ratio,
                        predicted.margins.phaseMargin_deg);
    text += fmt::format("delay margin {:.3g} ms\n", 1e3 * predicted.margins.delayMargin_s);
    text += proofLines(result);
    text += result.bounds ? boundLines(*result.bounds) : std::string();
    return text + cycleLines(result) + disturbanceLines(result) + intervalLines(result.robust) + loopFindingLines(result.quality, true);
}

std::string agreementLine(const ApplyResult& applied) {
    if (!applied.band || !applied.verification) {
        return {};
    }
    return fmt::format(
        "at rest {:.3g} deg from the set-point (allowed {:.3g}, friction band {:.3g}), "
        "at most {:.3g} deg off the prediction, at {:.3g} s\n",
        radiansToDegrees(std::abs(applied.verification->measured.finalError_rad)),
        radiansToDegrees(applied.band->allowed_rad), radiansToDegrees(applied.band->friction_rad),
        radiansToDegrees(std::abs(applied.band->largestOff_rad)), applied.band->largestOffTime_s);
}

} // namespace halbench::app
