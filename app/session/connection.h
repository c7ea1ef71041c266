#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/device.h"
#include "devices/link_orders.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace halbench::app {

/// How the time of a simulated device runs. A real device has its own time; nothing here changes it.
struct Pace {
    /// Device seconds per wall second. 0: virtual time, which passes only while a procedure waits, so that
    /// the same calls give the same bytes as in batch mode.
    double speed_ratio = 1.0;
};

/// What the connection last knew of its device.
struct ConnectionReport {
    devices::DeviceState board;
    devices::LinkStatistics statistics;
    double deviceTime_s = 0.0;
    std::optional<Error> lost;        ///< why the link is gone
    bool isStoppedForSilence = false; ///< the window did not answer while the actuator was armed
};

/// Called on the connection thread; they must return soon and not call the connection back.
struct ConnectionEvents {
    std::function<void(const devices::DeviceInfo&, const devices::Catalogue&)> onOpened;
    std::function<void(const Error&)> onRefused; ///< could not be opened; nothing follows
    std::function<void(const ConnectionReport&)> onReport;
    std::function<void(SampleBlockPtr)> onBlock; ///< time since the device was opened
    std::function<void(const Error&)>
        onStreamRefused;            ///< the display's stream, e.g. signals without a common event
    std::function<void()> onClosed; ///< after close(), once the device is disarmed and closed; may be empty
};

/// One open device on a thread of its own (resources/help/architecture.md, threads). The thread serves the
/// link without pause: it feeds the watchdog, delivers samples, runs the jobs it is given one after the other
/// and obeys stop() between any two slices of 5 ms, whatever procedure, fit or picture is busy elsewhere.
/// While a job waits for the board's answer, the link itself looks at the orders and sends the stop.
/// Public functions may be called from any thread, except where it says so.
class Connection {
public:
    using Opener = std::function<Result<std::unique_ptr<devices::Device>>()>;
    using Job = std::function<void(devices::Device&)>;

    static constexpr double UsualPatience_s = 2.0;

    /// `orders` are those that the opener gave to the link.
    Connection(Opener open, Pace pace, ConnectionEvents events, double patience_s = UsualPatience_s,
               std::shared_ptr<devices::LinkOrders> orders = std::make_shared<devices::LinkOrders>());
    /// close() and the wait for its end. No event follows.
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Begins to end: what was posted runs, the device is disarmed and closed, onClosed follows. Returns at
    /// once; until onClosed a stop is obeyed as before.
    void close() noexcept;

    /// Runs the job on the connection thread. A job of a device that could not be opened is never run.
    void post(Job job);
    /// Emergency stop; returns at once.
    void stop() noexcept;
    /// Stops so far: a job that arms or releases compares it with what it was when the user asked, because a
    /// stop overtakes the jobs that wait.
    std::uint64_t stops() const noexcept { return m_orders->stops; }
    /// The window says that it could still stop. The board's watchdog does not see a window that hangs,
    /// because this thread goes on feeding it; so an armed actuator is stopped once nothing was said for the
    /// patience. Not in virtual time, in which nothing moves by itself.
    void confirmAlive() noexcept;
    void setPace(Pace pace);

    /// What the display wants to see whenever no procedure streams; no signals: nothing.
    void setLiveStream(devices::StreamRequest request);

    // For SharedDevice, as jobs on the connection thread only:
    Result<void> startProcedureStream(devices::Device& device, const devices::StreamRequest& request,
                                      devices::BlockSink sink);
    void stopProcedureStream(devices::Device& device);
    /// `done` is called on the connection thread once device time has advanced by the duration, or with the
    /// error that came first. One wait at a time.
    void beginWait(devices::Device& device, double duration_s, std::function<void(Result<void>)> done);

private:
    struct Wait {
        double duration_s = 0.0;
        double end_s = 0.0;
        std::function<void(Result<void>)> done;
    };

    void run();
    void serve(devices::Device& device);
    bool isStopWanted() const { return m_orders->stops != m_stopsServed; }
    void stopIfSilent(devices::Device& device);
    void runJobs(devices::Device& device);
    void advance(devices::Device& device);
    bool isVirtual() const { return m_isSimulated && m_speed_ratio <= 0.0; }
    std::optional<double> dueTime_s(double now_s);
    void idle(double duration_s);
    void afterSlice(devices::Device& device, const Result<void>& result);
    void finishWait(Result<void> result);
    void report(devices::Device& device, bool isForced);
    void restartLiveStream(devices::Device& device);
    devices::BlockSink displaySink(double start_s, devices::BlockSink then);

    const Opener m_open;
    const ConnectionEvents m_events;
    const double m_patience_s;

    std::mutex m_mutex; ///< guards the two below
    std::condition_variable m_wake;
    std::deque<Job> m_jobs;
    bool m_isClosing = false;
    const std::shared_ptr<devices::LinkOrders> m_orders;
    std::atomic<std::chrono::steady_clock::time_point> m_lastAlive;

    // Used by the connection thread alone.
    double m_speed_ratio;
    std::uint64_t m_stopsServed = 0;
    std::optional<Wait> m_wait;
    devices::StreamRequest m_live;
    bool m_isProcedureStreaming = false;
    std::optional<Error> m_lost;
    std::chrono::steady_clock::time_point m_lastAdvance;
    std::chrono::steady_clock::time_point m_lastReport;
    devices::DeviceState m_reported;
    double m_debt_s = 0.0; ///< device time that the wall clock asks for
    bool m_isSimulated = false;
    bool m_isStoppedForSilence = false;

    std::thread m_thread; ///< last: starts when everything else is there
};

} // namespace halbench::app
