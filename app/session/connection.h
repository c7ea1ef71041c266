#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/device.h"
#include "devices/link_orders.h"
#include "devices/open/device_return.h"

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

/// State of the device and of its link, as the connection last knew them.
struct ConnectionReport {
    devices::DeviceState board;
    devices::LinkStatistics statistics;
    double deviceTime_s = 0.0;
    std::optional<Error> lost;        ///< why the link is gone
    bool isReturning = false;         ///< it is gone, and the device is looked for
    std::string notBack;              ///< why the last look did not find it; empty before there was one
    bool isStoppedForSilence = false; ///< the window did not answer while the actuator was armed
};

/// Called on the connection thread; they must return soon and not call the connection back.
struct ConnectionEvents {
    std::function<void(const devices::DeviceInfo&, const devices::Catalogue&)> onOpened;
    std::function<void(const Error&)> onRefused; ///< could not be opened; nothing follows
    std::function<void(const ConnectionReport&)> onReport;
    /// A lost device is back, disarmed, after so many seconds; how often that happened so far. May be empty
    /// for a device that cannot.
    std::function<void(const devices::DeviceInfo&, double outage_s, std::uint64_t returns)> onReturned;
    TimedBlockSink onBlock; ///< its axis: the time since the device was opened
    std::function<void(const Error&)>
        onStreamRefused;            ///< the display's stream, e.g. signals without a common event
    std::function<void()> onClosed; ///< after close(), once the device is disarmed and closed; may be empty
};

/// How a lost device is found again.
struct ReturnPlan {
    devices::DeviceReturn::Opener open;
    devices::ReturnTimes times;
};

/// One open device on a thread of its own (resources/help/architecture.md, threads). The thread serves the
/// link without pause: it feeds the watchdog, delivers samples, runs the jobs it is given one after the other
/// and obeys stop() between any two slices of 5 ms, whatever procedure, fit or picture is busy elsewhere.
/// A stream that only the display watches is taken in every few ms: to wake for each of its packets costs
/// more than the packets do. While a job waits for the board's answer, the link itself looks at the orders
/// and sends the stop.
///
/// A device that is lost is looked for until close(), if there is a plan for it. It comes back disarmed, the
/// display's stream goes on, and time has passed by the host's clock. Whatever was begun before the loss gets
/// DeviceLost for ever: no procedure and no waiting order goes on with the device that came back.
/// Public functions may be called from any thread, except where it says so.
class Connection {
public:
    using Opener = std::function<Result<std::unique_ptr<devices::Device>>()>;
    using Job = std::function<void(devices::Device&)>;

    static constexpr double UsualPatience_s = 2.0;

    /// `orders` are those that the openers gave to the link.
    Connection(Opener open, Pace pace, ConnectionEvents events, double patience_s = UsualPatience_s,
               std::shared_ptr<devices::LinkOrders> orders = std::make_shared<devices::LinkOrders>(),
               std::optional<ReturnPlan> plan = {});
    /// close() and the wait for its end. No event follows.
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Begins to end: what was posted runs, the device is disarmed and closed, onClosed follows. Returns at
    /// once; until onClosed a stop is obeyed as before.
    void close() noexcept;

    /// Runs the job on the connection thread. A job of a device that could not be opened is never run. With
    /// `returns`, the returns that its author knew of, it meets a lost device if there were more meanwhile.
    void post(Job job, std::optional<std::uint64_t> returns = {});
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

    struct Order {
        Job job;
        std::optional<std::uint64_t> returns;
    };

    void run();
    void serve();
    void obeyStop();
    void settleStop();
    bool isStopWanted() const { return m_orders->stops != m_stopsServed; }
    void stopIfSilent();
    void runJobs();
    void advance();
    void lose(const Error& error);
    void awaitReturn();
    void takeBack(std::unique_ptr<devices::Device> device);
    double displayTime_s() const { return m_start_s + m_device->clock().now_s(); }
    bool isVirtual() const { return m_isPaced && m_speed_ratio <= 0.0; }
    std::optional<double> dueTime_s(double now_s);
    void idle(double duration_s);
    bool mayGather();
    void afterSlice(const Result<void>& result);
    void finishWait(Result<void> result);
    void report(bool isForced);
    void restartLiveStream();
    devices::BlockSink displaySink(devices::BlockSink then);

    const Opener m_open;
    const ConnectionEvents m_events;
    const double m_patience_s;
    const std::optional<ReturnPlan> m_plan;

    std::mutex m_mutex; ///< guards the two below
    std::condition_variable m_wake;
    std::deque<Order> m_jobs;
    bool m_isClosing = false;
    const std::shared_ptr<devices::LinkOrders> m_orders;
    std::atomic<std::chrono::steady_clock::time_point> m_lastAlive;

    // Used by the connection thread alone.
    std::unique_ptr<devices::Device> m_device; ///< a devices::DisconnectedDevice while it is looked for
    std::unique_ptr<devices::Device> m_former; ///< what jobs from before the last return meet
    std::optional<devices::DeviceReturn> m_return;
    std::uint64_t m_returns = 0;
    bool m_isReturning = false;
    bool m_isStopOwed = false; ///< asked for and not confirmed by the board: it is sent again after a return
    std::chrono::steady_clock::time_point m_lostAt;
    double m_start_s = 0.0; ///< of the device's clock since the first was opened
    double m_speed_ratio;
    std::uint64_t m_stopsServed = 0;
    std::optional<Wait> m_wait;
    devices::StreamRequest m_live;
    bool m_isProcedureStreaming = false;
    std::optional<Error> m_lost;
    std::chrono::steady_clock::time_point m_lastAdvance;
    std::chrono::steady_clock::time_point m_lastReport;
    devices::DeviceState m_reported;
    std::uint64_t m_packetsTaken = 0; ///< at the last slice
    double m_debt_s = 0.0;            ///< device time that the wall clock asks for
    bool m_isPaced = false;           ///< its time passes as fast as the pace says: simulated or replayed
    bool m_isStoppedForSilence = false;

    std::thread m_thread; ///< last: starts when everything else is there
};

} // namespace halbench::app
