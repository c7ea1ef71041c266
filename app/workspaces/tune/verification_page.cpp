#include "app/workspaces/tune/verification_page.h"

#include "app/figures/tuning_figures.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/picture_scroll.h"
#include "app/workspaces/tune/standstill_ripple.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_session.h"
#include "app/workspaces/tune/what_if_page.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace halbench::app {
namespace {

/// The law on the board during the move.
std::optional<LoopLaw> lawThatRan(const ApplyResult& result, double period_s) {
    std::map<std::string, double> values;
    for (const ParameterValue& value : result.after) {
        values[value.name] = value.value;
    }
    const auto law = loopLawFromParameters(values, period_s);
    return law ? std::optional(*law) : std::nullopt;
}

/// Why the current of a verification is not quiet at its end; nothing for one that did not get there.
QString rippleOf(const ApplyResult& verified, double period_s, const DisplayUnits& units) {
    const auto law = lawThatRan(verified, period_s);
    const auto ripple = law && !law->filtered && verified.quality.verdict != Verdict::Refused
                            ? standstillRipple(verified.verification->recording, law->law.gains, period_s)
                            : std::nullopt;
    return ripple ? rippleWords(*ripple, units) : QString();
}

} // namespace

VerificationPage::VerificationPage(Workbench& bench, TuneSession& session, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_session(session), m_agreement(new widgets::VerdictView(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    m_agreement->setObjectName(QStringLiteral("agreement"));
    column->addWidget(m_agreement);
    auto* scroll = new PictureScroll(*m_agreement, this);
    m_picture = &scroll->picture();
    column->addWidget(scroll, 1); // three plots want more height than a small screen has
}

void VerificationPage::expect(const LoopLaw& law) {
    forget();
    m_law = law;
}

void VerificationPage::showMove(const ApplyResult& result) {
    if (!m_law) {
        return;
    }
    m_verified = result;
    m_isUndone = !result.isKept;
    prepareRecord();
    draw();
    Q_EMIT shown();
}

void VerificationPage::forget() {
    m_law.reset();
    forgetRecord();
    if (m_verified) {
        m_verified.reset();
        m_picture->setFigure({});
        m_agreement->setVerdict(widgets::VerdictLevel::Doubtful, tr("No verification yet"), {});
        Q_EMIT forgotten();
    }
}

void VerificationPage::setUndone() {
    m_isUndone = true;
    draw();
}

/// Judged on a worker; until then, and when it is no record to replay, there is no replay.
void VerificationPage::prepareRecord() {
    forgetRecord();
    const LoopConditions& conditions = m_session.conditions();
    const auto ran = lawThatRan(*m_verified, conditions.timing.period_s);
    auto move = recordedMove(m_verified->verification->recording);
    if (!ran || !move || !m_bench.identification()) {
        return;
    }
    const TuneConfig defaults;
    const WhatIfConfig config{*std::move(move), *ran, conditions, motorEstimate(*m_bench.identification()),
                              UncertaintyDraws{defaults.draws, defaults.seed}};
    m_recalling.run([config] { return prepareWhatIf(config); },
                    [this](Result<WhatIfBasis> basis) {
                        if (basis) {
                            m_record = std::make_shared<const WhatIfBasis>(*std::move(basis));
                            Q_EMIT recordReady();
                        }
                    });
}

void VerificationPage::forgetRecord() {
    m_recalling.cancel();
    cancelReplay();
    m_record.reset();
    m_session.forgetWhatIf();
}

void VerificationPage::cancelReplay() {
    m_replaying.cancel();
    m_replayed.reset();
}

/// The gains that ran have the record itself.
bool VerificationPage::isReplayDrawn() const {
    return m_record && m_session.drawnLaw() && m_session.sketch()->whatIf &&
           !m_session.isDrawn(m_record->config.ran);
}

void VerificationPage::replay() {
    if (m_session.isMoving() || !isReplayDrawn() || !*m_session.sketch()->whatIf) {
        return;
    }
    m_replaying.run(
        [record = m_record, law = m_session.sketch()->loopLaw()] { return whatIfWithBand(*record, law); },
        [this](const Result<WhatIf>& replayed) {
            if (replayed && m_record) {
                m_replayed = *replayed;
                draw();
            }
        });
}

/// Nothing for the gains that ran; why there is none in words.
void VerificationPage::addReplay(widgets::Figure& figure, std::vector<widgets::Remark>& remarks) const {
    if (!isReplayDrawn()) {
        return;
    }
    const Result<WhatIf>& whatIf = *m_session.sketch()->whatIf;
    const DisplayUnits& units = m_bench.displayUnits();
    const RecordedMove& move = m_record->config.move;
    if (whatIf) {
        addWhatIfCurves(figure, *whatIf, m_replayed ? m_replayed->band : std::nullopt, move.reference_rad,
                        units.angle);
    }
    const auto said = whatIfRemarks(move, whatIf, m_replayed, units);
    remarks.insert(remarks.end(), said.begin(), said.end());
}

void VerificationPage::draw() {
    if (!m_verified || !m_verified->verification || !m_verified->band) {
        return;
    }
    const DisplayUnits& units = m_bench.displayUnits();
    widgets::Figure figure =
        verificationFigure(*m_verified->band, m_verified->verification->recording, units.angle);
    std::vector<widgets::Remark> remarks = {
        {agreementWords(*m_verified->band, m_verified->verification->measured, units), {}}};
    const double period_s = m_session.conditions().timing.period_s;
    if (const QString ripple = rippleOf(*m_verified, period_s, units); !ripple.isEmpty()) {
        remarks.push_back({ripple, {}});
    }
    addReplay(figure, remarks);
    m_picture->setFigure(std::move(figure));
    showAgreement(remarks);
}

void VerificationPage::drawIfVisible() {
    if (isVisible()) {
        draw();
    }
}

/// A good verdict beside gains that it is not of would be taken for theirs.
void VerificationPage::showAgreement(const std::vector<widgets::Remark>& remarks) {
    const bool isWithin = m_verified->quality.verdict != Verdict::Refused;
    const bool isOfShown = m_session.isDrawn(*m_law);
    if (isWithin && (m_isUndone || !isOfShown)) {
        m_agreement->setVerdict(widgets::VerdictLevel::Doubtful,
                                m_isUndone ? tr("Within the predicted band (gains no longer active)")
                                           : tr("Within the predicted band (applied gains, not those shown)"),
                                remarks);
        return;
    }
    m_agreement->setVerdict(isWithin ? widgets::VerdictLevel::Good : widgets::VerdictLevel::Refused,
                            isWithin    ? tr("Within the predicted band")
                            : isOfShown ? tr("Outside the predicted band")
                                        : tr("Outside the predicted band (applied gains, not those shown)"),
                            remarks);
}

void VerificationPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    draw(); // the gains may be others by now
}

} // namespace halbench::app
