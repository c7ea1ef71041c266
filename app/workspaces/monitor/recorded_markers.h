#pragma once

#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"

#include <QObject>

#include <vector>

namespace halbench::app {

class MonitorTrigger;

/// The markers of the plots in the recording that runs. Each goes into it when it is dropped, so that nothing
/// can lose it; when the recording is complete, its sidecar gets them as they are then: with other notes,
/// without those that were removed (resources/help/monitor.md, "Markers"). While the plots show a capture of
/// the board, those of the live samples count.
class RecordedMarkers : public QObject {
    Q_OBJECT

public:
    RecordedMarkers(Workbench& bench, MonitorTrigger& plots, QObject* parent);

    /// The plots have other ones.
    void refresh();
    /// The recorder got one that was made elsewhere, at a time of the device: the plots have it too from now
    /// on. Without a note it gets a number there.
    void take(double device_s, const QString& note);

Q_SIGNALS:
    void failed(const halbench::Error& error);

private:
    void onChanged();
    void onFinished(const QString& path, const RecorderStatus& status);
    void give();
    void forget();
    double deviceTime_s(double plot_s) const;

    Workbench& m_bench;
    MonitorTrigger& m_plots;
    /// What the recorder has, in the order in which it got it, at times of the device.
    std::vector<devices::RecordingMeta::Marker> m_given;
    std::vector<double> m_plotTimes; ///< of the same in the plots
    bool m_isRunning = false;
    FileQueue m_files;
};

/// The sidecar's markers `kept` with those of the plots instead of what the recorder was given. `given` and
/// `wanted` at times of the device; those that do not lie in the recording, of `length_s`, are left out.
/// Where no marker tells on the device's clock when it began, those that the recorder cut to its first row
/// stay there.
std::vector<devices::RecordingMeta::Marker>
withMarkers(std::vector<devices::RecordingMeta::Marker> kept,
            const std::vector<devices::RecordingMeta::Marker>& given,
            const std::vector<devices::RecordingMeta::Marker>& wanted, double length_s);

} // namespace halbench::app
