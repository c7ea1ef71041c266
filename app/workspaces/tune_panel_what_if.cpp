// What if: the verification move in the Tune panel as it would have been with the gains that are proposed
// now.
#include "app/report/tuning_figures.h"
#include "app/workspaces/display_quantity.h"
#include "app/workspaces/tune_panel.h"
#include "widgets/figure_view.h"
#include "widgets/phrasebook.h"
#include "widgets/verdict_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

std::optional<control::PositionLaw> lawThatRan(const ApplyResult& result) {
    std::map<std::string, double> values;
    for (const ParameterValue& value : result.after) {
        values[value.name] = value.value;
    }
    const auto law = lawFromParameters(values);
    return law ? std::optional(*law) : std::nullopt;
}

} // namespace

/// Judged on a worker; until then, and when it is no record to replay, there is no what-if.
void TunePanel::useRecord(const ApplyResult& result) {
    forgetRecord();
    const auto ran = lawThatRan(result);
    auto move = recordedMove(result.verification->recording);
    if (!ran || !move || !m_bench.identification()) {
        return;
    }
    const TuneConfig defaults;
    const WhatIfConfig config{*std::move(move), *ran, m_conditions, motorEstimate(*m_bench.identification()),
                              UncertaintyDraws{defaults.draws, defaults.seed}};
    m_recalling.run([config] { return prepareWhatIf(config); },
                    [this](Result<WhatIfBasis> basis) {
                        if (basis) {
                            m_record = std::make_shared<const WhatIfBasis>(*std::move(basis));
                            ask();
                        }
                    });
}

void TunePanel::forgetRecord() {
    m_recalling.cancel();
    m_replaying.cancel();
    m_record.reset();
    m_whatIfSpread.reset();
    if (m_sketch) {
        m_sketch->whatIf.reset();
    }
}

/// The gains that ran have the record itself.
bool TunePanel::isWhatIfDrawn() const {
    return m_record && m_sketch && m_sketch->whatIf && !m_problem &&
           !isSameLaw(m_sketch->law, m_record->config.ran);
}

/// Its band, when nobody moves the gains any more.
void TunePanel::replayRecord() {
    const bool isMoving = m_shaping && m_shaping->isHeld;
    if (isMoving || !isWhatIfDrawn() || !*m_sketch->whatIf) {
        return;
    }
    m_replaying.run([record = m_record, law = m_sketch->law] { return whatIfWithBand(*record, law); },
                    [this](const Result<WhatIf>& replayed) {
                        if (replayed && m_record) {
                            m_whatIfSpread = *replayed;
                            drawVerification();
                        }
                    });
}

/// Nothing for the gains that ran; why there is none in words.
void TunePanel::addWhatIf(widgets::Figure& figure, std::vector<widgets::Remark>& remarks) const {
    if (!isWhatIfDrawn()) {
        return;
    }
    const Result<WhatIf>& whatIf = *m_sketch->whatIf;
    if (!whatIf) {
        remarks.push_back({tr("What the proposed gains would make of this move is not said: %1")
                               .arg(widgets::inWords(whatIf.error().message)),
                           widgets::inWords(whatIf.error().hint)});
        return;
    }
    const DisplayUnits& units = m_bench.displayUnits();
    const RecordedMove& move = m_record->config.move;
    addWhatIfCurves(figure, *whatIf, m_whatIfSpread ? m_whatIfSpread->band : std::nullopt, move.reference_rad,
                    units.angle);
    const MotionFigures would = motionFigures(move.reference_rad, whatIf->angle_rad);
    const MotionFigures was = motionFigures(move.reference_rad, move.position_rad);
    if (would.overshoot_rad && was.overshoot_rad) {
        remarks.push_back(
            {tr("With the proposed gains this move would overshoot by %1 instead of %2 and end %3 from "
                "its set-point instead of %4.")
                 .arg(angleText(*would.overshoot_rad, units), angleText(*was.overshoot_rad, units),
                      angleText(std::abs(would.finalError_rad), units),
                      angleText(std::abs(was.finalError_rad), units)),
             {}});
    }
    for (const Finding& finding : (m_whatIfSpread ? *m_whatIfSpread : *whatIf).quality.findings) {
        remarks.push_back({widgets::inWords(finding.message), widgets::inWords(finding.hint)});
    }
}

} // namespace halbench::app
