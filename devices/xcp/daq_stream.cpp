#include "devices/xcp/daq_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::devices::xcp {

namespace {

/// Time that is allowed beside the period of the board and the round trip: the longest wait between two
/// looks.
constexpr double PumpAllowance_s = 0.05;
constexpr double MaxSilence_s = 1.8;
constexpr std::size_t OctetsBeforeValues = 8; ///< longest identification and time stamp (3.8)

} // namespace

DaqStream::DaqStream(XcpMaster& master, XcpLink& link, const BoardDescription& board, MessageSink onMessage)
    : m_master(&master), m_link(&link), m_board(&board), m_onMessage(std::move(onMessage)) {}

Result<void> DaqStream::start(const DaqAbility& ability, const StreamRequest& request, BlockSink sink) {
    stop();
    Result<SamplingPlan> sampling = planSampling(*m_board, ability, request);
    if (!sampling) {
        return failure(sampling.error());
    }
    Result<DaqPlan> plan = planDaqList(sampling->entries, ability.format);
    if (!plan) {
        return failure(plan.error());
    }
    remarkOn(*sampling, *plan);
    const Result<std::uint8_t> firstPid = m_master->configureList(
        {&sampling->entries, &*plan, sampling->event, sampling->prescaler, ability.hasTimestamp});
    if (!firstPid) {
        return failure(firstPid.error());
    }
    DtoDecoder decoder(ability.format, sampling->entries, *std::move(plan), 0, *firstPid);
    m_sink = std::move(sink);
    m_stream = std::make_unique<StreamAssembler>(*std::move(sampling), ability, std::move(decoder));
    m_started_s = now_s();
    m_stream->noteStart(m_started_s);
    Result<void> started = m_master->startList();
    if (!started) {
        stop();
    }
    return started;
}

void DaqStream::feed(Octets packet) {
    if (!m_stream) {
        return;
    }
    const std::uint64_t restarts = m_stream->clockRestarts();
    m_stream->feed(packet, now_s(), m_link->transport().statistics().packetsLost);
    if (m_stream->clockRestarts() != restarts) {
        m_onMessage("the device clock restarted: the recording has a gap, measured with the computer clock");
    }
}

/// Before the first sample can be lost.
void DaqStream::remarkOn(const SamplingPlan& sampling, const DaqPlan& plan) const {
    std::size_t octets = plan.size() * OctetsBeforeValues;
    for (const DaqEntry& entry : sampling.entries) {
        octets += sizeOf(entry.type);
    }
    const auto packets = static_cast<double>(plan.size());
    const std::optional<std::string> remark = m_link->transport().remarkOnStream(
        packets / sampling.boardPeriod_s, octets / std::max<std::size_t>(plan.size(), 1));
    if (remark) {
        m_onMessage(*remark);
    }
}

void DaqStream::stop() noexcept {
    if (!m_stream) {
        return;
    }
    if (!m_link->lost()) {
        (void)m_master->stopLists();
    }
    m_dropped += m_stream->dropped();
    m_incomplete += m_stream->incomplete();
    m_stream.reset();
    m_sink = nullptr;
}

void DaqStream::finish() {
    if (m_stream) {
        m_stream->finish();
    }
}

std::uint64_t DaqStream::dropped() const {
    return m_dropped + (m_stream ? m_stream->dropped() : 0);
}

std::uint64_t DaqStream::incomplete() const {
    return m_incomplete + (m_stream ? m_stream->incomplete() : 0);
}

Result<void> DaqStream::checkHeartbeat() {
    if (!m_stream) {
        return {};
    }
    const double last_s = std::max(m_stream->lastArrival_s(), m_started_s);
    const double allowed_s = 3.0 * m_stream->boardPeriod_s() + m_link->roundTripMedian_s() + PumpAllowance_s;
    const double silence_s = now_s() - last_s;
    if (silence_s <= allowed_s) {
        return {};
    }
    const Result<StatusResponse> status = m_master->status();
    if (!status) {
        return failure(status.error());
    }
    const bool isAlive = status->isDaqRunning() && silence_s <= allowed_s + MaxSilence_s;
    if (isAlive) {
        return {};
    }
    m_link->markLost({ErrorCode::DeviceLost,
                      fmt::format("{} stopped sending samples", m_link->transport().description()),
                      "the device or another program ended the stream; connect again"});
    return failure(*m_link->lost());
}

void DaqStream::deliverBlocks() {
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
