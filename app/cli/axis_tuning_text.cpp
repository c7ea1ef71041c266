#include "app/cli/axis_tuning_text.h"

#include "app/cli/judgement_text.h"
#include "app/documents/axis_loop_documents.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/result_text.h"
#include "app/procedures/tune/loop_axis.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {
namespace {

std::string gainLines(const JsonValue& gains) {
    std::string text;
    for (const char* key : {"kp", "ki", "kd", "feedforward_inertia"}) {
        const JsonValue& gain = *gains.find(key);
        text +=
            fmt::format("{:<26} {:.6g} {}\n", key, gain.find("value")->number(), gain.find("unit")->text());
    }
    return text;
}

std::string loopLines(const TuneResult& result, const JsonValue& body) {
    std::string text = fmt::format("{}\n", result.predicted.isStable ? "stable" : "UNSTABLE");
    text += figureLines("margins of the sampled loop", *body.find("margins"));
    if (const JsonValue* step = body.find("step"); step->isObject()) {
        text += figureLines("small step, without friction and effort limit", *step);
    }
    if (const JsonValue* step = body.find("large_step"); step->isObject()) {
        text += figureLines("test step, with friction and effort limit", *step);
    }
    return text + intervalLines(result.robust) + loopFindingLines(result.quality, true);
}

std::string jointLine(const TuneAxesResult& result) {
    return result.joint && result.axes.size() > 1
               ? fmt::format("all axes together: {:.3g} % of {} draws are unstable\n",
                             100.0 * result.joint->unstable_fraction, result.joint->draws)
               : std::string();
}

std::string verifiedLines(const AxisVerification& verified) {
    const ApplyResult& assessment = verified.assessment;
    if (!assessment.verification || !assessment.predicted || !assessment.band) {
        return {};
    }
    const LoopAxis axis = loopAxisOf(verified.axis);
    const MoveFigures& seen = assessment.verification->measured;
    std::string text = fmt::format(
        "axis {}: overshoot {:.3g} % (predicted {:.3g}), rise {:.3g} s (predicted {:.3g})\n", axis.id,
        seen.overshoot_percent.value_or(0.0), assessment.predicted->overshoot_percent.value_or(0.0),
        seen.riseTime_s.value_or(0.0), assessment.predicted->riseTime_s.value_or(0.0));
    text += fmt::format("axis {}: at rest {} from the set-point (allowed {}), at most {} off the prediction, "
                        "at {:.3g} s\n",
                        axis.id, positionText(axis, std::abs(seen.finalError)),
                        positionText(axis, assessment.band->allowed_rad),
                        positionText(axis, std::abs(assessment.band->largestOff_rad)),
                        assessment.band->largestOffTime_s);
    if (const auto& effort = assessment.band->effort) {
        text += fmt::format(
            "axis {}: took {:.3g} times the effort that the model needs (allowed {:.3g} to {:.3g})\n",
            axis.id, effort->ratio, effort->low, effort->high);
    }
    for (const CrossAxisPeak& other : assessment.verification->others) {
        const LoopAxis held = loopAxisOf(other.axis);
        text += fmt::format("axis {}: meanwhile {} went {} away (allowed {})\n", axis.id, held.id,
                            positionText(held, other.measured),
                            positionText(held, crossAxisTolerance(other.axis)));
    }
    return text;
}

std::string textOf(const TuneAxesResult& result, bool withGains) {
    std::string text;
    for (const TuneResult& axis : result.axes) {
        const LoopAxis& of = axis.conditions.axis.value();
        text += fmt::format("axis {}\n", of.id);
        if (withGains) {
            const JsonValue gains = inUnitsOf(of, gainsBody(axis));
            text += fmt::format("method {}\n", axis.method) + gainLines(*gains.find("gains"));
            text += axis.filtered ? shapingLines(*axis.filtered) : std::string();
        }
        text += loopLines(axis, inUnitsOf(of, analysisBody(axis.predicted)));
    }
    return text + jointLine(result);
}

} // namespace

std::string axisGainsText(const TuneAxesResult& result) {
    return textOf(result, true);
}

std::string appliedAxesText(const ApplyAxesResult& result, Verdict verdict) {
    const DataQuality quality{verdict, result.quality.findings};
    std::string text;
    for (const AxisVerification& verified : result.axes) {
        text += verifiedLines(verified);
    }
    return text + fmt::format("{}\n{}",
                              result.isKept ? "applied and verified" : "not kept, old gains restored",
                              findingLines(quality));
}

std::string axisAnalysisText(const TuneAxesResult& result) {
    return textOf(result, false);
}

} // namespace halbench::app
