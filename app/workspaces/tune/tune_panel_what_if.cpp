// What if: the verification move in the Tune panel, and any recorded one, as they would have been with the
// gains that are proposed now.
#include "app/figures/tuning_figures.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/tune/tune_panel.h"
#include "app/workspaces/tune/what_if_page.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"

#include <utility>

namespace halbench::app {
namespace {

std::optional<LoopLaw> lawThatRan(const ApplyResult& result, double period_s) {
    std::map<std::string, double> values;
    for (const ParameterValue& value : result.after) {
        values[value.name] = value.value;
    }
    const auto law = loopLawFromParameters(values, period_s);
    return law ? std::optional(*law) : std::nullopt;
}

} // namespace

/// Judged on a worker; until then, and when it is no record to replay, there is no what-if.
void TunePanel::useRecord(const ApplyResult& result) {
    forgetRecord();
    const auto ran = lawThatRan(result, m_conditions.timing.period_s);
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
           !isSameLaw(m_sketch->loopLaw(), m_record->config.ran, m_conditions.timing.period_s);
}

/// Its band, when nobody moves the gains any more.
void TunePanel::replayRecord() {
    if (isMoving() || !isWhatIfDrawn() || !*m_sketch->whatIf) {
        return;
    }
    m_replaying.run([record = m_record, law = m_sketch->loopLaw()] { return whatIfWithBand(*record, law); },
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
    const DisplayUnits& units = m_bench.displayUnits();
    const RecordedMove& move = m_record->config.move;
    if (whatIf) {
        addWhatIfCurves(figure, *whatIf, m_whatIfSpread ? m_whatIfSpread->band : std::nullopt,
                        move.reference_rad, units.angle);
    }
    const auto said = whatIfRemarks(move, whatIf, m_whatIfSpread, units);
    remarks.insert(remarks.end(), said.begin(), said.end());
}

void TunePanel::connectWhatIf() {
    connect(m_whatIfPage, &WhatIfPage::recordingWanted, this, &TunePanel::chooseRecording);
    connect(m_whatIfPage, &WhatIfPage::used, this, &TunePanel::showRecording);
    connect(m_whatIfPage, &WhatIfPage::refused, this, &TunePanel::refuseRecording);
    connect(m_message, &widgets::MessageBar::actionTriggered, this, &TunePanel::onMessageAction);
}

void TunePanel::chooseRecording() {
    if (!m_chooser.open) {
        return;
    }
    const QString path =
        m_chooser.open(this, {tr("Open a recorded move"), {}, tr("Recording (*.csv *.mf4)")});
    if (!path.isEmpty()) {
        useRecording(path);
    }
}

void TunePanel::useRecording(const QString& path) {
    m_refusedRecording = path; // until it is read
    m_whatIfPage->use(path, {}, m_conditions);
}

/// The one of the message that is shown: of gains that were kept, else of a recording.
void TunePanel::onMessageAction() {
    if (m_message->message().text != m_toldOfDevice) {
        chooseRanGains();
    } else if (m_bench.session().info().isSimulated) {
        Q_EMIT drivingRequested();
    } else {
        Q_EMIT savingRequested();
    }
}

/// The gains of a recording that does not say them.
void TunePanel::chooseRanGains() {
    const QString path =
        m_chooser.open(this, {tr("Open the active gains of the recording"), {}, tr("Gains (*.json)")});
    if (!path.isEmpty()) {
        m_message->clear();
        m_whatIfPage->use(m_refusedRecording, path, m_conditions);
    }
}

void TunePanel::showRecording(const QString& path) {
    m_refusedRecording.clear();
    if (m_message->message().severity == widgets::Severity::Error) {
        m_message->clear(); // of the one before, that was none
    }
    if (!m_bench.identification()) {
        m_message->showMessage({widgets::Severity::Information,
                                tr("The recording is shown after a motor is identified."),
                                {},
                                {}});
    }
    proposeToWhatIf();
    m_figures->setCurrent(m_whatIfPage);
    m_bench.session().message(MessageLevel::Info, tr("Tune"), tr("What-if: %1").arg(path));
}

void TunePanel::refuseRecording(const Error& error) {
    if (needsRanFile(error) && m_chooser.open) {
        m_message->showMessage({widgets::Severity::Error, widgets::inWords(error.message),
                                tr("Choose the file with the gains that were active during the recording."),
                                tr("Recorded gains…")});
    } else {
        showError(error);
    }
}

void TunePanel::forgetRecording() {
    m_whatIfPage->forget();
}

void TunePanel::proposeToWhatIf() {
    const bool hasLaw = m_sketch && !m_problem;
    m_whatIfPage->propose(hasLaw ? std::optional(m_sketch->loopLaw()) : std::nullopt, isMoving());
}

} // namespace halbench::app
