#include "app/session/connection.h"

#include "devices/open/disconnected_device.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

using Clock = std::chrono::steady_clock;

/// Longest wall time between two looks at the stop request.
constexpr double Slice_s = 5e-3;
/// Longest device time of one slice, whatever the speed: short enough to stop within it.
constexpr double MaxDeviceSlice_s = 0.02;
/// Device time that a host which was asleep does not catch up.
constexpr double MaxDebt_s = 0.5;
constexpr double ShortestSlice_s = 1e-3;
/// The same of a time that runs slower than the wall clock's, so that it does not jump.
constexpr double ShortestSlowSlice_s = 1e-4;
constexpr double Rounding_s = 1e-9;
/// A frame of the display is four times as long.
constexpr double Gathering_s = 8e-3;
/// So long the packets that have gathered are taken in; what is there already takes a part of it.
constexpr double TakingIn_s = 1e-3;
/// More since the last slice: they come faster than they are taken in, and nothing is left to gather.
constexpr std::uint64_t MostGathered = 256;
constexpr auto ReportPeriod = std::chrono::milliseconds(100);

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

bool isDifferent(const devices::DeviceState& one, const devices::DeviceState& other) {
    return one.isConnected != other.isConnected || one.isArmed != other.isArmed ||
           one.isStopLatched != other.isStopLatched || one.fault != other.fault;
}

} // namespace

Connection::Connection(Opener open, Pace pace, ConnectionEvents events, double patience_s,
                       std::shared_ptr<devices::LinkOrders> orders, std::optional<ReturnPlan> plan)
    : m_open(std::move(open)), m_events(std::move(events)), m_patience_s(patience_s), m_plan(std::move(plan)),
      m_orders(std::move(orders)), m_lastAlive(Clock::now()), m_speed_ratio(pace.speed_ratio),
      m_thread([this] { run(); }) {}

Connection::~Connection() {
    close();
    m_thread.join();
}

void Connection::close() noexcept {
    m_orders->isLeaving = true;
    {
        const std::lock_guard lock(m_mutex);
        m_isClosing = true;
    }
    m_wake.notify_all();
}

void Connection::post(Job job, std::optional<std::uint64_t> returns) {
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back({std::move(job), returns});
    }
    m_wake.notify_all();
}

void Connection::stop() noexcept {
    ++m_orders->stops;
    m_wake.notify_all();
}

void Connection::confirmAlive() noexcept {
    m_lastAlive = Clock::now();
}

void Connection::setPace(Pace pace) {
    post([this, pace](devices::Device&) {
        m_speed_ratio = pace.speed_ratio;
        m_debt_s = 0.0;
        if (!m_isProcedureStreaming) {
            restartLiveStream();
        }
    });
}

void Connection::setLiveStream(devices::StreamRequest request) {
    post([this, request = std::move(request)](devices::Device&) {
        m_live = request;
        if (!m_isProcedureStreaming) {
            restartLiveStream();
        }
    });
}

void Connection::run() {
    Result<std::unique_ptr<devices::Device>> device = m_open();
    if (!device) {
        m_events.onRefused(device.error());
        return;
    }
    m_device = *std::move(device);
    m_isPaced = m_device->info().isSimulated || m_device->info().transport == "replay";
    m_events.onOpened(m_device->info(), m_device->catalogue());
    m_lastAdvance = Clock::now();
    report(true);
    serve();
    m_device->stopStream();
    if (m_device->state().isConnected) {
        (void)m_device->disarm(); // a lost device is left to the board's watchdog
    }
    m_device.reset();
    if (m_events.onClosed) {
        m_events.onClosed();
    }
}

void Connection::serve() {
    for (;;) {
        obeyStop();
        stopIfSilent();
        runJobs();
        {
            const std::lock_guard lock(m_mutex);
            if (m_isClosing && m_jobs.empty()) {
                return;
            }
        }
        if (!isStopWanted()) {
            advance();
        }
    }
}

void Connection::obeyStop() {
    if (!isStopWanted()) {
        return;
    }
    m_stopsServed = stops();
    m_isStopOwed = true; // until the board says that it is latched: the link may be dead already
    m_device->stop();
    settleStop();
    report(true);
}

void Connection::settleStop() {
    const devices::DeviceState board = m_device->state();
    m_isStopOwed = m_isStopOwed && !(board.isConnected && board.isStopLatched);
}

void Connection::stopIfSilent() {
    const bool isSilent = seconds(Clock::now() - m_lastAlive.load()) > m_patience_s;
    if (!isSilent || isVirtual() || !m_device->state().isArmed) {
        return;
    }
    m_device->stop();
    m_isStoppedForSilence = true;
    report(true);
}

/// One job at a time, so that a stop never waits for more than one.
void Connection::runJobs() {
    Order order;
    {
        const std::lock_guard lock(m_mutex);
        if (m_jobs.empty()) {
            return;
        }
        order = std::move(m_jobs.front());
        m_jobs.pop_front();
    }
    const bool isFormer = order.returns && *order.returns != m_returns;
    const bool wasArmed = m_device->state().isArmed;
    order.job(isFormer ? *m_former : *m_device);
    if (!wasArmed && m_device->state().isArmed) {
        m_isStoppedForSilence = false; // armed anew: the next silence is to be told again
    }
    report(false);
}

void Connection::advance() {
    if (m_lost) {
        finishWait(failure(*m_lost));
        awaitReturn();
        idle(Slice_s);
        return;
    }
    const double now_s = m_device->clock().now_s();
    const std::optional<double> slice_s = dueTime_s(now_s);
    if (!slice_s) {
        idle(Slice_s / 2.0);
        return;
    }
    const bool hasGathered = mayGather();
    if (hasGathered) {
        idle(Gathering_s);
        if (isStopWanted()) {
            return;
        }
    }
    const Result<void> passed = m_device->clock().waitFor(hasGathered ? TakingIn_s : *slice_s);
    if (m_isPaced) {
        m_debt_s = std::max(0.0, m_debt_s - (m_device->clock().now_s() - now_s));
    }
    afterSlice(passed);
}

/// The port is closed at once, so that it is free to be opened again.
void Connection::lose(const Error& error) {
    m_lost = error;
    m_lostAt = Clock::now();
    if (!m_plan) {
        return;
    }
    if (!m_return) {
        m_return.emplace(m_device->info(), m_plan->open, m_plan->times);
    }
    m_isProcedureStreaming = false;
    m_device = std::make_unique<devices::DisconnectedDevice>(*m_device, m_device->clock().now_s(), error);
    const Result<void> goOn = m_return->noteLost(seconds(m_lostAt.time_since_epoch()));
    m_isReturning = goOn.has_value();
    if (!goOn) {
        m_lost = goOn.error();
    }
}

void Connection::awaitReturn() {
    if (!m_isReturning) {
        return;
    }
    Result<std::unique_ptr<devices::Device>> found = m_return->look(seconds(Clock::now().time_since_epoch()));
    if (!found) {
        m_isReturning = false;
        m_lost = found.error();
        report(true);
    } else if (*found) {
        takeBack(*std::move(found));
    } else {
        report(false);
    }
}

void Connection::takeBack(std::unique_ptr<devices::Device> device) {
    if (device->state().isArmed) {
        if (!device->disarm()) { // boards of ours are disarmed by their CONNECT
            device->stop();
        }
    }
    if (m_isStopOwed) {
        device->stop();
    }
    const double outage_s = seconds(Clock::now() - m_lostAt);
    m_start_s = displayTime_s() + outage_s - device->clock().now_s();
    m_former = std::exchange(m_device, std::move(device));
    settleStop();
    m_lost.reset();
    m_isReturning = false;
    ++m_returns;
    m_debt_s = 0.0;
    m_lastAdvance = Clock::now();
    m_events.onReturned(m_device->info(), outage_s, m_returns);
    report(true);
    restartLiveStream();
}

/// Device time that shall pass now, if any. A real device's clock paces itself; a simulated one runs behind
/// the wall clock by less than a slice, or, in virtual time, exactly as far as somebody waits for.
std::optional<double> Connection::dueTime_s(double now_s) {
    const Clock::time_point wall = Clock::now();
    const double passed_s = seconds(wall - std::exchange(m_lastAdvance, wall));
    if (isVirtual()) {
        return m_wait ? std::optional(m_wait->duration_s) : std::nullopt;
    }
    double due_s = Slice_s;
    double shortest_s = ShortestSlice_s;
    if (m_isPaced) {
        const double speed_ratio = m_speed_ratio;
        m_debt_s = std::min(m_debt_s + passed_s * speed_ratio, MaxDebt_s * speed_ratio);
        due_s = std::min(m_debt_s, MaxDeviceSlice_s);
        shortest_s = std::clamp(Slice_s * speed_ratio, ShortestSlowSlice_s, ShortestSlice_s);
    }
    if (m_wait) {
        const double left_s = std::max(0.0, m_wait->end_s - now_s);
        if (left_s <= due_s) {
            return left_s;
        }
    }
    return due_s >= shortest_s ? std::optional(due_s) : std::nullopt;
}

void Connection::idle(double duration_s) {
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, std::chrono::duration<double>(duration_s),
                    [this] { return !m_jobs.empty() || m_isClosing || isStopWanted(); });
}

/// A real device's samples, when nothing but the display waits for them.
bool Connection::mayGather() {
    if (m_isPaced || m_wait || m_isProcedureStreaming || m_live.signals.empty()) {
        return false;
    }
    const std::uint64_t received = m_device->statistics().packetsReceived;
    return received - std::exchange(m_packetsTaken, received) <= MostGathered;
}

void Connection::afterSlice(const Result<void>& result) {
    if (!result && result.error().code == ErrorCode::DeviceLost) {
        lose(result.error());
    }
    if (!result && m_wait) {
        finishWait(result);
    } else if (!result && !m_lost) {
        (void)m_device->disarm(); // stopped by the board while nobody waits: it stays disarmed, time goes on
    } else if (m_wait && m_device->clock().now_s() >= m_wait->end_s - Rounding_s) {
        finishWait({});
    }
    report(!result.has_value());
}

void Connection::finishWait(Result<void> result) {
    if (m_wait) {
        const Wait wait = *std::exchange(m_wait, std::nullopt);
        wait.done(std::move(result));
    }
}

void Connection::beginWait(devices::Device& device, double duration_s,
                           std::function<void(Result<void>)> done) {
    if (&device != m_device.get()) {
        done(device.clock().waitFor(duration_s)); // gone
        return;
    }
    const double wanted_s = std::max(duration_s, 0.0);
    m_wait = Wait{wanted_s, device.clock().now_s() + wanted_s, std::move(done)};
}

Result<void> Connection::startProcedureStream(devices::Device& device, const devices::StreamRequest& request,
                                              devices::BlockSink sink) {
    m_isProcedureStreaming = m_isProcedureStreaming || (&device == m_device.get() && !m_isReturning);
    return device.startStream(request, displaySink(std::move(sink)));
}

void Connection::stopProcedureStream(devices::Device& device) {
    if (&device != m_device.get()) {
        return;
    }
    m_isProcedureStreaming = false;
    device.stopStream();
    restartLiveStream();
}

void Connection::restartLiveStream() {
    m_device->stopStream();
    if (m_live.signals.empty() || isVirtual() || m_lost) {
        return;
    }
    const Result<void> started = m_device->startStream(m_live, displaySink({}));
    if (!started) {
        m_events.onStreamRefused(started.error());
    }
}

/// For a stream that starts now.
devices::BlockSink Connection::displaySink(devices::BlockSink then) {
    return [this, start_s = displayTime_s(), then = std::move(then)](SampleBlockPtr block) {
        m_events.onBlock({block, start_s});
        if (then) {
            then(std::move(block));
        }
    };
}

void Connection::report(bool isForced) {
    const Clock::time_point wall = Clock::now();
    const devices::DeviceState board = m_device->state();
    if (!isForced && !isDifferent(board, m_reported) && wall - m_lastReport < ReportPeriod) {
        return;
    }
    m_lastReport = wall;
    m_reported = board;
    m_events.onReport({board, m_device->statistics(), displayTime_s(), m_lost, m_isReturning,
                       m_isReturning ? m_return->reason().message : std::string(), m_isStoppedForSilence});
}

} // namespace halbench::app
