#include "app/workspaces/device/configuration_panel.h"

#include "app/documents/result_header.h"
#include "app/documents/text/output_file.h"
#include "app/workbench/wall_clock.h"
#include "app/workspaces/device/configuration_table.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/phrasebook.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace halbench::app {

ConfigurationPanel::ConfigurationPanel(Workbench& bench, QWidget* parent, const std::string& backups)
    : QWidget(parent), m_bench(bench), m_backups(backups) {
    QVBoxLayout* column = makePanelColumn(this);
    m_save = makeButton(
        {tr("Save settings…"), tr("Save all device settings to a file"), QStringLiteral("save")}, this);
    m_open = makeButton({tr("Compare with…"), tr("Compare a file with the device; nothing is written yet"),
                         QStringLiteral("open")},
                        this);
    auto* files = new QHBoxLayout;
    files->addWidget(m_save);
    files->addWidget(m_open);
    files->addStretch(1);
    column->addLayout(files);
    m_messages = new widgets::MessageBar(this);
    m_stack = new QStackedWidget(this);
    m_stack->addWidget(buildEmpty());
    m_stack->addWidget(buildRows());
    column->addWidget(m_stack, 1);
    (new widgets::FloatingRows(*m_stack, Qt::BottomEdge, this))->addRow(*m_messages);
    connect(m_save, &QPushButton::clicked, this, &ConfigurationPanel::save);
    connect(m_open, &QPushButton::clicked, this, &ConfigurationPanel::open);
    connect(&m_bench, &Workbench::valuesChanged, this, [this] { compare(true); });
    connect(&m_bench, &Workbench::deviceChanged, this, [this] {
        ++m_connections;
        compare(false);
    });
    connect(&m_bench, &Workbench::samplesArrived, this, &ConfigurationPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &ConfigurationPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &ConfigurationPanel::refresh);
    refresh();
}

QWidget* ConfigurationPanel::buildEmpty() {
    auto* empty = new widgets::EmptyState(this);
    empty->setIconName(QStringLiteral("open"));
    empty->setWords(tr("No configuration file is open"),
                    tr("A file is compared with the device row by row. Tick rows to restore them. The "
                       "present device settings are saved first."),
                    tr("Compare with a file…"));
    connect(empty, &widgets::EmptyState::actionTriggered, this, &ConfigurationPanel::open);
    return empty;
}

QWidget* ConfigurationPanel::buildRows() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    m_origin = makeNote(page);
    m_findings = new QLabel(page);
    m_findings->setWordWrap(true);
    showRole(*m_findings, widgets::Role::Warn);
    m_table = new ConfigurationTable(page);
    m_differencesOnly = new QCheckBox(tr("Only &differences"), page);
    m_differencesOnly->setChecked(true);
    m_differencesOnly->setToolTip(tr("Hide rows that are equal or missing in the file"));
    m_withCalibration = new QCheckBox(tr("With &calibration"), page);
    m_withCalibration->setToolTip(
        tr("Also tick calibration values; they are valid only for the device they were measured on"));
    m_restore = makeButton({tr("Restore"),
                            tr("Write the ticked rows together and read them back. Lost at power-off unless "
                               "saved to the device"),
                            QStringLiteral("write")},
                           page);
    QLabel* reason = makeNote(page);
    auto* last = new QHBoxLayout;
    last->addWidget(m_withCalibration);
    last->addStretch(1);
    last->addWidget(m_restore);
    column->addWidget(m_origin);
    column->addWidget(m_findings);
    column->addWidget(m_differencesOnly);
    column->addWidget(m_table, 1);
    column->addWidget(reason);
    column->addLayout(last);
    connect(m_table, &ConfigurationTable::reasonChanged, reason, [reason](const QString& words) {
        reason->setText(words);
        reason->setVisible(!words.isEmpty());
    });
    connect(m_differencesOnly, &QCheckBox::toggled, m_table, &ConfigurationTable::setDifferencesOnly);
    connect(m_withCalibration, &QCheckBox::clicked, m_table, &ConfigurationTable::tickCalibration);
    connect(m_table, &ConfigurationTable::ticksChanged, this, &ConfigurationPanel::refresh);
    connect(m_restore, &QPushButton::clicked, this, &ConfigurationPanel::backUpAndRestore);
    return page;
}

void ConfigurationPanel::refresh() {
    const DeviceSession& session = m_bench.session();
    const bool isFree = session.state() == SessionState::Connected && session.procedure().isEmpty() &&
                        !m_bench.deviceValues().empty() && !m_isRestoring;
    const bool isArmed = session.report().board.isArmed;
    m_save->setEnabled(isFree);
    m_stack->setCurrentIndex(m_file ? 1 : 0);
    const std::size_t count = m_comparison ? m_table->ticked().size() : 0;
    m_restore->setText(count == 0 ? tr("Restore")
                                  : tr("Restore %n row(s)", nullptr, static_cast<int>(count)));
    m_restore->setEnabled(isFree && !isArmed && count > 0);
    m_withCalibration->setEnabled(isFree && m_comparison.has_value());
}

void ConfigurationPanel::tell(const Error& error) {
    m_messages->showMessage(
        {widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
}

void ConfigurationPanel::save() {
    const devices::DeviceInfo& info = m_bench.session().info();
    const QString name = datedName(QString::fromStdString(info.id), wallClock()) + QStringLiteral(".toml");
    const Configuration configuration = // as it is now, not after the dialog
        configurationOf(info, m_bench.session().catalogue(), m_bench.deviceValues(), wallTime());
    const QString path = m_chooser.save
                             ? m_chooser.save(this, {tr("Save settings"), name, tr("Configuration (*.toml)")})
                             : QString();
    if (path.isEmpty()) {
        return;
    }
    m_files.run(
        [path = path.toStdString(), configuration] {
            return writeFile(path, configurationText(configuration));
        },
        [this, path, count = static_cast<int>(configuration.values.size())](const Result<void>& written) {
            if (!written) {
                tell(written.error());
                return;
            }
            m_messages->showMessage(
                {widgets::Severity::Success, tr("%n setting(s) saved.", nullptr, count), path, {}});
        });
}

void ConfigurationPanel::open() {
    const QString path = m_chooser.open
                             ? m_chooser.open(this, {tr("Compare with"), {}, tr("Configuration (*.toml)")})
                             : QString();
    if (path.isEmpty()) {
        return;
    }
    m_files.run([path = path.toStdString()] { return readConfiguration(path); },
                [this, path](const Result<Configuration>& file) { opened(path, file); });
}

/// A file that cannot be read leaves the one that is open.
void ConfigurationPanel::opened(const QString& path, const Result<Configuration>& file) {
    if (!file) {
        tell(file.error());
        return;
    }
    m_messages->clear();
    m_file = *file;
    m_origin->setText(tr("%1: device %2, firmware %3, written %4")
                          .arg(QFileInfo(path).fileName(), QString::fromStdString(file->device.id),
                               QString::fromStdString(file->device.firmware),
                               QString::fromStdString(file->written)));
    compare(false);
}

void ConfigurationPanel::compare(bool keepTicks) {
    const DeviceSession& session = m_bench.session();
    m_comparison.reset();
    if (m_file && session.state() == SessionState::Connected && !m_bench.deviceValues().empty()) {
        Result<ConfigurationComparison> comparison =
            compareConfiguration(*m_file, session.info(), session.catalogue(), m_bench.deviceValues());
        if (comparison) {
            m_comparison = *std::move(comparison);
        } else {
            tell(comparison.error());
        }
    }
    QStringList findings;
    for (const Finding& finding : m_comparison ? m_comparison->findings : std::vector<Finding>()) {
        findings << widgets::inWords(finding.message) + QStringLiteral("; ") + widgets::inWords(finding.hint);
    }
    m_table->setAccessibleDescription(findings.join(QLatin1Char(' ')));
    m_findings->setText(findings.join(QLatin1Char('\n')));
    m_findings->setVisible(!findings.isEmpty());
    m_table->show(m_comparison.value_or(ConfigurationComparison()), keepTicks);
    m_withCalibration->setChecked(m_comparison && m_comparison->isSameDevice && !keepTicks
                                      ? true
                                      : keepTicks && m_withCalibration->isChecked());
    refresh();
}

void ConfigurationPanel::backUpAndRestore() {
    const Result<std::vector<ParameterValue>> values = chosenValues(*m_comparison, m_table->ticked());
    if (!values) {
        tell(values.error());
        return;
    }
    const DeviceSession& session = m_bench.session();
    const Configuration before =
        configurationOf(session.info(), session.catalogue(), m_bench.deviceValues(), wallTime());
    m_isRestoring = true;
    refresh();
    m_files.run([before, folder = m_backups] { return backUpConfiguration(before, folder); },
                [this, values = *values, id = session.info().id, stops = session.stops(),
                 connection = m_connections](const Result<std::string>& path) {
                    if (!path) {
                        m_isRestoring = false;
                        tell(path.error());
                        refresh();
                        return;
                    }
                    if (m_bench.session().info().id != id || m_connections != connection) {
                        m_isRestoring = false;
                        tell({ErrorCode::DeviceLost, "the device changed before writing started",
                              "check the rows again, then restore"});
                        refresh();
                        return;
                    }
                    restore(values, QString::fromStdString(*path), stops);
                });
}

/// A stop while the copy was written means that nothing is written to the device.
void ConfigurationPanel::restore(const std::vector<ParameterValue>& values, const QString& backup,
                                 std::uint64_t stops) {
    m_bench.session().requestUnlessStoppedSince(
        stops, [values](devices::Device& device) { return restoreValues(device, values); },
        [self = QPointer(this), backup](const Result<std::vector<RowOutcome>>& outcomes) {
            if (self) {
                self->restored(outcomes, backup);
            }
        });
}

void ConfigurationPanel::restored(const Result<std::vector<RowOutcome>>& outcomes, const QString& backup) {
    m_isRestoring = false;
    m_bench.confirmValues();
    refresh();
    if (!outcomes) {
        tell(outcomes.error());
        return;
    }
    m_table->showOutcomes(*outcomes);
    const auto refused = std::count_if(outcomes->begin(), outcomes->end(),
                                       [](const RowOutcome& row) { return !row.isRestored; });
    const auto count = static_cast<int>(outcomes->size()) - static_cast<int>(refused);
    const QString kept = tr("Previous device settings saved in %1.").arg(backup);
    const QString until = tr("Lost at power-off. To keep: Parameters > Save to device.");
    const QString done = tr("%n row(s) restored and read back.", nullptr, count);
    m_bench.session().message(MessageLevel::Info, tr("configuration"), done);
    if (refused > 0) {
        const QString undone =
            tr("%n row(s) not restored; see the rows for the cause.", nullptr, static_cast<int>(refused));
        m_bench.session().message(MessageLevel::Warning, tr("configuration"), undone);
        m_messages->showMessage({widgets::Severity::Error, undone, kept, {}});
        return;
    }
    m_messages->showMessage({widgets::Severity::Success, done, until + QLatin1Char('\n') + kept, {}});
}

} // namespace halbench::app
