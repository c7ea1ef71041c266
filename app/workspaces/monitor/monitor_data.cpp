#include "app/workspaces/monitor/monitor_data.h"

#include "app/documents/result_header.h"
#include "app/workspaces/monitor/plot_rows.h"
#include "devices/formats/convert_recording.h"
#include "devices/recording/recording_csv.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::size_t MostCopiedValues = 500000; ///< some megabytes of text

QAction* makeAction(QWidget& panel, const QString& text, const QString& what, const char* icon,
                    const char* shortcut) {
    auto* action = new QAction(widgets::themedIcon(QLatin1String(icon)), text, &panel);
    action->setShortcut(QKeySequence(QLatin1String(shortcut)));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(what, action->shortcut().toString(QKeySequence::NativeText)));
    panel.addAction(action);
    return action;
}

} // namespace

MonitorData::MonitorData(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_panel(panel) {
    m_copy =
        makeAction(panel, tr("Copy data"), tr("Copy the samples in view or between the cursors as a table"),
                   "copy", "Ctrl+Alt+C");
    m_save = makeAction(panel, tr("Save data…"),
                        tr("Save the samples in view or between the cursors (CSV, MDF4, MAT)"), "export",
                        "Ctrl+Alt+E");
    connect(m_copy, &QAction::triggered, this, &MonitorData::copy);
    connect(m_save, &QAction::triggered, this, &MonitorData::save);
}

Result<Recording> MonitorData::rows(std::size_t mostValues) const {
    const TakenPlots taken = takenPlots(m_stack);
    return plotRows(taken.plots, *m_stack.history(), taken.range, mostValues);
}

/// Of plots on other time axes; empty: none.
QString MonitorData::leftOut() const {
    const QStringList names = takenPlots(m_stack).leftOut;
    return names.isEmpty() ? QString()
                           : tr("; not included (other time axis): %1").arg(names.join(QStringLiteral(", ")));
}

/// When the time axis was at zero, ISO 8601; empty where nobody knows: simulated time passes at any speed,
/// and a capture, a replay or a device that is gone has no present moment.
std::string MonitorData::timeOfZero() const {
    const DeviceSession& session = m_bench.session();
    const bool isLive = m_stack.history() == &m_bench.history();
    if (!isLive || session.state() != SessionState::Connected || session.info().isSimulated ||
        session.info().transport == "replay") {
        return {};
    }
    const auto ago_ms = static_cast<qint64>(std::llround(1e3 * session.report().deviceTime_s));
    return m_bench.now().addMSecs(-ago_ms).toString(Qt::ISODate).toStdString();
}

/// Values of parameters are not told: what they were when the samples came is not known here.
devices::RecordingMeta MonitorData::meta(const Recording& rows) const {
    const ResultHeader header = m_bench.beginResult("halbench.recording-meta/1");
    devices::RecordingMeta meta;
    meta.device = m_bench.session().info();
    meta.started = timeOfZero();
    meta.software = header.software;
    meta.period_s = rows.layout->period_s;
    for (const StreamLayout::Column& column : rows.layout->columns) {
        const SignalSpec* spec = m_bench.catalogue().findSignal(column.name);
        const auto& derived = m_bench.derivedSignals();
        const auto own = std::find_if(derived.begin(), derived.end(),
                                      [&](const auto& one) { return one.name == column.name; });
        meta.signals.push_back({column.name, devices::csvColumnName(column.name, column.unit), column.unit,
                                spec != nullptr ? spec->role : std::string(),
                                own != derived.end() ? own->expression : std::string()});
    }
    const double begin_s = rows.time_s.front();
    const double end_s = rows.time_s.back();
    for (const widgets::PlotMarker& marker : m_stack.markers()) {
        if (marker.time_s >= begin_s && marker.time_s <= end_s) {
            meta.markers.push_back({marker.time_s, marker.text.toStdString()});
        }
    }
    if (const auto event_s = m_stack.event_s(); event_s && *event_s >= begin_s && *event_s <= end_s) {
        meta.markers.push_back({*event_s, "trigger"});
    }
    return meta;
}

void MonitorData::refuse(const Error& error) {
    Q_EMIT failed(widgets::inWords(error.message), widgets::inWords(error.hint));
}

void MonitorData::copy() {
    const Result<Recording> taken = rows(MostCopiedValues);
    if (!taken) {
        refuse(taken.error());
        return;
    }
    QGuiApplication::clipboard()->setText(plotTable(*taken, m_stack.plots()));
    Q_EMIT done(tr("Copied: %1 rows").arg(widgets::countText(taken->rows())) + leftOut());
}

void MonitorData::save() {
    const Result<Recording> taken = rows(MostPlotValues); // as it is now, not after the dialog
    const QString others = leftOut();
    if (!taken) {
        refuse(taken.error());
        return;
    }
    const QString path = m_chooser.save ? m_chooser.save(&m_panel, {tr("Save data"), tr("plots.csv"),
                                                                    tr("Recording (*.csv *.mf4 *.mat)")})
                                        : QString();
    if (path.isEmpty()) {
        return;
    }
    m_files.run([file = path.toStdString(), rows = *taken,
                 meta = meta(*taken)] { return devices::exportRecording(file, rows, meta); },
                [this, path, count = taken->rows(), others](const Result<void>& written) {
                    if (written) {
                        Q_EMIT done(tr("Saved: %1 rows in %2").arg(widgets::countText(count), path) + others);
                    } else {
                        refuse(written.error());
                    }
                });
}

} // namespace halbench::app
