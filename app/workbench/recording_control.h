#pragma once

#include "app/recordings/recording_name.h"
#include "app/session/device_session.h"
#include "app/session/recorder.h"
#include "app/session/recording_feed.h"
#include "app/workbench/live_signals.h"
#include "app/workbench/recording_choice.h"
#include "app/workbench/wall_clock.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// One recording at a time, shared by the panel and the window's Record action: the profile's default signals
/// and whatever is watched when it starts, to a CSV file (resources/help/monitor.md, "Recording").
/// Thread: GUI; the file is written elsewhere.
class RecordingControl : public QObject {
    Q_OBJECT

public:
    RecordingControl(DeviceSession& session, LiveSignals& liveSignals, QObject* parent = nullptr);
    /// Completes the file.
    ~RecordingControl() override;

    /// Where and how densely the next recording goes. Rate 0: as densely as the plots. More than
    /// the stream usually has makes it faster while it is recorded, as far as board and link carry it
    /// (LiveSignals::wantRate()); beyond that start() refuses.
    void setFolder(const QString& folder);
    const QString& folder() const { return m_folder; }
    /// Recordings of the folder came or went otherwise.
    void noteFilesChanged() { Q_EMIT folderChanged(); }
    void setRate_Hz(double rate_Hz);
    double rate_Hz() const { return m_rate_Hz; }
    /// The chosen one, else that of the plots.
    double usedRate_Hz() const;
    /// What the mask's {name} is; a mask without it: the whole name. Empty: the program names the recording
    /// by the mask. Without folder and ending.
    void setName(const QString& name) { m_name = name; }
    /// As checkNameMask() accepts.
    void setNameMask(const QString& mask);
    const QString& nameMask() const { return m_nameMask; }
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }
    void setDisk(devices::DiskAccess disk) { m_disk = std::move(disk); }
    /// What may wait for the disk.
    void setQueueRows(std::size_t rows) { m_queue_rows = rows; }

    /// So much from before the start is kept in memory and goes in front; 0: nothing.
    void setPreTrigger_s(double length_s);
    double preTrigger_s() const { return m_preTrigger_s; }
    /// How much of that there is by now.
    double held_s() const;
    /// Whether start() waits for an event; the recording ends by itself so long after that, 0: it does not.
    void setAtEvent(bool isAtEvent) { m_isAtEvent = isAtEvent; }
    bool isAtEvent() const { return m_isAtEvent; }
    void setPostTrigger_s(double length_s) { m_postTrigger_s = length_s; }
    /// These three as a project keeps them. While one records or waits they stay as they are.
    RecordingChoice choice() const { return {m_preTrigger_s, m_isAtEvent, m_postTrigger_s}; }
    void setChoice(const RecordingChoice& choice);

    void start();
    /// The event that was waited for, in the device's time.
    void startAtEvent(double time_s);
    void stop();
    bool isRecording() const { return m_recorder != nullptr || m_isStarting; }
    bool isWaiting() const { return m_isWaiting; }
    RecorderStatus status() const;
    /// Of the running recording or, after it, of the last one.
    const QString& path() const { return m_path; }

    /// A mark at a time of the device, kept in the recording's sidecar.
    void addMarker(double time_s, const QString& text);
    /// Values of the device as now known; changes are kept in the sidecar.
    void noteValues(const std::map<std::string, double>& values);

Q_SIGNALS:
    void changed();       ///< ten times a second while recording
    void folderChanged(); ///< another one, or its files
    void nameMaskChanged();
    void choiceChanged(); ///< by setChoice()
    void finished(const QString& path, const halbench::app::RecorderStatus& status);
    void failed(const QString& text, const QString& remedy);
    void rowsDropped(); ///< the first ones of this recording: the disk does not keep up

private:
    void onSession();
    bool isReady();
    Result<QString> newName() const;
    void prepare();
    void hold();
    void begin(RecorderConfig config);
    void look();
    void leave();

    DeviceSession& m_session;
    LiveSignals& m_liveSignals;
    WallClock m_wallClock = wallClock;
    devices::DiskAccess m_disk = devices::realDisk();
    std::size_t m_queue_rows = RecorderConfig().queue_rows;
    QString m_folder;
    QString m_name;
    QString m_nameMask = QString::fromLatin1(DefaultNameMask);
    QString m_path;
    double m_rate_Hz = 0.0; ///< 0: that of the plots
    std::shared_ptr<RecordingFeed> m_feed = std::make_shared<RecordingFeed>();
    double m_preTrigger_s = 0.0;
    double m_postTrigger_s = 0.0;
    bool m_isAtEvent = false;
    bool m_isWaiting = false;
    std::optional<double> m_event_s; ///< at which the recording starts; none: by hand
    std::optional<double> m_start_s; ///< the newest row when it was started by hand, if rows were kept
    bool m_isStarting = false;
    bool m_hasDropped = false; ///< and it was said
    std::shared_ptr<Recorder> m_recorder;
    std::map<std::string, double> m_values; ///< at the last look, for changes
    bool m_isInterrupted = false;           ///< the device is away; the recording waits for it
    QTimer m_look;
};

} // namespace halbench::app
