#include "devices/interruption.h"
#include "devices/xcp/xcp_device_impl.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr double Rounding_s = 1e-9;
/// Longest uninterrupted wait: how late a signal (Ctrl-C) may be noticed.
constexpr double MaxPump_s = 0.05;
constexpr double IdleStatusPeriod_s = 0.25;
constexpr double MaxSilence_s = 1.8;
constexpr double ClockPeriod_s = 1.0;
constexpr std::size_t OctetsBeforeValues = 8; ///< longest identification and time stamp (3.8)

} // namespace

Result<void> XcpDevice::startStream(const StreamRequest& request, BlockSink sink) {
    stopStream();
    if (!m_ability) {
        return failure(ErrorCode::DeviceRefused, "this device cannot stream signals",
                       "read single values instead");
    }
    Result<SamplingPlan> sampling = planSampling(m_board, *m_ability, request);
    if (!sampling) {
        return failure(sampling.error());
    }
    Result<DaqPlan> plan = planDaqList(sampling->entries, m_ability->format);
    if (!plan) {
        return failure(plan.error());
    }
    remarkOnStream(*sampling, *plan);
    const Result<std::uint8_t> firstPid = m_master.configureList(
        {&sampling->entries, &*plan, sampling->event, sampling->prescaler, m_ability->hasTimestamp});
    if (!firstPid) {
        return failure(firstPid.error());
    }
    DtoDecoder decoder(m_ability->format, sampling->entries, *std::move(plan), 0, *firstPid);
    m_sink = std::move(sink);
    m_stream = std::make_unique<StreamAssembler>(*std::move(sampling), *m_ability, std::move(decoder));
    m_streamStarted_s = now_s();
    m_stream->noteStart(m_streamStarted_s);
    Result<void> started = m_master.startList();
    if (!started) {
        stopStream();
    }
    return started;
}

void XcpDevice::feedStream(Octets packet) {
    const std::uint64_t restarts = m_stream->clockRestarts();
    m_stream->feed(packet, now_s(), m_link.transport().statistics().packetsLost);
    if (m_stream->clockRestarts() != restarts) {
        message("the device clock restarted: the recording has a gap, measured with the computer clock");
    }
}

/// Before the first sample can be lost.
void XcpDevice::remarkOnStream(const SamplingPlan& sampling, const DaqPlan& plan) const {
    std::size_t octets = plan.size() * OctetsBeforeValues;
    for (const DaqEntry& entry : sampling.entries) {
        octets += sizeOf(entry.type);
    }
    const auto packets = static_cast<double>(plan.size());
    const std::optional<std::string> remark = m_link.transport().remarkOnStream(
        packets / sampling.boardPeriod_s, octets / std::max<std::size_t>(plan.size(), 1));
    if (remark) {
        message(*remark);
    }
}

void XcpDevice::stopStream() noexcept {
    if (!m_stream) {
        return;
    }
    if (!m_link.lost()) {
        (void)m_master.stopLists();
    }
    m_droppedSamples += m_stream->dropped();
    m_incompleteSamples += m_stream->incomplete();
    m_stream.reset();
    m_sink = nullptr;
    if (m_options.measuresClock) {
        reportLink();
    }
}

Result<void> XcpDevice::waitFor(double duration_s) {
    const double end_s = now_s() + std::max(duration_s, 0.0);
    Result<void> result;
    do {
        result = checkWhileWaiting();
        const double left_s = end_s - now_s();
        if (!result || left_s <= Rounding_s) {
            break;
        }
        const Result<bool> pumped = m_link.pumpOnce(std::min({left_s, m_nextStatus_s - now_s(), MaxPump_s}));
        if (!pumped) {
            result = failure(pumped.error());
        } else if (m_stream && m_stream->isBlockDue()) {
            deliverBlocks();
        }
    } while (result);
    if (!result && m_link.lost()) {
        m_state.isConnected = false;
        if (m_stream) {
            m_stream->finish();
        }
    }
    deliverBlocks();
    return result;
}

Result<void> XcpDevice::checkWhileWaiting() {
    if (m_options.interruptSignal != nullptr) {
        const int signal = m_options.interruptSignal->load();
        if (signal != 0) {
            return failure(codeOfSignal(signal), "ended by " + signalName(signal), "");
        }
    }
    if (m_link.lost()) {
        return failure(*m_link.lost());
    }
    if (now_s() >= m_nextStatus_s || m_isStateStale) {
        if (Result<void> fed = feedWatchdog(); !fed) {
            return fed;
        }
    }
    const bool hasLatched = m_state.isStopLatched || m_state.fault != 0;
    if (m_expectsArmed && !m_state.isArmed && hasLatched) {
        return failure(safetyError());
    }
    if (m_stream && m_boardClock && now_s() >= m_nextClock_s) {
        if (Result<void> compared = compareClocks(); !compared) {
            return compared;
        }
    }
    return checkHeartbeat();
}

/// A reading of the board's clock between two of the host's (3.9).
Result<void> XcpDevice::compareClocks() {
    m_nextClock_s = now_s() + ClockPeriod_s;
    const Result<std::optional<std::uint32_t>> ticks = m_master.clockTicks();
    if (!ticks) {
        return failure(ticks.error());
    }
    if (!*ticks) {
        m_boardClock.reset();
        return {};
    }
    const XcpLink::Exchange& exchange = m_link.lastExchange();
    const auto passed = static_cast<double>(m_boardClock->unwrap(**ticks, exchange.answered_s));
    m_clockFit.add(exchange.sent_s, exchange.answered_s, passed * m_ability->tick_s);
    return {};
}

void XcpDevice::reportLink() const {
    const LinkStatistics link = statistics();
    std::string text =
        fmt::format("link: {} packets, {} lost, {} damaged, {} commands repeated, round trip "
                    "{:.2f} ms, at worst {:.2f} ms",
                    link.packetsReceived, link.packetsLost, link.packetsDamaged, link.commandsRepeated,
                    1e3 * link.roundTripMedian_s, 1e3 * link.roundTripWorst_s);
    if (link.clockDrift) {
        text += fmt::format(", the device clock is fast by {:.1f} +- {:.1f} ppm", link.clockDrift->drift_ppm,
                            link.clockDrift->uncertainty_ppm);
    }
    message(text);
}

/// Any command restarts the board's watchdog (3.11); reading the state tells at the same time of faults.
Result<void> XcpDevice::feedWatchdog() {
    const Result<StatusResponse> status = m_master.status();
    if (!status) {
        return failure(status.error());
    }
    m_nextStatus_s = now_s() + std::min(m_options.watchdog_s / 4.0, IdleStatusPeriod_s);
    return refreshState();
}

Result<void> XcpDevice::checkHeartbeat() {
    if (!m_stream) {
        return {};
    }
    const double last_s = std::max(m_stream->lastArrival_s(), m_streamStarted_s);
    const double allowed_s = 3.0 * m_stream->boardPeriod_s() + m_link.roundTripMedian_s() + MaxPump_s;
    const double silence_s = now_s() - last_s;
    if (silence_s <= allowed_s) {
        return {};
    }
    const Result<StatusResponse> status = m_master.status();
    if (!status) {
        return failure(status.error());
    }
    const bool isAlive = status->isDaqRunning() && silence_s <= allowed_s + MaxSilence_s;
    if (isAlive) {
        return {};
    }
    m_link.markLost({ErrorCode::DeviceLost,
                     fmt::format("{} stopped sending samples", m_link.transport().description()),
                     "the device or another program ended the stream; connect again"});
    return failure(*m_link.lost());
}

void XcpDevice::deliverBlocks() {
    if (!m_stream) {
        return;
    }
    for (const SampleBlockPtr& block : m_stream->takeBlocks()) {
        if (m_sink) {
            m_sink(block);
        }
    }
}

} // namespace halbench::devices::xcp
