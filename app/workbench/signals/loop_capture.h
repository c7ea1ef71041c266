#pragma once

#include "app/procedures/record/capture_orders.h"
#include "app/session/device_session.h"
#include "app/session/disconnect_task.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace halbench::app {

/// The board's own capture at loop rate, beside whatever else is done with the device: each order to the
/// board is a short one, one at a time, between which stream, watchdog and stop are served as ever. While a
/// procedure runs nothing is ordered at all, and while a recording is written the full capture is not read:
/// the board keeps it. Nothing is armed. The board's set-up is put back at the end, when the device is left,
/// and when it was lost meanwhile, once it is back. Thread: GUI.
class LoopCapture : public QObject {
    Q_OBJECT

public:
    enum class State {
        Off,
        Held,    ///< a procedure has the device; it goes on by itself
        Begins,  ///< the board is being set up
        Filling, ///< what lies before the event
        Waiting, ///< for the event
        Running, ///< the event came
        Full,    ///< it is read once no recording is written
        Reading,
        Done,  ///< recording() is the newest one
        Failed ///< error() says why
    };

    explicit LoopCapture(DeviceSession& session, QObject* parent = nullptr);
    /// Puts the board's set-up back, where the board is still connected.
    ~LoopCapture() override;

    /// From now on the board captures this, once. What it captured before and was not read is forgotten.
    void start(const CaptureConfig& config);
    /// The same again.
    void again();
    /// The board's set-up is put back, as soon as nothing else runs.
    void stop();
    /// A recording is being written, or not any more.
    void setRecordingWritten(bool isWritten);

    State state() const { return m_state; }
    const Error& error() const { return m_error; }
    const CaptureConfig& config() const { return m_config; }
    /// Of the newest whole one; time from the event.
    const Recording& recording() const { return m_recording; }
    /// Share of the reading that is done.
    double fraction() const;

Q_SIGNALS:
    void changed();
    void captured();

private:
    using SetUp = std::vector<ParameterValue>;

    template <typename Function, typename Then>
    void ask(Function function, Then then);
    /// Used on the connection thread, where orders follow each other.
    struct Kept {
        std::optional<SetUp> before; ///< what the board was set to; none: nothing is to be put back
        SetUp ours;                  ///< what it was set to for the capture
    };
    static Result<void> begin(devices::Device& device, Kept& kept, const SetUp& values);
    static Result<void> putBack(devices::Device& device, Kept& kept);
    void renew();
    void onSession();
    void work();
    void beginCapture();
    void end();
    void look();
    void read();
    void saw(CaptureState state);
    void took(Result<Recording> piece);
    void fail(const Error& error);
    void setState(State state);

    DeviceSession& m_session;
    QPointer<DeviceSession> m_living; ///< a window that goes takes its session along before its panels
    QTimer m_timer;
    CaptureConfig m_config;
    State m_state = State::Off;
    Error m_error;
    Recording m_recording;
    std::shared_ptr<Kept> m_kept;
    QPointer<DisconnectTask> m_disconnectTask;
    bool m_isWanted = false;
    bool m_isBegun = false; ///< the board has the present config
    bool m_isAsking = false;
    bool m_isRecordingWritten = false;
    std::uint64_t m_asked = 0; ///< number of the connection's orders that still count
    int m_pieces = 0;
};

} // namespace halbench::app
