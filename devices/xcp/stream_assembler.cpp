#include "devices/xcp/stream_assembler.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr double BlockDuration_s = 0.010;
// No sample is from the future: a board's clock does not run further ahead of the host's than this.
constexpr double MaxClockRatio = 1.05;
constexpr double MaxClockLead_s = 1.0;
constexpr double MaxSteps = 1e15; // a gap beyond this is a broken clock; keeps the count a whole number

} // namespace

StreamAssembler::StreamAssembler(SamplingPlan plan, const DaqAbility& ability, DtoDecoder decoder)
    : m_plan(std::move(plan)), m_ability(ability), m_decoder(std::move(decoder)),
      m_rowsPerBlock(std::max(1.0, std::round(BlockDuration_s / m_plan.layout->period_s))) {
    if (ability.format.timestampSize != 0) {
        m_unwrapper.emplace(ability.format.timestampSize, ability.tick_s);
    }
}

void StreamAssembler::feed(Octets packet, double arrival_s) {
    if (!m_decoder.feed(packet)) {
        return;
    }
    m_lastArrival_s = arrival_s;
    if (!m_unwrapper) {
        addRow(static_cast<double>(m_nextIndex) * m_plan.boardPeriod_s, arrival_s);
        return;
    }
    const auto ticks = static_cast<double>(m_unwrapper->unwrap(m_decoder.timestamp(), arrival_s));
    // Dividing by a whole number of ticks gives the double next to the decimal time.
    addRow(m_ability.ticksPerSecond > 0.0 ? ticks / m_ability.ticksPerSecond : ticks * m_ability.tick_s,
           arrival_s);
}

void StreamAssembler::addRow(double time_s, double arrival_s) {
    const bool isFirst = m_nextIndex == 0;
    m_firstArrival_s = isFirst ? arrival_s : m_firstArrival_s;
    const double latest_s = MaxClockRatio * (arrival_s - m_firstArrival_s) + MaxClockLead_s;
    if (!isFirst && (time_s <= m_lastTime_s || time_s > latest_s)) {
        ++m_misplaced;
        return;
    }
    const double steps = isFirst ? 1.0 : std::round((time_s - m_lastTime_s) / m_plan.boardPeriod_s);
    const std::int64_t index = m_nextIndex + static_cast<std::int64_t>(std::clamp(steps, 1.0, MaxSteps)) - 1;
    // Rows of the stream's rate between the last sample and this one.
    const std::int64_t divider = m_plan.hostDivider;
    m_lostBefore +=
        static_cast<std::uint64_t>((index + divider - 1) / divider - (m_nextIndex + divider - 1) / divider);
    m_nextIndex = index + 1;
    m_lastTime_s = time_s;
    if (index % divider == 0) {
        storeRow(time_s, arrival_s);
    }
}

void StreamAssembler::storeRow(double time_s, double arrival_s) {
    if (m_lostBefore != 0) {
        closeBlock();
    }
    if (!m_open) {
        m_open = std::make_shared<SampleBlock>();
        m_open->layout = m_plan.layout;
        m_open->lostRows = std::exchange(m_lostBefore, 0);
    }
    m_open->time_s.push_back(time_s);
    m_open->values.insert(m_open->values.end(), m_decoder.row().begin(), m_decoder.row().end());
    m_open->hostArrival_s = arrival_s;
}

bool StreamAssembler::isBlockDue() const {
    return !m_ready.empty() || (m_open && static_cast<double>(m_open->rows()) >= m_rowsPerBlock);
}

void StreamAssembler::closeBlock() {
    if (m_open) {
        m_ready.push_back(std::move(m_open));
        m_open.reset();
    }
}

std::vector<SampleBlockPtr> StreamAssembler::takeBlocks() {
    closeBlock();
    return std::exchange(m_ready, {});
}

} // namespace halbench::devices::xcp
