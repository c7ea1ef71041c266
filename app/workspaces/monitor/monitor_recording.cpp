#include "app/workspaces/monitor/monitor_recording.h"

#include "app/recordings/sidecar_change.h"
#include "app/workbench/shown_recording.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace halbench::app {

MonitorRecording::MonitorRecording(Workbench& bench, widgets::LivePlotStack& stack,
                                   widgets::MessageBar& message, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_message(message),
      m_row(new widgets::ProgressRow(&panel)) {
    m_row->hide();
    ShownRecording& shown = m_bench.shownRecording();
    connect(m_row, &widgets::ProgressRow::cancelRequested, &shown, &ShownRecording::cancel);
    connect(&shown, &ShownRecording::changed, this, &MonitorRecording::refresh);
    connect(&shown, &ShownRecording::began, this, &MonitorRecording::onBegan);
    connect(&shown, &ShownRecording::ended, this, &MonitorRecording::onEnded);
}

QWidget& MonitorRecording::row() {
    return *m_row;
}

void MonitorRecording::refresh() {
    const ShownRecording& shown = m_bench.shownRecording();
    m_row->setVisible(shown.isBusy());
    m_stack.setLive(shown.file() == nullptr || shown.isBusy());
    if (!shown.isBusy()) {
        return;
    }
    const QString name = QFileInfo(shown.path()).fileName();
    m_isAsked = m_isAsked || shown.isReading();
    m_row->setText(shown.isReading() ? tr("Reading %1").arg(name) : tr("Showing %1").arg(name));
    const bool isKnown = shown.fraction() > 0.0; // of an MDF4 file it is not
    m_row->setProgress(isKnown ? std::optional(shown.fraction()) : std::nullopt);
}

void MonitorRecording::showMarkers() {
    const ShownRecording& shown = m_bench.shownRecording();
    const double first_s = shown.file()->recording.time_s.front();
    m_keptPath.clear(); // these are no news to it
    std::vector<widgets::PlotMarker> markers;
    for (const devices::RecordingMeta::Marker& marker : shown.file()->meta.markers) {
        markers.push_back({marker.time_s - first_s, QString::fromStdString(marker.text)});
    }
    m_stack.setMarkers(std::move(markers));
    m_kept = shown.file()->meta.markers;
    m_keptPath = shown.path();
}

/// Those that were not moved keep their time to the last bit.
void MonitorRecording::keepMarkers() {
    const ShownRecording& shown = m_bench.shownRecording();
    if (shown.file() == nullptr || m_keptPath.isEmpty() || m_keptPath != shown.path()) {
        return;
    }
    const double first_s = shown.file()->recording.time_s.front();
    std::vector<devices::RecordingMeta::Marker> markers;
    for (const widgets::PlotMarker& marker : m_stack.markers()) {
        const auto same = std::find_if(m_kept.begin(), m_kept.end(), [&](const auto& kept) {
            return kept.time_s - first_s == marker.time_s;
        });
        markers.push_back(
            {same != m_kept.end() ? same->time_s : marker.time_s + first_s, marker.text.toStdString()});
    }
    m_kept = markers;
    m_files.run([path = m_keptPath, markers] { return writeRecordingMarkers(path, markers); },
                [this](const Result<void>& written) {
                    if (!written) {
                        m_message.showMessage(
                            {widgets::Severity::Warning,
                             tr("Markers not saved: %1").arg(widgets::inWords(written.error().message)),
                             widgets::inWords(written.error().hint),
                             {}});
                    }
                });
}

/// The plots fill from the left.
void MonitorRecording::onBegan() {
    const ShownRecording& shown = m_bench.shownRecording();
    if (!m_isAsked) {
        return;
    }
    showMarkers();
    m_stack.setPaused(false);
    m_stack.setFollowing(true);
    m_stack.setTimeSpan(shown.length_s());
}

void MonitorRecording::onEnded() {
    const ShownRecording& shown = m_bench.shownRecording();
    m_stack.setLive(shown.file() == nullptr);
    if (!std::exchange(m_isAsked, false)) {
        return;
    }
    m_stack.showTimeRange({0.0, shown.shown_s()});
    m_stack.rescale(true);
    if (shown.shown_s() < shown.length_s()) {
        m_message.showMessage(
            {widgets::Severity::Information,
             tr("Cancelled: the plots show the first %1 s of %2 s.")
                 .arg(widgets::fixedText(shown.shown_s(), 2), widgets::fixedText(shown.length_s(), 2)),
             {},
             {}});
    }
}

} // namespace halbench::app
