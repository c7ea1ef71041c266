#include "app/window/record_button.h"

#include "app/workbench/recording_control.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int RateDigits = 4;
constexpr double LongTime_s = 3599.0; ///< as wide as a time usually is

/// "100 Hz", "1 kHz"
QString rateText(double rate_Hz) {
    return rate_Hz < 1000.0 ? QStringLiteral("%1 Hz").arg(widgets::numberText(rate_Hz, RateDigits))
                            : QStringLiteral("%1 kHz").arg(widgets::numberText(1e-3 * rate_Hz, RateDigits));
}

} // namespace

RecordButton::RecordButton(Workbench& bench, QWidget* parent) : QToolButton(parent), m_bench(bench) {
    setIcon(widgets::themedIcon(QStringLiteral("record"), widgets::Role::Bad));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setCheckable(true);
    // Not by a click, which its key makes as well: the focus stays in the plot or field that is recorded.
    setFocusPolicy(Qt::TabFocus);
    setFont(widgets::tabularFont(font()));
    RecordingControl& recording = m_bench.recording();
    DeviceSession& session = m_bench.session();
    connect(this, &QToolButton::clicked, this, &RecordButton::toggle);
    connect(&recording, &RecordingControl::changed, this, &RecordButton::refresh);
    connect(&session, &DeviceSession::stateChanged, this, &RecordButton::refresh);
    connect(&session, &DeviceSession::reportChanged, this, &RecordButton::refresh);
    connect(&recording, &RecordingControl::failed, this,
            [&session](const QString& text, const QString& remedy) {
                session.message(MessageLevel::Error, tr("recording"), text + QLatin1Char(' ') + remedy);
            });
    connect(&recording, &RecordingControl::rowsDropped, this, [&session] {
        session.message(MessageLevel::Error, tr("recording"), tr("Disk too slow: samples are lost."));
    });
    connect(&recording, &RecordingControl::finished, this, [&session](const QString& path) {
        session.message(MessageLevel::Info, tr("recording"), tr("written: %1").arg(path));
    });
    refresh();
}

void RecordButton::toggle(bool isWanted) {
    if (isWanted) {
        m_bench.recording().start();
    } else {
        m_bench.recording().stop();
    }
    refresh();
}

void RecordButton::refresh() {
    const RecordingControl& recording = m_bench.recording();
    const bool isRecording = recording.isRecording();
    const bool isWaiting = recording.isWaiting();
    setChecked(isRecording || isWaiting);
    setEnabled(isRecording || m_bench.session().state() == SessionState::Connected);
    const QString time = isRecording ? widgets::durationText(recording.status().elapsed_s) : QString();
    const QString words = isRecording               ? runningWords(time, m_isShort)
                          : isWaiting && !m_isShort ? tr("Waiting")
                                                    : idleWords(m_isShort);
    const QString name = isRecording ? tr("Recording %1").arg(time)
                         : isWaiting ? tr("Waiting for the trigger")
                                     : tr("Record data");
    if (words != text() || name != accessibleName()) {
        setText(words);
        setAccessibleName(name);
        setToolTip(isRecording ? tr("Recording to a file; click to stop (Ctrl+R)")
                   : isWaiting ? tr("Waiting for the trigger; click to cancel (Ctrl+R)")
                               : tr("Record the measured signals to a file (Ctrl+R)"));
        setShortcut(QKeySequence(QStringLiteral("Ctrl+R"))); // a new text forgets it
    }
}

void RecordButton::setShort(bool isShort) {
    m_isShort = isShort;
    refresh();
    updateGeometry();
}

int RecordButton::time_px(bool isShort) const {
    return fontMetrics().horizontalAdvance(runningWords(widgets::durationText(LongTime_s), isShort));
}

/// With the rate, which decides what the file can show.
QString RecordButton::runningWords(const QString& time, bool isShort) const {
    const double rate_Hz = m_bench.recording().usedRate_Hz();
    return isShort || rate_Hz <= 0.0 ? time : time + QLatin1Char(' ') + rateText(rate_Hz);
}

/// The room for the time is there anyway: a short word costs nothing.
QString RecordButton::idleWords(bool isShort) {
    return isShort ? tr("Record") : tr("Record data");
}

int RecordButton::room_px(bool isShort) const {
    return std::max(fontMetrics().horizontalAdvance(idleWords(isShort)), time_px(isShort));
}

int RecordButton::saved_px() const {
    return room_px(false) - room_px(true);
}

QSize RecordButton::sizeHint() const {
    const QSize now = QToolButton::sizeHint();
    return {now.width() + std::max(room_px(m_isShort) - fontMetrics().horizontalAdvance(text()), 0),
            now.height()};
}

void RecordButton::changeEvent(QEvent* event) {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
