#pragma once

#include "app/procedures/base/procedure.h"
#include "app/session/connection.h"
#include "app/session/gui_queue.h"
#include "app/session/held_device.h"
#include "app/session/shared_device.h"
#include "devices/acquisition/display_inbox.h"
#include "devices/device_options.h"

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QTimer>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

namespace halbench::app {

/// Reconnecting: the device was lost and is looked for until disconnectDevice(); Connected follows by itself,
/// disarmed. Lost: it cannot come back by itself. Leaving: what runs is being ended and the device disarmed;
/// Disconnected follows by itself.
enum class SessionState { Disconnected, Connecting, Connected, Reconnecting, Lost, Leaving };

enum class MessageLevel { Debug, Info, Warning, Error };

/// How a procedure ended.
struct ProcedureOutcome {
    std::optional<Error> error;
    std::optional<Verdict> verdict; ///< of its result, where that is judged
};

template <typename Answer>
ProcedureOutcome outcomeOf(const Answer& answer) {
    ProcedureOutcome outcome;
    if (!answer) {
        outcome.error = answer.error();
    } else if constexpr (requires { answer->quality.verdict; }) {
        outcome.verdict = answer->quality.verdict;
    }
    return outcome;
}

/// The device of the window, seen from the GUI thread: what it is, how it is, and asynchronous access to it.
/// Nothing here waits for the device. One device and at most one procedure at a time.
/// Thread: GUI; only stopActuator() may be called from anywhere.
class DeviceSession : public QObject {
    Q_OBJECT

public:
    explicit DeviceSession(QObject* parent = nullptr);
    /// Ends a running procedure through its restore path, disarms, disconnects.
    ~DeviceSession() override;

    /// Opens a device, after the one there was has been left; answers with stateChanged() or connectFailed().
    /// A recording ("replay:FILE") leaves the device connected: it is held, disarmed, with its gains and its
    /// calibration, until closeRecording() or until its own address is connected again.
    void connectDevice(const QString& uri, Pace pace, std::optional<std::uint64_t> seed = {});
    /// Ends a running procedure through its restore path, disarms, closes. Returns at once in the state
    /// Leaving, in which a stop still works and nothing new begins.
    void disconnectDevice();
    /// Leaves the recording that is open or being read; the device that is held is connected then.
    void closeRecording();
    /// Address of the device that is held while a recording is open; empty: none.
    QString heldDevice() const { return m_held ? m_held->address() : QString(); }
    /// Of the connection to the present device, or to the one that is held; 0: none. The same number is the
    /// same device with everything that was written to it.
    std::uint64_t deviceNumber() const {
        return m_held ? m_held->number : m_connection ? m_number.load() : 0;
    }
    /// The same for a destructor: returns when it is done, at the latest when the board was silent for its
    /// time-outs, and nothing is told any more.
    void end();

    SessionState state() const { return m_state; }
    /// A recording was played to its end: no link is gone, and its values can still be read.
    bool isPlayedToTheEnd() const { return m_state == SessionState::Lost && m_info.transport == "replay"; }
    /// How often the present device came back by itself; 0 after it was connected.
    std::uint64_t returns() const { return m_returns; }
    /// How long it was away the last time.
    double outage_s() const { return m_outage_s; }
    /// For the devices that are connected from now on.
    void setReturnTimes(const devices::ReturnTimes& times) { m_returnTimes = times; }
    const devices::DeviceInfo& info() const { return m_info; }
    const devices::Catalogue& catalogue() const { return m_catalogue; }
    const ConnectionReport& report() const { return m_report; }
    Pace pace() const { return m_pace; }
    void setPace(Pace pace);

    /// Signals the display wants while no procedure streams. The rate must divide their event's rate.
    void setLiveStream(const std::vector<std::string>& signalNames, double rate_Hz);
    /// Samples that arrived since the last call, oldest first; time since the device was opened. What a
    /// window that did not call for two minutes, or a device that floods, brought beyond the room for it is
    /// left out, and said.
    std::vector<TimedBlock> takeBlocks();

    /// Every block as it comes, on the connection thread, for a recorder; empty: nobody. It must return at
    /// once, and may still be called for the block that was on its way.
    void setBlockSink(TimedBlockSink sink);

    /// Emergency stop: to the wire within a slice of the connection thread, whatever else is busy.
    void stopActuator() noexcept;

    /// Runs `function(Device&) -> Result<T>` on the connection thread and `then(Result<T>)` afterwards on the
    /// GUI thread; DeviceLost at once when nothing is connected, and when the device is lost before its turn.
    template <typename Function, typename Then>
    void request(Function function, Then then);
    /// The same for what arms or releases: Interrupted if a stop came after this call, however long the
    /// function had to wait for its turn.
    template <typename Function, typename Then>
    void requestUnlessStopped(Function function, Then then);
    /// And for what was decided earlier, when stops() was `stops`: whatever had to be done first.
    template <typename Function, typename Then>
    void requestUnlessStoppedSince(std::uint64_t stops, Function function, Then then);
    /// Stops that this connection was asked for.
    std::uint64_t stops() const { return m_connection ? m_connection->stops() : 0; }

    /// Name of the running procedure; empty when none runs.
    const QString& procedure() const { return m_procedure; }
    /// Runs `function(Device&, const ProcedureObserver&) -> Result<T>` on a thread of its own and `then(...)`
    /// on the GUI thread. False when there is no device or a procedure runs already.
    template <typename Function, typename Then>
    bool runProcedure(const QString& name, Function function, Then then);
    /// Asks the running procedure to end through its restore path.
    void abortProcedure();
    /// Of the procedure that ended last; valid from procedureChanged() on.
    const ProcedureOutcome& outcome() const { return m_outcome; }

Q_SIGNALS:
    void stateChanged();
    void connectFailed(const QString& message, const QString& hint);
    void openProgress(double fraction); ///< of a recording that is being read
    void reportChanged(); ///< at most ten times a second, and whenever the board's state changes
    void procedureChanged();
    void procedureStage(halbench::app::ProcedureState stage);
    void procedureProgress(double fraction, const QString& text);
    void message(halbench::app::MessageLevel level, const QString& source, const QString& text);

private:
    /// What connectDevice() was given.
    struct Wish {
        QString uri;
        Pace pace;
        std::optional<std::uint64_t> seed;

        bool isRecording() const { return uri.startsWith(QLatin1String("replay:")); }
    };

    template <typename Function>
    void onGui(Function function);
    void open(const Wish& wish);
    bool isHeldFor(const Wish& wish) const;
    void hold();
    std::unique_ptr<HeldDevice> useHeld();
    void takeHeldBack();
    void leave();
    void disarmWhatStillRuns();
    void left();
    void goOn();
    std::unique_ptr<Connection> takeConnection();
    devices::OpenOptions optionsFor(const Wish& wish, std::shared_ptr<devices::LinkOrders> orders);
    void opened(const devices::DeviceInfo& info, const devices::Catalogue& catalogue);
    void returned(const devices::DeviceInfo& info, double outage_s, std::uint64_t returns);
    void refused(const Error& error);
    void reported(const ConnectionReport& report);
    void setState(SessionState state);
    ConnectionEvents events(std::uint64_t number);
    ProcedureObserver observer();
    bool startProcedure(const QString& name,
                        std::function<void(devices::Device&, const ProcedureObserver&)> body);
    void endProcedureThread();

    SessionState m_state = SessionState::Disconnected;
    devices::DeviceInfo m_info;
    devices::Catalogue m_catalogue;
    ConnectionReport m_report;
    Pace m_pace;
    QString m_procedure;
    ProcedureOutcome m_outcome;
    std::optional<Wish> m_next;  ///< connected once the present device is left
    bool m_isLeavingAll = false; ///< the held device too
    devices::ReturnTimes m_returnTimes;
    std::uint64_t m_returns = 0;
    double m_outage_s = 0.0;

    GuiQueue m_guiQueue;
    std::atomic<bool> m_isAborting = false;
    devices::DisplayInbox m_inbox;
    std::uint64_t m_skippedRows = 0; ///< of the inbox, as said
    std::mutex m_mutex;              ///< guards the sink
    TimedBlockSink m_blockSink;

    std::mutex m_connectionMutex; ///< guards the pointers against stopActuator() from another thread
    std::unique_ptr<Connection> m_connection;
    std::unique_ptr<HeldDevice> m_held;      ///< while a recording is open
    std::atomic<std::uint64_t> m_number = 0; ///< of the present connection, which its events carry
    std::uint64_t m_lastNumber = 0;
    QTimer m_heartbeat; ///< tells the connection that this thread still turns its events
    std::unique_ptr<SharedDevice> m_procedureDevice;
    std::thread m_procedureThread;
};

template <typename Function>
void DeviceSession::onGui(Function function) {
    m_guiQueue.add(std::move(function));
}

template <typename Function, typename Then>
void DeviceSession::request(Function function, Then then) {
    using Answer = std::invoke_result_t<Function, devices::Device&>;
    if (m_state != SessionState::Connected) {
        then(Answer(failure(ErrorCode::DeviceLost, "no device is connected", "connect one first")));
        return;
    }
    m_connection->confirmAlive(); // who asks, lives: arming first thing after a pause is not stopped for it
    m_connection->post(
        [this, function, then](devices::Device& device) {
            auto answer = std::make_shared<Answer>(function(device));
            onGui([answer, then] { then(std::move(*answer)); });
        },
        m_returns);
}

template <typename Function, typename Then>
void DeviceSession::requestUnlessStopped(Function function, Then then) {
    requestUnlessStoppedSince(stops(), std::move(function), std::move(then));
}

template <typename Function, typename Then>
void DeviceSession::requestUnlessStoppedSince(std::uint64_t stops, Function function, Then then) {
    using Answer = std::invoke_result_t<Function, devices::Device&>;
    const Connection* connection = m_connection.get(); // outlives its jobs
    request(
        [function, connection, stops](devices::Device& device) -> Answer {
            if (connection->stops() != stops) {
                return failure(ErrorCode::Interrupted, "interrupted by a stop; not executed",
                               "check the cause of the stop, then try again");
            }
            return function(device);
        },
        then);
}

template <typename Function, typename Then>
bool DeviceSession::runProcedure(const QString& name, Function function, Then then) {
    using Answer = std::invoke_result_t<Function, devices::Device&, const ProcedureObserver&>;
    return startProcedure(name,
                          [this, function, then](devices::Device& device, const ProcedureObserver& observer) {
                              auto answer = std::make_shared<Answer>(function(device, observer));
                              onGui([this, answer, then] {
                                  m_outcome = outcomeOf(*answer);
                                  endProcedureThread();
                                  then(std::move(*answer));
                              });
                          });
}

} // namespace halbench::app
