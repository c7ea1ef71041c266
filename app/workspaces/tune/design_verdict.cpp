#include "app/workspaces/tune/design_verdict.h"

#include "app/procedures/tune/loop_verdict.h"
#include "app/workspaces/parts/quality_view.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/language/phrasebook.h"

#include <vector>

namespace halbench::app {

void showDesignVerdict(widgets::VerdictView& view, const TuneResult& proposed,
                       const std::optional<Finding>& foreign) {
    std::vector<Finding> warnings = proposed.warnings;
    Verdict verdict = proposed.quality.verdict;
    if (foreign) {
        warnings.insert(warnings.begin(), *foreign);
        verdict = verdict == Verdict::Good ? Verdict::Doubtful : verdict;
    }
    const bool isLimited =
        verdict == Verdict::Good && (restsOnAssumption(warnings) || isNearStabilityLimit(warnings));
    view.setVerdict(isLimited ? widgets::VerdictLevel::Doubtful : verdictLevel(verdict),
                    widgets::inWords(loopVerdict(verdict, warnings, true)), remarksOf(warnings));
}

void showDesignProblem(widgets::VerdictView& view, const Error& problem) {
    view.setVerdict(widgets::VerdictLevel::Refused, widgets::inWords(problem.message),
                    {{widgets::inWords(problem.hint), {}}});
}

} // namespace halbench::app
