#include "app/window/preferences/preferences_dialog.h"

#include "app/window/preferences/language.h"
#include "app/window/preferences/recording_fields.h"
#include "widgets/controls/stop_button.h"
#include "widgets/language/display_units.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace halbench::app {
namespace {

constexpr int LockOutStep_ms = 100;

template <typename Choice>
void addItem(QComboBox& box, const QString& text, Choice choice) {
    box.addItem(text, static_cast<int>(choice));
}

template <typename Choice>
void select(QComboBox& box, Choice choice) {
    box.setCurrentIndex(box.findData(static_cast<int>(choice)));
}

template <typename Choice>
Choice selected(const QComboBox& box) {
    return static_cast<Choice>(box.currentData().toInt());
}

} // namespace

PreferencesDialog::PreferencesDialog(const Preferences& preferences, Workbench& bench,
                                     std::uint64_t history_bytes, QWidget* parent)
    : QDialog(parent), m_before(preferences) {
    setWindowTitle(tr("Preferences"));
    auto* form = new QFormLayout(this);
    addLook(*form);
    addUnits(*form);
    addLockOut(*form);
    addHistory(*form, history_bytes);
    m_recordings = new RecordingFields(*form, preferences, bench, this);
    addButtons(*form, bench);
}

QComboBox* PreferencesDialog::addChoice(QFormLayout& form, const QString& label, const QString& toolTip) {
    auto* box = new QComboBox(this);
    box->setToolTip(toolTip);
    box->setAccessibleName(QString(label).remove(QLatin1Char('&')));
    form.addRow(label, box);
    return box;
}

void PreferencesDialog::addLook(QFormLayout& form) {
    m_theme = addChoice(form, tr("&Theme"), tr("Colours of the window"));
    addItem(*m_theme, tr("same as system"), ThemeChoice::System);
    addItem(*m_theme, tr("light"), ThemeChoice::Light);
    addItem(*m_theme, tr("dark"), ThemeChoice::Dark);
    select(*m_theme, m_before.theme);
    m_language = addChoice(form, tr("&Language"), tr("Language of the window; files are not affected"));
    m_language->addItem(tr("same as system"), QString());
    for (const Language& language : languages()) {
        m_language->addItem(language.name, language.id);
    }
    m_language->setCurrentIndex(std::max(m_language->findData(m_before.language), 0));
}

void PreferencesDialog::addUnits(QFormLayout& form) {
    m_angle = addChoice(form, tr("&Angles in"), tr("Unit of displayed angles; files always use SI units"));
    addItem(*m_angle, tr("degrees"), widgets::AngleUnit::Degree);
    addItem(*m_angle, tr("radians"), widgets::AngleUnit::Radian);
    select(*m_angle, m_before.units.angle);
    m_speed = addChoice(form, tr("&Speeds in"), tr("Unit of displayed speeds; files always use SI units"));
    addItem(*m_speed, tr("revolutions per minute"), SpeedUnit::TurnsPerMinute);
    addItem(*m_speed, tr("degrees per second"), SpeedUnit::DegreesPerSecond);
    addItem(*m_speed, tr("radians per second"), SpeedUnit::RadiansPerSecond);
    select(*m_speed, m_before.units.speed);
    m_frequency = addChoice(form, tr("&Frequencies in"), tr("Unit of the frequency axes; files use Hz"));
    addItem(*m_frequency, tr("hertz"), FrequencyUnit::Hertz);
    addItem(*m_frequency, tr("radians per second"), FrequencyUnit::RadiansPerSecond);
    select(*m_frequency, m_before.units.frequency);
}

void PreferencesDialog::addLockOut(QFormLayout& form) {
    m_lockOut_ms = new QSpinBox(this);
    m_lockOut_ms->setRange(0, LongestLockOut_ms);
    m_lockOut_ms->setSingleStep(LockOutStep_ms);
    m_lockOut_ms->setSuffix(tr(" ms"));
    m_lockOut_ms->setValue(m_before.stopLockOut_ms);
    m_lockOut_ms->setAccessibleName(tr("Release delay after stop"));
    m_lockOut_ms->setToolTip(tr("Minimum time between a stop and its release"));
    form.addRow(tr("Release dela&y after stop"), m_lockOut_ms);
}

void PreferencesDialog::addHistory(QFormLayout& form, std::uint64_t history_bytes) {
    m_history_GB = new QSpinBox(this);
    m_history_GB->setRange(LeastHistory_GB, MostHistory_GB);
    m_history_GB->setSuffix(tr(" GB"));
    m_history_GB->setValue(m_before.historyLimit_GB);
    m_history_GB->setAccessibleName(tr("Maximum history on disk"));
    m_history_GB->setToolTip(tr("Disk space for samples that do not fit into memory; the oldest are dropped "
                                "first. 4 GB always stay free. Recordings are not affected"));
    const double used_GB = static_cast<double>(history_bytes) / static_cast<double>(BytesPerGB);
    auto* used = new QLabel(tr("used: %1 GB").arg(widgets::fixedText(used_GB, 1)), this);
    used->setAccessibleName(tr("Present history on disk"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_history_GB);
    row->addWidget(used);
    row->addStretch(1);
    auto* label = new QLabel(tr("&History on the disk"), this);
    label->setBuddy(m_history_GB);
    form.addRow(label, row);
}

void PreferencesDialog::addButtons(QFormLayout& form, Workbench& bench) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Apply the settings (Enter)"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Discard the changes (Esc, which also stops)"));
    QPushButton* use = buttons->button(QDialogButtonBox::Ok);
    use->setEnabled(m_recordings->isReady());
    connect(m_recordings, &RecordingFields::changed, use,
            [this, use] { use->setEnabled(m_recordings->isReady()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, this);
    connect(stop, &widgets::StopButton::stopRequested, &bench, [&bench] { bench.session().stopActuator(); });
    auto* row = new QHBoxLayout;
    row->addWidget(stop);
    row->addStretch(1);
    row->addWidget(buttons);
    form.addRow(row);
}

Preferences PreferencesDialog::chosen() const {
    Preferences preferences = m_before;
    preferences.theme = selected<ThemeChoice>(*m_theme);
    preferences.language = m_language->currentData().toString();
    preferences.units = {selected<widgets::AngleUnit>(*m_angle), selected<SpeedUnit>(*m_speed),
                         selected<FrequencyUnit>(*m_frequency)};
    preferences.stopLockOut_ms = m_lockOut_ms->value();
    preferences.historyLimit_GB = m_history_GB->value();
    preferences.recordingNames = m_recordings->nameMask();
    preferences.retention = m_recordings->limits();
    return preferences;
}

} // namespace halbench::app
