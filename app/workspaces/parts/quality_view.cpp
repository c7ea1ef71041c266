#include "app/workspaces/parts/quality_view.h"

#include "widgets/language/phrasebook.h"

namespace halbench::app {

widgets::VerdictLevel verdictLevel(Verdict verdict) {
    return verdict == Verdict::Good       ? widgets::VerdictLevel::Good
           : verdict == Verdict::Doubtful ? widgets::VerdictLevel::Doubtful
                                          : widgets::VerdictLevel::Refused;
}

std::vector<widgets::Remark> remarksOf(const std::vector<Finding>& findings) {
    std::vector<widgets::Remark> remarks;
    remarks.reserve(findings.size());
    for (const Finding& finding : findings) {
        remarks.push_back({widgets::inWords(finding.message), widgets::inWords(finding.hint)});
    }
    return remarks;
}

} // namespace halbench::app
