#include "app/procedures/tune/loop_verdict.h"

#include <algorithm>
#include <array>

namespace halbench::app {

bool restsOnAssumption(const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.code == "stray_field_not_calibrated" || finding.code == "model_without_covariance";
    });
}

bool isNearStabilityLimit(const std::vector<Finding>& findings) {
    static constexpr std::array Codes = {"delay_sensitive", "small_margin", "little_damping",
                                         "above_sampled_limit"};
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return std::find(Codes.begin(), Codes.end(), finding.code) != Codes.end();
    });
}

std::string loopVerdict(Verdict verdict, const std::vector<Finding>& findings, bool isRobustnessKnown) {
    switch (verdict) {
    case Verdict::Good:
        if (restsOnAssumption(findings)) {
            return "Stable under the stated assumptions:";
        }
        if (isNearStabilityLimit(findings)) {
            return "Stable with little reserve: check the warnings";
        }
        return isRobustnessKnown ? "Good: robustly stable" : "Good: stable";
    case Verdict::Doubtful:
        return "Doubtful: read the warnings before applying";
    case Verdict::Refused:
        break;
    }
    return "Rejected: this loop is unstable";
}

} // namespace halbench::app
