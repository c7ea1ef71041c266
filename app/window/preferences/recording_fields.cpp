#include "app/window/preferences/recording_fields.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/number_text.h"
#include "widgets/language/phrasebook.h"

#include <QCheckBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int UsualDays = 90;
constexpr int UsualSize_GB = 50;
constexpr int NamedInPlan = 20;

QString sizeText(std::uint64_t bytes) {
    constexpr double BytesPerMB = 1e6;
    return RecordingFields::tr("%1 MB").arg(widgets::fixedText(static_cast<double>(bytes) / BytesPerMB, 1));
}

QString namesIn(const RetentionPlan& plan) {
    QStringList names;
    for (const RetentionPlan::Removal& removal : plan.removals) {
        names.append(removal.recording.name);
    }
    const int left = names.size() - NamedInPlan;
    names = names.mid(0, NamedInPlan);
    if (left > 0) {
        names.append(RecordingFields::tr("and %n more", nullptr, left));
    }
    return names.join(QLatin1Char('\n'));
}

} // namespace

RecordingFields::RecordingFields(QFormLayout& form, const Preferences& preferences, Workbench& bench,
                                 QWidget* dialog)
    : QObject(dialog), m_bench(bench), m_dialog(dialog), m_before(preferences.retention) {
    addNames(form, preferences.recordingNames);
    addKeeping(form);
    showNames();
    showPlan();
}

void RecordingFields::addNames(QFormLayout& form, const QString& mask) {
    m_mask = new QLineEdit(mask, m_dialog);
    m_mask->setAccessibleName(tr("Names of recordings"));
    m_mask->setToolTip(tr("Names of unnamed recordings: {device}, {date} and {time} (UTC), {number}; {name} "
                          "is set in the Record panel"));
    m_example = makeNote(m_dialog);
    m_example->setAccessibleName(tr("Example of a recording's name"));
    reserveLines(*m_example, 2);
    form.addRow(tr("&Names of recordings"), m_mask);
    form.addRow(QString(), m_example);
    connect(m_mask, &QLineEdit::textChanged, this, &RecordingFields::showNames);
}

RecordingFields::Limit RecordingFields::addLimit(const QString& words, const QString& unit, int most,
                                                 int usual) {
    Limit limit{new QCheckBox(words, m_dialog), new QSpinBox(m_dialog)};
    limit.count->setRange(1, most);
    limit.count->setSuffix(unit);
    limit.count->setValue(usual);
    limit.count->setEnabled(false);
    connect(limit.isOn, &QCheckBox::toggled, limit.count, &QSpinBox::setEnabled);
    connect(limit.isOn, &QCheckBox::toggled, this, &RecordingFields::showPlan);
    connect(limit.count, QOverload<int>::of(&QSpinBox::valueChanged), this, &RecordingFields::showPlan);
    return limit;
}

void RecordingFields::setLimit(Limit& limit, const std::optional<int>& count) {
    if (count) {
        limit.count->setValue(*count);
        limit.isOn->setChecked(true);
    }
}

void RecordingFields::addKeeping(QFormLayout& form) {
    const QString which = tr("The oldest recordings named by the program move to the trash. Recordings that "
                             "are open, younger than a day or have tags, notes or results are kept");
    m_days = addLimit(tr("&older than"), tr(" days"), MostRetentionDays, UsualDays);
    m_size = addLimit(tr("a&bove"), tr(" GB"), MostKept_GB, UsualSize_GB);
    m_days.isOn->setAccessibleName(tr("Delete recordings by age"));
    m_days.count->setAccessibleName(tr("Age at which recordings are deleted, in days"));
    m_size.isOn->setAccessibleName(tr("Delete recordings by disk space"));
    m_size.count->setAccessibleName(tr("Disk space above which recordings are deleted"));
    auto* row = new QHBoxLayout;
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_days.isOn, m_days.count, m_size.isOn, m_size.count}) {
        part->setToolTip(which);
        row->addWidget(part);
    }
    row->addStretch(1);
    m_plan = makeNote(m_dialog);
    m_plan->setAccessibleName(tr("Recordings to be deleted now"));
    reserveLines(*m_plan, 2);
    form.addRow(tr("Delete old recordings"), row);
    form.addRow(QString(), m_plan);
    setLimit(m_days, m_before.days);
    const auto size_GB = m_before.size_bytes
                             ? std::optional(static_cast<int>(*m_before.size_bytes / RetentionGB_bytes))
                             : std::nullopt;
    setLimit(m_size, size_GB);
}

QString RecordingFields::nameMask() const {
    return m_mask->text().trimmed();
}

RetentionLimits RecordingFields::limits() const {
    RetentionLimits limits;
    if (m_days.isOn->isChecked()) {
        limits.days = m_days.count->value();
    }
    if (m_size.isOn->isChecked()) {
        limits.size_bytes = static_cast<std::uint64_t>(m_size.count->value()) * RetentionGB_bytes;
    }
    return limits;
}

bool RecordingFields::isReady() const {
    return checkNameMask(nameMask()).has_value() && !m_planning.isBusy();
}

void RecordingFields::showNames() {
    const Result<void> checked = checkNameMask(nameMask());
    if (checked) {
        const QString device = m_bench.session().state() == SessionState::Connected
                                   ? recordedDevice(m_bench.session().info())
                                   : QStringLiteral("HB-17");
        const Result<QString> name =
            recordingName(nameMask(), {device, tr("name"), m_bench.now()}, m_bench.recording().folder());
        m_example->setText(name ? tr("e.g. %1.csv").arg(*name) : widgets::inWords(name.error().message));
    } else {
        m_example->setText(widgets::inWords(checked.error().message) + QLatin1String(": ") +
                           widgets::inWords(checked.error().hint));
    }
    showRole(*m_example, checked ? widgets::Role::Muted : widgets::Role::Bad);
    Q_EMIT changed();
}

/// Before it is switched on it is said what goes.
void RecordingFields::showPlan() {
    const RetentionLimits wanted = limits();
    if (!wanted.isOn()) {
        m_planning.cancel();
        m_plan->setText(tr("Currently never."));
        m_plan->setToolTip({});
        showRole(*m_plan, widgets::Role::Muted);
        Q_EMIT changed();
        return;
    }
    m_plan->setText(tr("Checking recordings…"));
    m_planning.run([folder = m_bench.recording().folder(), wanted,
                    now = m_bench.now()] { return planRetention(folder, wanted, now); },
                   [this](const RetentionPlan& plan) { say(plan); });
    Q_EMIT changed();
}

void RecordingFields::say(const RetentionPlan& plan) {
    const QString folder = QDir::toNativeSeparators(m_bench.recording().folder());
    const auto count = static_cast<int>(plan.removals.size());
    if (!plan.fromFuture.isEmpty()) {
        m_plan->setText(tr("Nothing is deleted from %1: %2 has a date in the future. Check the clock.")
                            .arg(folder, plan.fromFuture));
    } else if (count == 0) {
        m_plan->setText(tr("OK deletes nothing from %1 now.").arg(folder));
    } else {
        m_plan->setText(tr("OK moves %n recording(s) to the trash now (%1), from %2.", nullptr, count)
                            .arg(sizeText(plan.before_bytes - plan.after_bytes), folder));
    }
    m_plan->setToolTip(namesIn(plan));
    showRole(*m_plan, count == 0 && plan.fromFuture.isEmpty() ? widgets::Role::Muted : widgets::Role::Warn);
    Q_EMIT changed();
}

} // namespace halbench::app
