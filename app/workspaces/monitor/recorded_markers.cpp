#include "app/workspaces/monitor/recorded_markers.h"

#include "app/recordings/sidecar_change.h"
#include "app/workbench/recording_trigger.h"
#include "app/workspaces/monitor/monitor_trigger.h"
#include "widgets/live_plot/plot_marker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

using Marker = devices::RecordingMeta::Marker;

constexpr double Rounding_s = 1e-9;
/// Rows that were not kept between the last one and a marker at the newest sample.
constexpr double Beyond_s = 0.5;

} // namespace

std::vector<Marker> withMarkers(std::vector<Marker> kept, const std::vector<Marker>& given,
                                const std::vector<Marker>& wanted, double length_s) {
    std::optional<double> first_s; // of the recording, on the clock of the device
    std::vector<Marker> atStart;   // dropped when its first row was on its way
    for (const Marker& marker : given) {
        const auto found = std::find_if(kept.begin(), kept.end(),
                                        [&](const Marker& other) { return other.text == marker.text; });
        if (found != kept.end()) {
            if (found->time_s > 0.0) {
                first_s = marker.time_s - found->time_s;
            } else { // it may be cut to the first row
                atStart.push_back(marker);
            }
            kept.erase(found);
        }
    }
    for (const Marker& marker : wanted) {
        const bool isAtStart = std::any_of(atStart.begin(), atStart.end(), [&](const Marker& other) {
            return other.time_s == marker.time_s;
        });
        const double time_s = first_s ? marker.time_s - *first_s : (isAtStart ? 0.0 : -1.0);
        if (time_s >= -Rounding_s && time_s <= length_s + Beyond_s) {
            kept.push_back({std::max(0.0, time_s), marker.text});
        }
    }
    return kept;
}

RecordedMarkers::RecordedMarkers(Workbench& bench, MonitorTrigger& plots, QObject* parent)
    : QObject(parent), m_bench(bench), m_plots(plots) {
    connect(&m_bench.recording(), &RecordingControl::changed, this, &RecordedMarkers::onChanged);
    connect(&m_bench.recording(), &RecordingControl::finished, this, &RecordedMarkers::onFinished);
}

/// Exactly that of the rows around it, whatever the device's clock did while it was watched.
double RecordedMarkers::deviceTime_s(double plot_s) const {
    return plot_s - m_bench.recordingTrigger().shifts().at(plot_s);
}

void RecordedMarkers::refresh() {
    onChanged(); // its first rows may have come since it was said
    if (m_isRunning) {
        give();
    }
}

void RecordedMarkers::take(double device_s, const QString& note) {
    const double plot_s = device_s + m_bench.recordingTrigger().shifts().newest();
    m_plotTimes.push_back(plot_s); // the recorder has it
    m_given.push_back({device_s, note.toStdString()});
    m_plots.addLiveMarker({plot_s, note.isEmpty() ? widgets::freeMarkerNumber(m_plots.liveMarkers()) : note});
}

/// From its first rows on: what was dropped before, in the time kept before its start, belongs to it too.
void RecordedMarkers::onChanged() {
    const RecordingControl& recording = m_bench.recording();
    if (!recording.isRecording()) {
        forget(); // it failed, or onFinished() has them
    } else if (!m_isRunning && recording.status().rows > 0) {
        m_isRunning = true;
        give();
    }
}

void RecordedMarkers::forget() {
    m_isRunning = false;
    m_given.clear();
    m_plotTimes.clear();
}

void RecordedMarkers::give() {
    for (const widgets::PlotMarker& marker : m_plots.liveMarkers()) {
        if (std::find(m_plotTimes.begin(), m_plotTimes.end(), marker.time_s) != m_plotTimes.end()) {
            continue;
        }
        const QString note = marker.text.isEmpty() ? tr("marker") : marker.text;
        m_plotTimes.push_back(marker.time_s);
        m_given.push_back({deviceTime_s(marker.time_s), note.toStdString()});
        m_bench.recording().addMarker(m_given.back().time_s, note);
    }
}

void RecordedMarkers::onFinished(const QString& path, const RecorderStatus& status) {
    std::vector<Marker> wanted;
    for (const widgets::PlotMarker& marker : m_plots.liveMarkers()) {
        const auto at = std::find(m_plotTimes.begin(), m_plotTimes.end(), marker.time_s);
        if (at != m_plotTimes.end()) {
            const QString note = marker.text.isEmpty() ? tr("marker") : marker.text;
            wanted.push_back(
                {m_given[static_cast<std::size_t>(at - m_plotTimes.begin())].time_s, note.toStdString()});
        }
    }
    const std::vector<Marker> given = m_given;
    forget();
    if (given.empty()) {
        return;
    }
    m_files.run(
        [path, given, wanted = std::move(wanted), length_s = status.elapsed_s]() -> Result<void> {
            const Result<std::vector<Marker>> kept = recordingMarkers(path);
            return kept ? writeRecordingMarkers(path, withMarkers(*kept, given, wanted, length_s))
                        : failure(kept.error());
        },
        [this](const Result<void>& written) {
            if (!written) {
                Q_EMIT failed(written.error());
            }
        });
}

} // namespace halbench::app
