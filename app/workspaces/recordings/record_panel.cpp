#include "app/workspaces/recordings/record_panel.h"

#include "app/workbench/recording_control.h"
#include "app/workbench/recording_trigger.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

/// Up to 1 kHz all divide that of the board; from there on what it has next.
constexpr int Rates_Hz[] = {10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};
constexpr int MomentLines = 2;

/// "312", or "312 (2 gaps, 3.1 s)"
QString missingText(const RecorderStatus& status) {
    // What is dropped behind the last row leaves no gap.
    const QString rows = widgets::countText(std::max(status.missingRows, status.droppedRows));
    return status.gaps == 0
               ? rows
               : RecordPanel::tr("%1 (gaps: %2, %3 s)")
                     .arg(rows, widgets::countText(status.gaps), widgets::fixedText(status.gaps_s, 1));
}

/// What the disk was too slow for is told apart from what the link lost.
QString droppedText(const RecorderStatus& status) {
    return status.droppedRows == 0 ? QString()
                                   : QLatin1Char(' ') + RecordPanel::tr("%1 of them because of a slow disk.")
                                                            .arg(widgets::countText(status.droppedRows));
}

} // namespace

RecordPanel::RecordPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makeScrollingColumn(this);
    m_message = new widgets::MessageBar(this);
    buildTarget(*column);
    buildMoment(*column);
    buildState(*column);
    column->addStretch(1);
    layout()->addWidget(m_message); // at the end, so that nothing moves away from under the mouse
    RecordingControl& recording = m_bench.recording();
    connect(&recording, &RecordingControl::changed, this, &RecordPanel::refresh);
    connect(&recording, &RecordingControl::finished, this, &RecordPanel::onFinished);
    connect(&recording, &RecordingControl::failed, this, [this](const QString& text, const QString& remedy) {
        m_message->showMessage({widgets::Severity::Error, text, remedy, {}});
    });
    connect(&recording, &RecordingControl::rowsDropped, this, [this] {
        m_message->showMessage({widgets::Severity::Error,
                                tr("Disk too slow: samples are lost."),
                                tr("Use another disk or a lower sample rate."),
                                {}});
    });
    connect(&m_bench, &Workbench::deviceChanged, this, &RecordPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &RecordPanel::showMoment);
    connect(&m_bench.recordingTrigger(), &RecordingTrigger::changed, this, &RecordPanel::showMoment);
    refresh();
}

void RecordPanel::buildTarget(QVBoxLayout& column) {
    auto* rows = new QFormLayout;
    m_folder = new QLineEdit(QDir::toNativeSeparators(m_bench.recording().folder()), this);
    m_folder->setAccessibleName(tr("Folder of recordings"));
    m_folder->setToolTip(tr("Created if it does not exist"));
    m_name = new QLineEdit(this);
    m_name->setAccessibleName(tr("Name of the recording"));
    m_rate = new QComboBox(this);
    m_rate->setAccessibleName(tr("Sample rate"));
    m_rate->setToolTip(tr("Live rate: as the plots; limited by device and link"));
    m_rate->addItem(tr("live rate"), 0);
    for (const int rate_Hz : Rates_Hz) {
        m_rate->addItem(tr("%1 Hz").arg(rate_Hz), rate_Hz);
    }
    const int kept = m_rate->findData(static_cast<int>(std::lround(m_bench.recording().rate_Hz())));
    m_rate->setCurrentIndex(std::max(kept, 0));
    m_bench.recording().setRate_Hz(m_rate->currentData().toDouble()); // what is shown is what is recorded
    rows->addRow(tr("Folder"), m_folder);
    rows->addRow(tr("Name"), m_name);
    rows->addRow(tr("Sample rate"), m_rate);
    column.addLayout(rows);
    // At once, so that the window's Record action goes by them too.
    RecordingControl& recording = m_bench.recording();
    connect(&recording, &RecordingControl::nameMaskChanged, this, &RecordPanel::showMask);
    showMask();
    connect(m_folder, &QLineEdit::textChanged, this, [&recording](const QString& folder) {
        recording.setFolder(QDir::fromNativeSeparators(folder.trimmed()));
    });
    connect(m_name, &QLineEdit::textChanged, this,
            [&recording](const QString& name) { recording.setName(name.trimmed()); });
    connect(m_rate, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this, &recording] { recording.setRate_Hz(m_rate->currentData().toDouble()); });
}

void RecordPanel::showMask() {
    const QString& mask = m_bench.recording().nameMask();
    const bool isDefault = mask == QLatin1String(DefaultNameMask);
    m_name->setPlaceholderText(isDefault ? tr("device and date") : mask);
    const QString toolTip = mask.contains(QStringLiteral("{name}"))
                                ? tr("Value of {name} in the name mask %1 (File > Preferences)")
                                : tr("Without file extension; empty: name mask %1 (File > Preferences)");
    m_name->setToolTip(toolTip.arg(mask));
}

/// When the recording begins and ends.
void RecordPanel::buildMoment(QVBoxLayout& column) {
    auto* rows = new QFormLayout;
    m_before = makeNumberField({tr("Pre-trigger time"),
                                tr("Time before the start that is included in the recording; 0: none"),
                                QStringLiteral("s"), 1, 0.0, LongestBefore_s, 1.0},
                               this);
    m_start = new QComboBox(this);
    m_start->addItems({tr("manually"), tr("at the trigger")});
    m_start->setAccessibleName(tr("Start of the recording"));
    m_start->setToolTip(tr(
        "At the trigger: Ctrl+R waits for the Monitor's trigger event (T in the plots shows the trigger)"));
    m_after = makeNumberField({tr("Post-trigger time"),
                               tr("The recording stops this long after the event; 0: manually"),
                               QStringLiteral("s"), 1, 0.0, LongestAfter_s, 1.0},
                              this);
    rows->addRow(tr("Pre-trigger"), m_before);
    rows->addRow(tr("Start"), m_start);
    rows->addRow(tr("Post-trigger"), m_after);
    column.addLayout(rows);
    m_moment = makeNote(this);
    m_moment->setAccessibleName(tr("Trigger event of the recording"));
    reserveLines(*m_moment, MomentLines);
    column.addWidget(m_moment);
    RecordingControl& recording = m_bench.recording();
    showChoice();
    connect(&recording, &RecordingControl::choiceChanged, this, &RecordPanel::showChoice);
    connect(m_before, &widgets::QuantityEdit::edited, this,
            [&recording](double length_s) { recording.setPreTrigger_s(length_s); });
    connect(m_after, &widgets::QuantityEdit::edited, this,
            [&recording](double length_s) { recording.setPostTrigger_s(length_s); });
    connect(m_start, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, &recording](int kind) {
        recording.setAtEvent(kind > 0);
        refresh();
    });
}

/// As a project brought it.
void RecordPanel::showChoice() {
    const RecordingChoice choice = m_bench.recording().choice();
    m_before->setQuantity(choice.before_s);
    m_start->setCurrentIndex(choice.isAtTrigger ? 1 : 0);
    m_after->setQuantity(choice.after_s);
}

/// What is waited for, and how much of the time before is there.
void RecordPanel::showMoment() {
    const RecordingControl& recording = m_bench.recording();
    const RecordingTrigger& trigger = m_bench.recordingTrigger();
    QString words;
    bool isMissing = false;
    if (recording.isWaiting()) {
        isMissing = !trigger.hasSamples();
        words = isMissing ? tr("No samples of the trigger signal.")
                          : tr("Waiting until %1.").arg(trigger.words());
    } else if (recording.isAtEvent() && !recording.isRecording()) {
        words = tr("Begins when %1.").arg(trigger.words());
    }
    const bool isHolding = !recording.isRecording() && m_bench.session().state() == SessionState::Connected;
    if (isHolding && recording.preTrigger_s() > 0.0) {
        const QString held = tr("In memory: %1 of %2 s.")
                                 .arg(widgets::fixedText(recording.held_s(), 1),
                                      widgets::fixedText(recording.preTrigger_s(), 1));
        words += (words.isEmpty() ? QString() : QStringLiteral(" ")) + held;
    }
    if (words != m_moment->text()) {
        m_moment->setText(words);
    }
    showRole(*m_moment, isMissing ? widgets::Role::Warn : widgets::Role::Muted);
}

void RecordPanel::buildState(QVBoxLayout& column) {
    m_record = makeButton({}, this);
    m_record->setIcon(widgets::themedIcon(QStringLiteral("record"), widgets::Role::Bad));
    column.addWidget(m_record);
    auto* state = new QFormLayout;
    const auto addFigure = [&](const QString& title, const QString& toolTip) {
        auto* label = new QLabel(this);
        label->setAlignment(Qt::AlignRight);
        label->setFont(widgets::tabularFont(label->font()));
        label->setAccessibleName(title);
        label->setToolTip(toolTip);
        state->addRow(title, label);
        return label;
    };
    m_elapsed = addFigure(tr("Time"), tr("Device time from the first sample to the last"));
    m_rows = addFigure(tr("Samples written"), tr("On the disk"));
    m_missing = addFigure(tr("Samples lost"), tr("Lost on the link or by a slow disk; marked in the file"));
    column.addLayout(state);
    auto* marker = new QHBoxLayout;
    m_note = new QLineEdit(this);
    m_note->setObjectName(QStringLiteral("markerNote"));
    m_note->setAccessibleName(tr("Note of the marker"));
    m_note->setPlaceholderText(tr("note"));
    m_note->setToolTip(tr("Text of the marker (Enter adds it)"));
    m_mark = makeButton(
        {tr("Add marker"), tr("Add a marker at this time (Enter in the note)"), QStringLiteral("note")},
        this);
    marker->addWidget(m_note, 1);
    marker->addWidget(m_mark);
    column.addLayout(marker);
    connect(m_record, &QPushButton::clicked, this, &RecordPanel::toggle);
    connect(m_mark, &QPushButton::clicked, this, &RecordPanel::addMarker);
    connect(m_note, &QLineEdit::returnPressed, this, &RecordPanel::addMarker);
}

void RecordPanel::toggle() {
    RecordingControl& recording = m_bench.recording();
    if (recording.isRecording() || recording.isWaiting()) {
        recording.stop();
        return;
    }
    m_message->clear();
    recording.start();
}

void RecordPanel::addMarker() {
    if (!m_mark->isEnabled()) {
        return;
    }
    const double now_s = newestTime_s();
    const QString note = m_note->text();
    m_bench.recording().addMarker(now_s, note);
    m_note->clear();
    Q_EMIT marked(now_s, note);
}

/// On the device's clock: of the newest row; before one is there, as old as the last report.
double RecordPanel::newestTime_s() const {
    const double reported_s = m_bench.session().report().deviceTime_s;
    const auto held = m_bench.history().range();
    return held ? std::max(reported_s, held->end_s - m_bench.recordingTrigger().shifts().newest())
                : reported_s;
}

void RecordPanel::refresh() {
    const RecordingControl& recording = m_bench.recording();
    const bool isRecording = recording.isRecording();
    const bool isConnected = m_bench.session().state() == SessionState::Connected;
    const RecorderStatus status = recording.status();
    const bool isWaiting = recording.isWaiting();
    m_record->setEnabled(isRecording || isConnected);
    m_record->setText(isRecording             ? tr("Stop recording")
                      : isWaiting             ? tr("Cancel the wait")
                      : recording.isAtEvent() ? tr("Wait for the trigger")
                                              : tr("Start recording"));
    m_record->setToolTip(isRecording             ? tr("Stop and complete the file (Ctrl+R)")
                         : isWaiting             ? tr("Cancel without recording (Ctrl+R)")
                         : recording.isAtEvent() ? tr("Record from the next trigger event on (Ctrl+R)")
                                                 : tr("Record the measured signals to a file (Ctrl+R)"));
    for (QWidget* target : std::initializer_list<QWidget*>{m_folder, m_name, m_rate, m_before, m_start}) {
        target->setEnabled(!isRecording && !isWaiting);
    }
    m_after->setEnabled(!isRecording && !isWaiting && recording.isAtEvent());
    showMoment();
    m_mark->setEnabled(isRecording && status.rows > 0); // before there is nothing to mark
    m_note->setEnabled(m_mark->isEnabled());
    if (isRecording) {
        m_elapsed->setText(widgets::durationText(status.elapsed_s));
        m_rows->setText(widgets::countText(status.rows));
        m_missing->setText(missingText(status));
        showRole(*m_missing, status.missingRows > 0 ? widgets::Role::Warn : widgets::Role::None);
    } else if (m_elapsed->text().isEmpty()) {
        for (QLabel* figure : {m_elapsed, m_rows, m_missing}) {
            figure->setText(QStringLiteral("\u2013"));
        }
    }
}

void RecordPanel::onFinished(const QString& path, const RecorderStatus& status) {
    const auto rows = static_cast<int>(status.rows);
    const widgets::Severity severity = status.droppedRows > 0 ? widgets::Severity::Error
                                       : status.gaps > 0      ? widgets::Severity::Warning
                                                              : widgets::Severity::Success;
    m_message->showMessage(
        {severity,
         tr("%Ln row(s) in %1", nullptr, rows).arg(QDir::toNativeSeparators(path)),
         status.gaps > 0 || status.droppedRows > 0
             ? tr("Lost: %1; positions in the .meta.json file.").arg(missingText(status)) +
                   droppedText(status)
             : tr("Data file with units; settings and markers are in the .meta.json file beside it."),
         {}});
}

} // namespace halbench::app
