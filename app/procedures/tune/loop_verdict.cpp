#include "app/procedures/tune/loop_verdict.h"

#include <algorithm>

namespace halbench::app {

bool restsOnAssumption(const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.code == "stray_field_not_calibrated" || finding.code == "model_without_covariance";
    });
}

std::string loopVerdict(Verdict verdict, const std::vector<Finding>& findings, bool isRobustnessKnown) {
    switch (verdict) {
    case Verdict::Good:
        if (restsOnAssumption(findings)) {
            return "Stable, if what is assumed here is true:";
        }
        return isRobustnessKnown ? "Good: robustly stable" : "Good: stable";
    case Verdict::Doubtful:
        return "Doubtful: read the warnings before you apply it";
    case Verdict::Refused:
        break;
    }
    return "Refused: this loop is unstable";
}

} // namespace halbench::app
