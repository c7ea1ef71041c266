#include "app/workspaces/tune/axes/axis_verdict.h"

#include "app/procedures/tune/loop_verdict.h"
#include "app/workspaces/parts/quality_view.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>

#include <algorithm>
#include <vector>

namespace halbench::app {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::AxisVerdict)
};

} // namespace

void showAxesVerdict(widgets::VerdictView& view, const Result<TuneAxesResult>& result, bool isWaiting) {
    if (!result) {
        view.setVerdict(
            widgets::VerdictLevel::Doubtful,
            isWaiting ? Words::tr("Computing the loops") : widgets::inWords(result.error().message),
            isWaiting ? std::vector<widgets::Remark>()
                      : std::vector<widgets::Remark>{{widgets::inWords(result.error().hint), {}}});
        return;
    }
    const auto worst = std::max_element(result->axes.begin(), result->axes.end(),
                                        [](const TuneResult& one, const TuneResult& other) {
                                            return one.quality.verdict < other.quality.verdict;
                                        });
    const QString words = widgets::inWords(loopVerdict(result->quality.verdict, worst->warnings, true));
    const bool areAllGood = result->quality.verdict == Verdict::Good;
    view.setVerdict(
        verdictLevel(result->quality.verdict),
        areAllGood ? Words::tr("All axes: %1").arg(words)
                   : Words::tr("Axis %1: %2").arg(QString::fromStdString(worst->conditions.axis->id), words),
        remarksOf(result->quality.findings));
}

} // namespace halbench::app
