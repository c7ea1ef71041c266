#include "app/session/connection.h"

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
constexpr double Rounding_s = 1e-9;
constexpr auto ReportPeriod = std::chrono::milliseconds(100);

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

SampleBlockPtr shifted(const SampleBlockPtr& block, double by_s) {
    auto moved = std::make_shared<SampleBlock>(*block);
    for (double& time_s : moved->time_s) {
        time_s += by_s;
    }
    return moved;
}

bool isDifferent(const devices::DeviceState& one, const devices::DeviceState& other) {
    return one.isConnected != other.isConnected || one.isArmed != other.isArmed ||
           one.isStopLatched != other.isStopLatched || one.fault != other.fault;
}

} // namespace

Connection::Connection(Opener open, Pace pace, ConnectionEvents events, double patience_s,
                       std::shared_ptr<devices::LinkOrders> orders)
    : m_open(std::move(open)), m_events(std::move(events)), m_patience_s(patience_s),
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

void Connection::post(Job job) {
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back(std::move(job));
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
    post([this, pace](devices::Device& device) {
        m_speed_ratio = pace.speed_ratio;
        m_debt_s = 0.0;
        if (!m_isProcedureStreaming) {
            restartLiveStream(device);
        }
    });
}

void Connection::setLiveStream(devices::StreamRequest request) {
    post([this, request = std::move(request)](devices::Device& device) {
        m_live = request;
        if (!m_isProcedureStreaming) {
            restartLiveStream(device);
        }
    });
}

void Connection::run() {
    Result<std::unique_ptr<devices::Device>> device = m_open();
    if (!device) {
        m_events.onRefused(device.error());
        return;
    }
    m_isSimulated = (*device)->info().isSimulated;
    m_events.onOpened((*device)->info(), (*device)->catalogue());
    m_lastAdvance = Clock::now();
    report(**device, true);
    serve(**device);
    (*device)->stopStream();
    if ((*device)->state().isConnected) {
        (void)(*device)->disarm(); // a lost device is left to the board's watchdog
    }
    device->reset();
    if (m_events.onClosed) {
        m_events.onClosed();
    }
}

void Connection::serve(devices::Device& device) {
    for (;;) {
        if (isStopWanted()) {
            m_stopsServed = stops();
            device.stop();
            report(device, true);
        }
        stopIfSilent(device);
        runJobs(device);
        {
            const std::lock_guard lock(m_mutex);
            if (m_isClosing && m_jobs.empty()) {
                return;
            }
        }
        if (!isStopWanted()) {
            advance(device);
        }
    }
}

void Connection::stopIfSilent(devices::Device& device) {
    const bool isSilent = seconds(Clock::now() - m_lastAlive.load()) > m_patience_s;
    if (!isSilent || isVirtual() || !device.state().isArmed) {
        return;
    }
    device.stop();
    m_isStoppedForSilence = true;
    report(device, true);
}

/// One job at a time, so that a stop never waits for more than one.
void Connection::runJobs(devices::Device& device) {
    Job job;
    {
        const std::lock_guard lock(m_mutex);
        if (m_jobs.empty()) {
            return;
        }
        job = std::move(m_jobs.front());
        m_jobs.pop_front();
    }
    const bool wasArmed = device.state().isArmed;
    job(device);
    if (!wasArmed && device.state().isArmed) {
        m_isStoppedForSilence = false; // armed anew: the next silence is to be told again
    }
    report(device, false);
}

void Connection::advance(devices::Device& device) {
    if (m_lost) {
        finishWait(failure(*m_lost));
        idle(Slice_s);
        return;
    }
    const double now_s = device.clock().now_s();
    const std::optional<double> slice_s = dueTime_s(now_s);
    if (!slice_s) {
        idle(Slice_s / 2.0);
        return;
    }
    const Result<void> passed = device.clock().waitFor(*slice_s);
    if (m_isSimulated) {
        m_debt_s = std::max(0.0, m_debt_s - (device.clock().now_s() - now_s));
    }
    afterSlice(device, passed);
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
    if (m_isSimulated) {
        const double speed_ratio = m_speed_ratio;
        m_debt_s = std::min(m_debt_s + passed_s * speed_ratio, MaxDebt_s * std::max(1.0, speed_ratio));
        due_s = std::min(m_debt_s, MaxDeviceSlice_s);
    }
    if (m_wait) {
        const double left_s = std::max(0.0, m_wait->end_s - now_s);
        if (left_s <= due_s) {
            return left_s;
        }
    }
    return due_s >= ShortestSlice_s ? std::optional(due_s) : std::nullopt;
}

void Connection::idle(double duration_s) {
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, std::chrono::duration<double>(duration_s),
                    [this] { return !m_jobs.empty() || m_isClosing || isStopWanted(); });
}

void Connection::afterSlice(devices::Device& device, const Result<void>& result) {
    if (!result && result.error().code == ErrorCode::DeviceLost) {
        m_lost = result.error();
    }
    if (!result && m_wait) {
        finishWait(result);
    } else if (!result && !m_lost) {
        (void)device.disarm(); // stopped by the board while nobody waits: it stays disarmed, time goes on
    } else if (m_wait && device.clock().now_s() >= m_wait->end_s - Rounding_s) {
        finishWait({});
    }
    report(device, !result.has_value());
}

void Connection::finishWait(Result<void> result) {
    if (m_wait) {
        const Wait wait = *std::exchange(m_wait, std::nullopt);
        wait.done(std::move(result));
    }
}

void Connection::beginWait(devices::Device& device, double duration_s,
                           std::function<void(Result<void>)> done) {
    const double wanted_s = std::max(duration_s, 0.0);
    m_wait = Wait{wanted_s, device.clock().now_s() + wanted_s, std::move(done)};
}

Result<void> Connection::startProcedureStream(devices::Device& device, const devices::StreamRequest& request,
                                              devices::BlockSink sink) {
    m_isProcedureStreaming = true;
    return device.startStream(request, displaySink(device.clock().now_s(), std::move(sink)));
}

void Connection::stopProcedureStream(devices::Device& device) {
    m_isProcedureStreaming = false;
    device.stopStream();
    restartLiveStream(device);
}

void Connection::restartLiveStream(devices::Device& device) {
    device.stopStream();
    if (m_live.signals.empty() || isVirtual() || m_lost) {
        return;
    }
    const Result<void> started = device.startStream(m_live, displaySink(device.clock().now_s(), {}));
    if (!started) {
        m_events.onStreamRefused(started.error());
    }
}

devices::BlockSink Connection::displaySink(double start_s, devices::BlockSink then) {
    return [this, start_s, then = std::move(then)](SampleBlockPtr block) {
        m_events.onBlock(shifted(block, start_s));
        if (then) {
            then(std::move(block));
        }
    };
}

void Connection::report(devices::Device& device, bool isForced) {
    const Clock::time_point wall = Clock::now();
    const devices::DeviceState board = device.state();
    if (!isForced && !isDifferent(board, m_reported) && wall - m_lastReport < ReportPeriod) {
        return;
    }
    m_lastReport = wall;
    m_reported = board;
    m_events.onReport({board, device.statistics(), device.clock().now_s(), m_lost, m_isStoppedForSilence});
}

} // namespace halbench::app
