#include "app/workspaces/device/log_panel.h"

#include "app/documents/configuration_file.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/drive_text.h"
#include "app/workbench/fault_text.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/log/log_view.h"

#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

widgets::LogLevel levelOf(MessageLevel level) {
    switch (level) {
    case MessageLevel::Debug:
        return widgets::LogLevel::Debug;
    case MessageLevel::Warning:
        return widgets::LogLevel::Warning;
    case MessageLevel::Error:
        return widgets::LogLevel::Error;
    case MessageLevel::Info:
        break;
    }
    return widgets::LogLevel::Information;
}

QString doneText(std::optional<Verdict> verdict) {
    if (!verdict) {
        return LogPanel::tr("done");
    }
    switch (*verdict) {
    case Verdict::Good:
        return LogPanel::tr("done, good");
    case Verdict::Doubtful:
        return LogPanel::tr("done, doubtful");
    case Verdict::Refused:
        break;
    }
    return LogPanel::tr("done, rejected");
}

constexpr int AllDigits = 9; ///< of a 32 bit float

/// In the unit of the Parameters panel: "gain.kp 10 → 12 A/rad".
QString changeText(const ParameterSpec& spec, double before, double now, const DisplayUnits& units) {
    const widgets::DisplayUnit shown = widgets::displayUnit(spec.unit, units.angle);
    QString from = widgets::settingText(before * shown.factor);
    QString to = widgets::settingText(now * shown.factor);
    if (from == to) {
        from = widgets::numberText(before * shown.factor, AllDigits);
        to = widgets::numberText(now * shown.factor, AllDigits);
    }
    return QStringLiteral("%1 %2 \u2192 %3 %4")
        .arg(QString::fromStdString(spec.name), from, to, shown.text)
        .trimmed();
}

} // namespace

LogPanel::LogPanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_view(new widgets::LogView(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    DeviceSession& session = m_bench.session();
    connect(&session, &DeviceSession::message, this, &LogPanel::add);
    connect(&session, &DeviceSession::reportChanged, this, &LogPanel::onReport);
    connect(&session, &DeviceSession::stateChanged, this, &LogPanel::onReport);
    connect(&session, &DeviceSession::procedureChanged, this, &LogPanel::onProcedure);
    connect(&m_bench.drive(), &DriveControl::changed, this, &LogPanel::onDrive);
    connect(&m_bench, &Workbench::deviceChanged, this, &LogPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &LogPanel::onValues);
    connect(&m_bench, &Workbench::historyTroubled, this, [this](const Error& error) {
        add(MessageLevel::Warning, tr("history"), widgets::inWords(error.message));
    });
    connect(&m_bench.recording(), &RecordingControl::changed, this, &LogPanel::onRecording);
}

void LogPanel::note(const QString& source, const QString& words) {
    add(MessageLevel::Info, source, words);
}

/// Stop and release before arming and its end: what caused it stands first.
void LogPanel::onReport() {
    const DeviceSession& session = m_bench.session();
    const devices::DeviceState& board = session.report().board;
    const bool isThere = session.state() == SessionState::Connected;
    const bool isLatched = isThere && (board.isStopLatched || board.fault != 0);
    if (std::exchange(m_wasLatched, isLatched) != isLatched && isThere) {
        if (isLatched) {
            add(MessageLevel::Warning, tr("stop"), faultWords(board, m_bench.stopAsker()).what);
        } else {
            note(tr("stop"), tr("released"));
        }
    }
    const bool isArmed = isThere && board.isArmed;
    if (std::exchange(m_wasArmed, isArmed) != isArmed && isThere) {
        note(tr("actuator"), isArmed ? tr("armed") : tr("disarmed"));
    }
}

void LogPanel::onProcedure() {
    const QString running = m_bench.session().procedure();
    const QString before = std::exchange(m_procedure, running);
    if (!before.isEmpty()) {
        addEnd(before);
    }
    if (!running.isEmpty()) {
        note(running, tr("started"));
    }
}

void LogPanel::addEnd(const QString& procedure) {
    const ProcedureOutcome& outcome = m_bench.session().outcome();
    if (outcome.error && outcome.error->code != ErrorCode::Interrupted) {
        add(MessageLevel::Warning, procedure, tr("failed: %1").arg(widgets::inWords(outcome.error->message)));
    } else {
        note(procedure, outcome.error ? tr("cancelled") : doneText(outcome.verdict));
    }
}

/// A motion by hand: a reference, or a jog. What ended it stands before its end.
void LogPanel::onDrive() {
    onReport();
    const QString running = drivenWords(m_bench.drive());
    if (running.isEmpty() == m_motion.isEmpty()) {
        return; // the same motion, or none
    }
    const QString before = std::exchange(m_motion, running);
    if (!running.isEmpty()) {
        note(running, tr("started"));
    } else if (m_wasLatched) {
        note(before,
             tr("ended: %1").arg(faultWords(m_bench.session().report().board, m_bench.stopAsker()).what));
    } else {
        note(before, m_wasArmed ? tr("ended") : tr("ended: %1").arg(tr("disarmed")));
    }
}

void LogPanel::onRecording() {
    const bool isRecording = m_bench.recording().isRecording();
    if (std::exchange(m_wasRecording, isRecording) != isRecording) {
        note(tr("recording"),
             isRecording ? tr("started: %1").arg(m_bench.recording().path()) : tr("stopped"));
    }
}

/// Of another device nothing is known yet.
void LogPanel::onDevice() {
    if (m_bench.deviceValues().empty()) {
        m_values.clear();
    }
}

/// Whoever wrote it, a panel, a procedure or another tool: what was read back tells. One line a setting.
void LogPanel::onValues() {
    for (const ParameterSpec& spec : m_bench.session().catalogue().parameters) {
        const auto before = m_values.find(spec.name);
        const std::optional<double> now = m_bench.deviceValue(spec.name);
        if (!isSetting(spec) || before == m_values.end() || !now || *now == before->second) {
            continue;
        }
        const QString words = changeText(spec, before->second, *now, m_bench.displayUnits());
        note(tr("parameters"), m_bench.areValuesOurs() ? words : tr("found changed: %1").arg(words));
    }
    m_values = m_bench.deviceValues();
}

QString LogPanel::text() const {
    return m_view->text();
}

void LogPanel::add(MessageLevel level, const QString& source, const QString& words) {
    const QString text = widgets::inWords(words);
    m_view->append({{m_bench.session().report().deviceTime_s, levelOf(level), source, text, m_bench.now()}});
    Q_EMIT said(level, source + QStringLiteral(": ") + text);
}

} // namespace halbench::app
