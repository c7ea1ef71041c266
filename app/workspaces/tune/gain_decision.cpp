#include "app/workspaces/tune/gain_decision.h"

#include "app/documents/result_documents.h"
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/workbench/departure_text.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/design_comparison.h"
#include "app/workspaces/tune/tune_messages.h"
#include "app/workspaces/tune/tune_session.h"
#include "control/base/assert.h"
#include "widgets/language/phrasebook.h"

#include <QPointer>

#include <algorithm>
#include <functional>
#include <utility>

namespace halbench::app {
namespace {

/// Not for a double click, nor before the picture can have been seen.
constexpr int LeastLook_ms = 1000;

} // namespace

GainDecision::GainDecision(Workbench& bench, const TuneSession& session, DesignComparison& designs,
                           TuneMessages& messages, QObject* parent)
    : QObject(parent), m_bench(bench), m_session(session), m_designs(designs), m_messages(messages) {
    m_look.setSingleShot(true);
    connect(&m_look, &QTimer::timeout, this, [this] {
        Q_EMIT changed();
        Q_EMIT looked();
    });
}

std::map<std::string, double> GainDecision::valuesBefore() const {
    std::map<std::string, double> values = m_bench.deviceValues();
    for (const ParameterValue& old : m_before) {
        values[old.name] = old.value;
    }
    return values;
}

void GainDecision::apply(bool isGradual) {
    const TuneResult& proposed = *m_session.proposed();
    const LoopLaw law(proposed.law, proposed.filtered);
    const auto values = lawForDevice(law, m_bench.session().catalogue());
    if (!values) {
        m_messages.showError(values.error());
        return;
    }
    const auto document = toJsonText(gainsDocument(m_bench.designHeader(), proposed));
    HB_ASSERT(document.has_value()); // a result holds finite numbers only
    const devices::DeviceInfo& info = m_bench.session().info();
    m_applying = {*document, law, QString::fromStdString(info.id), info.isSimulated};
    Q_EMIT started(law);
    start(law, *values, isGradual);
}

/// At once or in small steps: one procedure, one answer.
void GainDecision::start(const LoopLaw& law, std::vector<ParameterValue> values, bool isGradual) {
    std::function<Result<ApplyResult>(devices::Device&, const ProcedureObserver&)> work;
    const MotorEstimate motor = motorEstimate(*m_bench.identification());
    if (isGradual) {
        LiveApplyConfig config;
        config.target = law.law;
        config.motor = motor;
        config.conditions = m_session.conditions();
        work = [config](devices::Device& device, const ProcedureObserver& observer) -> Result<ApplyResult> {
            auto walked = runLiveApply(device, config, observer);
            return walked ? Result<ApplyResult>(std::move(walked->apply)) : failure(walked.error());
        };
    } else {
        const ApplyConfig config{std::move(values), stepVerification(motor)};
        work = [config](devices::Device& device, const ProcedureObserver& observer) {
            return runApply(device, config, observer);
        };
    }
    const QPointer<GainDecision> self(this);
    m_isApplying = m_bench.session().runProcedure(tr("Apply"), std::move(work),
                                                  [self](const Result<ApplyResult>& result) {
                                                      if (self) {
                                                          self->finish(result);
                                                      }
                                                  });
}

void GainDecision::finish(const Result<ApplyResult>& result) {
    m_isApplying = false;
    if (!result) {
        showFailure(result.error());
        Q_EMIT changed();
        return;
    }
    if (result->verification) {
        Q_EMIT verified(*result);
    }
    if (result->isKept) {
        await(*result);
    } else {
        const std::vector<Finding>& findings = result->quality.findings;
        const QString cause = findings.empty() ? QString() : widgets::inWords(findings.front().message);
        const QString hint = findings.empty() ? QString() : widgets::inWords(findings.front().hint);
        tell(MessageLevel::Warning,
             {widgets::Severity::Warning, tr("Not kept, previous gains restored: %1").arg(cause), hint, {}});
    }
    Q_EMIT changed();
    Q_EMIT settled();
}

void GainDecision::showFailure(const Error& error) {
    if (const auto departure = departureMessage(m_bench.session(), error)) {
        m_messages.keepOfDevice();
        m_messages.show(*departure);
    } else if (error.code == ErrorCode::Interrupted) {
        m_messages.showOfDevice(
            {widgets::Severity::Information, tr("Cancelled. Previous gains restored."), {}, {}});
    } else {
        m_messages.showError(error);
    }
}

void GainDecision::await(const ApplyResult& result) {
    for (const ParameterValue& old : result.before) {
        const bool isKnown = std::any_of(m_before.begin(), m_before.end(),
                                         [&](const ParameterValue& older) { return older.name == old.name; });
        if (!isKnown) { // else an earlier apply is not decided either: restored is what was before both
            m_before.push_back(old);
        }
    }
    m_undecided = m_applying;
    m_look.start(LeastLook_ms);
    tell(MessageLevel::Info, {widgets::Severity::Success,
                              tr("Applied and verified: the move matched the prediction."),
                              tr("Keep the new gains, or restore the previous ones."),
                              {}});
}

/// In place, and its text in the log.
void GainDecision::tell(MessageLevel level, const widgets::Message& message) {
    m_bench.session().message(level, tr("Tune"), message.text);
    m_messages.showOfDevice(message);
}

void GainDecision::keep() {
    m_before.clear();
    QString remedy = tr("To keep them: Save to device, in the Parameters panel.");
    if (m_undecided) {
        m_kept = std::exchange(m_undecided, std::nullopt);
        const QString design = savedName(*m_kept, tr("kept on %1"));
        remedy = m_kept->isSimulated
                     ? tr("They are saved as design '%1' and can be applied again.").arg(design)
                     : remedy + QLatin1Char(' ') + tr("They are saved as design '%1'.").arg(design);
    }
    const bool isSimulated = m_bench.session().info().isSimulated; // new whenever it is connected
    tell(MessageLevel::Info,
         {widgets::Severity::Information,
          isSimulated ? tr("New gains active until disconnect.") : tr("New gains active until power-off."),
          remedy, isSimulated ? tr("Drive the motor") : tr("Open Parameters")});
    Q_EMIT changed();
    Q_EMIT settled();
    Q_EMIT kept();
}

void GainDecision::restore() {
    const QPointer<GainDecision> self(this);
    m_bench.writeValues(m_before, [self](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (!written) {
            self->m_messages.showError(written.error());
            return;
        }
        self->m_before.clear();
        self->m_undecided.reset();
        Q_EMIT self->restored();
        self->tell(MessageLevel::Info, {widgets::Severity::Success, tr("Previous gains restored."), {}, {}});
        Q_EMIT self->changed();
        Q_EMIT self->settled();
    });
}

void GainDecision::onSavedInDevice() {
    m_kept.reset();
    m_undecided.reset();
}

/// In the project under a name of its own, unless it has these gains already; returns that name.
QString GainDecision::savedName(const AppliedGains& gains, const QString& stem) {
    return QString::fromStdString(
        m_designs.adoptLaw(stem.arg(gains.device).toStdString(), gains.document, gains.law));
}

bool GainDecision::leaveDevice() {
    const DeviceSession& session = m_bench.session();
    const std::uint64_t device = session.state() == SessionState::Lost ? 0 : session.deviceNumber();
    if (std::exchange(m_deviceNumber, device) == device) {
        return false;
    }
    m_before.clear(); // nothing of another one was replaced
    leaveGains();
    return true;
}

/// The device is left: nothing asks, nothing is lost.
void GainDecision::leaveGains() {
    const auto kept = std::exchange(m_kept, std::nullopt);
    const auto undecided = std::exchange(m_undecided, std::nullopt);
    if (!kept && !undecided) {
        return;
    }
    const AppliedGains& gains = undecided ? *undecided : *kept;
    if (kept && undecided) {
        savedName(*kept, tr("kept on %1")); // whatever became of it meanwhile
    }
    const QString design = savedName(gains, undecided ? tr("applied on %1") : tr("kept on %1"));
    const QString what = undecided ? tr("Gains applied on %1 were neither kept nor restored.")
                                   : tr("%1 was disconnected with the kept gains.");
    const QString until = gains.isSimulated ? tr("A simulated device is reset on disconnect.")
                                            : tr("They stay active until power-off.");
    const QString text = what.arg(gains.device) + QLatin1Char(' ') + until;
    const QString remedy =
        tr("They are saved as design '%1'. To use them: Use this design, then Apply and verify.").arg(design);
    m_bench.session().message(MessageLevel::Info, tr("Tune"), text + QLatin1Char(' ') + remedy);
    Q_EMIT left(text, remedy, design);
}

} // namespace halbench::app
