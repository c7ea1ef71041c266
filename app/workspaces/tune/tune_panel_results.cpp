// What the Tune panel shows of an answer and does with it.
#include "app/documents/result_documents.h"
#include "app/figures/tuning_figures.h"
#include "app/procedures/tune/loop_verdict.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/workbench/departure_text.h"
#include "app/workspaces/parts/foreign_motor_notice.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/parts/quality_view.h"
#include "app/workspaces/tune/axis_tune_panel.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/standstill_ripple.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_panel.h"
#include "control/base/assert.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"

#include <QPointer>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

/// A verdict that rests on an assumption or is near the limit of stability says so and does not look good. Of
/// another motor than the one that is connected, it is doubtful before everything else.
void showVerdict(widgets::VerdictView& view, const TuneResult& proposed,
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

/// Why the current of a verification is not quiet at its end; nothing for one that did not get there.
QString rippleOf(const ApplyResult& verified, const LoopConditions& conditions, const DisplayUnits& units) {
    std::map<std::string, double> values;
    for (const ParameterValue& value : verified.after) {
        values[value.name] = value.value;
    }
    const auto law = loopLawFromParameters(values, conditions.timing.period_s);
    const auto ripple =
        law && !law->filtered && verified.quality.verdict != Verdict::Refused
            ? standstillRipple(verified.verification->recording, law->law.gains, conditions.timing.period_s)
            : std::nullopt;
    return ripple ? rippleWords(*ripple, units) : QString();
}

/// Keep comes to where Apply was clicked: not for a double click, nor before the picture can have been seen.
constexpr int LeastLook_ms = 1000;

QString firstFinding(const DataQuality& quality) {
    return quality.findings.empty() ? QString() : widgets::inWords(quality.findings.front().message);
}

} // namespace

void TunePanel::showSketch(Result<TuneSketch> sketch) {
    if (!sketch) {
        m_shaping.reset(); // what waited for it began from a loop that is not there
        showProblem(sketch.error());
        judge();
        return;
    }
    if (m_form->origin() != TuneForm::Origin::Edited) {
        m_gains->setLaw(sketch->law);
        m_filters->setShaping(sketch->filtered);
    }
    m_sketch = *std::move(sketch);
    m_steady = m_sketch->steady;
    drawPredictions();
    drawShownVerification(); // what if its move had been made with these gains
    proposeToWhatIf();
    showShape();
    if (m_shaping && m_shaping->isWaiting) {
        takeShape(); // the hand went on meanwhile
    }
    if (m_sketching.isBusy()) {
        return; // for other gains already
    }
    if (isMoving()) {
        m_rest.start(); // the next move would come before the judgement, and wait for its thread
    } else {
        judge();
    }
}

void TunePanel::showAnswer(const Result<TuneResult>& answer, std::optional<double> bandwidth_rad_s) {
    if (!answer) {
        showProblem(answer.error());
        return;
    }
    if (!m_bench.identification()) {
        return; // the project was closed meanwhile
    }
    const TuneResult& proposed = *answer;
    m_shown = proposed;
    m_problem.reset();
    m_bandwidth_rad_s = bandwidth_rad_s;
    m_numbers->setNumbers(tuneNumbers(proposed, present(), m_bench.displayUnits()));
    if (m_sketch) {
        drawLoaded();
    }
    const DeviceSession& session = m_bench.session();
    showVerdict(*m_verdict, proposed,
                session.state() == SessionState::Connected
                    ? foreignMotor(m_bench.provenance().header.device, session.info())
                    : std::nullopt);
    if (m_restored) {
        m_bench.setDesignOfProject(proposed, m_restored->started);
    } else {
        m_bench.setDesign(proposed);
    }
    showDesigns();
    refreshButtons();
    spreadLargeStep(proposed);
    replayRecord();
}

void TunePanel::showProblem(const Error& error) {
    m_shown.reset();
    m_problem = error;
    drawShownVerification();
    proposeToWhatIf();
    m_verdict->setVerdict(widgets::VerdictLevel::Refused, widgets::inWords(error.message),
                          {{widgets::inWords(error.hint), {}}});
    showDesigns(); // what was proposed before is not proposed any more
    refreshButtons();
}

void TunePanel::refreshButtons() {
    const bool isUsable = m_shown && m_shown->quality.verdict != Verdict::Refused && !obstacle();
    m_apply->setEnabled(isUsable && m_preflight->isPassed() && m_foreign->isAllowed() && !m_isApplying);
    m_save->setEnabled(m_shown.has_value());
    if (obstacle().has_value() != m_isObstacleSaid) {
        m_isObstacleSaid = obstacle().has_value();
        refreshOutlook();
    }
    m_numbers->setUndecided(!m_before.empty());
    m_keep->setVisible(!m_before.empty());
    m_restore->setVisible(!m_before.empty());
    const bool isFree =
        m_bench.session().state() == SessionState::Connected && m_bench.session().procedure().isEmpty();
    m_keep->setEnabled(isFree && !m_decision.isActive());
    m_restore->setEnabled(isFree && !m_bench.session().report().board.isArmed); // a loop that runs would jump
}

/// To decide is next; after that to choose other gains. Apply goes off while its prediction is asked anew.
void TunePanel::focusNext() {
    if (m_decision.isActive()) {
        m_figures->focusCurrent();
        return;
    }
    QWidget* next = m_before.empty() ? static_cast<QWidget*>(m_form) : m_keep;
    next->setFocus(Qt::OtherFocusReason);
}

std::optional<Error> TunePanel::obstacle() const {
    if (!m_sketch || m_bench.session().state() != SessionState::Connected) {
        return std::nullopt;
    }
    if (m_sketch->filtered && m_inSteps->isChecked()) {
        return Error{ErrorCode::Refused,
                     "gains with set-point weights or filters cannot be applied gradually",
                     "switch gradual applying off"};
    }
    const auto offered =
        checkOffered(asFiltered(m_sketch->loopLaw()), boardLawSpec(m_bench.session().catalogue()));
    return offered ? std::nullopt : std::optional(offered.error());
}

void TunePanel::apply() {
    const LoopLaw law(m_shown->law, m_shown->filtered);
    const auto values = lawForDevice(law, m_bench.session().catalogue());
    if (!values) {
        showError(values.error());
        return;
    }
    const auto document = toJsonText(gainsDocument(m_bench.designHeader(), *m_shown));
    HB_ASSERT(document.has_value()); // a result holds finite numbers only
    const devices::DeviceInfo& info = m_bench.session().info();
    m_applying = {*document, law, QString::fromStdString(info.id), info.isSimulated};
    m_message->clear();
    forgetVerification();
    m_isOfThisMotor = true;
    m_preflight->setRunning(tr("Verification running"));
    startApplying(law, *values);
    if (!m_isApplying) {
        m_preflight->setRunning({});
    }
    m_progress->setText(tr("Writing the gains"));
    m_progress->setProgress(0.0);
    m_progress->setVisible(m_isApplying);
    if (m_isApplying) {
        m_progress->setFocus(Qt::OtherFocusReason);
    }
    refreshButtons();
}

void TunePanel::finishApply(const Result<ApplyResult>& result) {
    m_isApplying = false;
    m_preflight->setRunning({});
    m_progress->hide();
    if (!result) {
        if (const auto departure = departureMessage(m_bench.session(), result.error())) {
            m_toldOfDevice.clear(); // it stays when the device is gone
            m_message->showMessage(*departure);
        } else if (result.error().code == ErrorCode::Interrupted) {
            tellOfDevice({widgets::Severity::Information, tr("Cancelled. Previous gains restored."), {}, {}});
        } else {
            showError(result.error());
        }
        refreshButtons();
        return;
    }
    if (result->verification && m_isOfThisMotor) {
        showVerification(*result);
    }
    if (result->isKept) {
        for (const ParameterValue& old : result->before) {
            const bool isKnown =
                std::any_of(m_before.begin(), m_before.end(),
                            [&](const ParameterValue& older) { return older.name == old.name; });
            if (!isKnown) { // else an earlier apply is not decided either: restored is what was before both
                m_before.push_back(old);
            }
        }
        m_undecided = m_applying;
        m_decision.start(LeastLook_ms);
        const QString done = tr("Applied and verified: the move matched the prediction.");
        m_bench.session().message(MessageLevel::Info, tr("Tune"), done);
        tellOfDevice(
            {widgets::Severity::Success, done, tr("Keep the new gains, or restore the previous ones."), {}});
    } else {
        const QString undone = tr("Not kept, previous gains restored: %1").arg(firstFinding(result->quality));
        m_bench.session().message(MessageLevel::Warning, tr("Tune"), undone);
        tellOfDevice({widgets::Severity::Warning,
                      undone,
                      result->quality.findings.empty()
                          ? QString()
                          : widgets::inWords(result->quality.findings.front().hint),
                      {}});
    }
    refreshButtons();
    focusNext();
}

void TunePanel::showVerification(const ApplyResult& result) {
    m_verified = result;
    m_isUndone = !result.isKept;
    useRecord(result);
    drawVerification();
    m_figures->setPageEnabled(m_verificationPage, true);
    m_figures->setCurrent(m_verificationPage);
}

/// Neither its verdict, nor its picture, nor what was said of it holds any longer.
void TunePanel::forgetVerification() {
    m_isOfThisMotor = false;
    forgetRecord();
    if (m_verified) {
        m_verified.reset();
        m_verification->setFigure({});
        m_agreement->setVerdict(widgets::VerdictLevel::Doubtful, tr("No verification yet"), {});
        if (!m_verificationPage->isHidden()) { // else another picture is chosen
            m_figures->setCurrent(m_loop);
        }
        m_figures->setPageEnabled(m_verificationPage, false);
    }
    forgetToldOfDevice();
}

void TunePanel::forgetToldOfDevice() {
    if (m_message->message().text == std::exchange(m_toldOfDevice, QString())) {
        m_message->clear();
    }
}

void TunePanel::drawVerification() {
    if (!m_verified || !m_verified->verification || !m_verified->band) {
        return;
    }
    const DisplayUnits& units = m_bench.displayUnits();
    widgets::Figure figure =
        verificationFigure(*m_verified->band, m_verified->verification->recording, units.angle);
    std::vector<widgets::Remark> remarks = {
        {agreementWords(*m_verified->band, m_verified->verification->measured, units), {}}};
    if (const QString ripple = rippleOf(*m_verified, m_conditions, units); !ripple.isEmpty()) {
        remarks.push_back({ripple, {}});
    }
    addWhatIf(figure, remarks);
    m_verification->setFigure(std::move(figure));
    showAgreement(remarks);
}

/// The hand that moves the gains pays for it only where it is seen; showing the page draws it.
void TunePanel::drawShownVerification() {
    if (m_verificationPage->isVisible()) {
        drawVerification();
    }
}

/// A green verdict beside gains that it is not of would be taken for theirs.
void TunePanel::showAgreement(const std::vector<widgets::Remark>& remarks) {
    const bool isWithin = m_verified->quality.verdict != Verdict::Refused;
    const bool isOfShown = m_applying && m_sketch && !m_problem &&
                           isSameLaw(m_sketch->loopLaw(), m_applying->law, m_conditions.timing.period_s);
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

void TunePanel::restore() {
    const QPointer<TunePanel> self(this);
    m_bench.writeValues(m_before, [self](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (!written) {
            self->showError(written.error());
            return;
        }
        self->m_before.clear();
        self->m_undecided.reset();
        self->m_isUndone = true;
        self->drawVerification();
        const QString done = tr("Previous gains restored.");
        self->m_bench.session().message(MessageLevel::Info, tr("Tune"), done);
        self->tellOfDevice({widgets::Severity::Success, done, {}, {}});
        self->refreshButtons();
        self->focusNext();
    });
}

void TunePanel::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    m_save->setVisible(bool(m_chooser.save));
    m_open->setVisible(bool(m_chooser.open));
    m_measure->setVisible(bool(m_chooser.open));
    if (m_axes != nullptr) {
        m_axes->setFileChooser(m_chooser);
    }
}

void TunePanel::tellOfDevice(const widgets::Message& message) {
    m_toldOfDevice = message.text;
    m_message->showMessage(message);
}

void TunePanel::showError(const Error& error) {
    m_message->showMessage(
        {widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
}

} // namespace halbench::app
