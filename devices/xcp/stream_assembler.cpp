#include "devices/xcp/stream_assembler.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr double BlockDuration_s = 0.010;
// No sample is from the future: a board's clock does not run further ahead of the host's than this.
constexpr double MaxClockRatio = 1.05;
constexpr double MaxClockLead_s = 1.0;
// So many rows that follow each other somewhere else are a clock that started again, not a spoiled stamp.
constexpr std::size_t RestartRows = 4;
constexpr double NextRow_ratio = 2.5;   // of the period: rows of which the second follows the first
constexpr double LongestDoubt_s = 0.25; // so long a shift is looked at to tell a loss from late stamps

std::size_t lookAheadAt(double period_s) {
    const double rows =
        std::clamp(std::floor(LongestDoubt_s / period_s), 1.0, static_cast<double>(RowGrid::LookAhead));
    return static_cast<std::size_t>(rows);
}

} // namespace

StreamAssembler::StreamAssembler(SamplingPlan plan, const DaqAbility& ability, DtoDecoder decoder)
    : m_plan(std::move(plan)), m_ability(ability), m_decoder(std::move(decoder)),
      m_rowsPerBlock(std::max(1.0, std::round(BlockDuration_s / m_plan.layout->period_s))),
      m_grid(m_plan.boardPeriod_s), m_lookAhead(lookAheadAt(m_plan.boardPeriod_s)) {
    if (ability.format.timestampSize != 0) {
        m_unwrapper.emplace(ability.format.timestampSize, ability.tick_s);
    }
}

void StreamAssembler::feed(Octets packet, double arrival_s, std::uint64_t packetsLost) {
    if (!m_decoder.feed(packet)) {
        return;
    }
    m_lastArrival_s = arrival_s;
    const std::uint64_t lost = packetsLost - std::min(m_packetsLost.value_or(packetsLost), packetsLost);
    m_packetsLost = packetsLost;
    m_isLossSure = lost > 0;
    if (!m_unwrapper) {
        // Without a clock the rows are placed by what the transport counted.
        const std::uint64_t perRow = m_decoder.packetsPerRow();
        const std::uint64_t missing = (lost + perRow - 1) / perRow;
        const auto index = static_cast<double>(m_nextIndex + static_cast<std::int64_t>(missing));
        placeRow({index * m_plan.boardPeriod_s, arrival_s, m_decoder.row()}, missing);
        return;
    }
    const auto ticks = static_cast<double>(m_unwrapper->unwrap(m_decoder.timestamp(), arrival_s));
    // Dividing by a whole number of ticks gives the double next to the decimal time.
    addRow(m_ability.ticksPerSecond > 0.0 ? ticks / m_ability.ticksPerSecond : ticks * m_ability.tick_s,
           arrival_s);
}

bool StreamAssembler::isPlausible(double time_s, double arrival_s) const {
    return !m_lastTime_s ||
           (time_s > *m_lastTime_s && time_s <= MaxClockRatio * (arrival_s - *m_origin_s) + MaxClockLead_s);
}

void StreamAssembler::addRow(double clock_s, double arrival_s) {
    const double time_s = clock_s + m_clockShift_s;
    if (!m_origin_s) {
        m_origin_s = arrival_s;
    }
    if (!isPlausible(time_s, arrival_s)) {
        addStray(time_s, arrival_s);
        return;
    }
    m_strays.clear();
    // Many packets may be read at one moment, long after they came: the origin is that of the quickest. A row
    // ahead of a gap tells nothing, its stamp may be wrong.
    if (m_lastTime_s && time_s - *m_lastTime_s < NextRow_ratio * m_plan.boardPeriod_s) {
        m_origin_s = std::min(*m_origin_s, arrival_s - time_s);
        m_earliest_s = std::min(m_earliest_s, arrival_s - time_s);
        m_latest_s = std::max(m_latest_s, arrival_s - time_s);
    }
    takeRow({time_s, arrival_s, m_decoder.row()}, m_isLossSure);
}

void StreamAssembler::addStray(double time_s, double arrival_s) {
    ++m_misplaced;
    const double step_s = m_strays.empty() ? 0.0 : time_s - m_strays.back().time_s;
    if (step_s <= 0.0 || step_s > NextRow_ratio * m_plan.boardPeriod_s) {
        m_strays.clear();
    }
    m_strays.push_back({time_s, arrival_s, m_decoder.row()});
    if (m_strays.size() == RestartRows) {
        restartClock();
    }
}

/// The rows that stand together elsewhere go on behind the last one, after a gap.
void StreamAssembler::restartClock() {
    settle(true);
    const double period_s = m_plan.boardPeriod_s;
    double arrival_s = m_strays.front().arrival_s;
    for (const StoredRow& stray : m_strays) {
        arrival_s = std::min(arrival_s, stray.arrival_s - (stray.time_s - m_strays.front().time_s));
    }
    // Rows that were read late for other reasons, many at one moment, are no gap.
    const double pause_s = arrival_s - m_lastRowArrival_s - std::max(0.0, m_latest_s - m_earliest_s);
    const double missing = std::max(0.0, std::round(pause_s / period_s) - 1.0);
    m_isBreak = true;
    const double shift_s = *m_lastTime_s + (missing + 1.0) * period_s - m_strays.front().time_s;
    m_clockShift_s += shift_s;
    m_misplaced -= m_strays.size();
    ++m_clockRestarts;
    for (StoredRow& stray : std::exchange(m_strays, {})) {
        takeRow({stray.time_s + shift_s, stray.arrival_s, stray.values}, true);
    }
}

/// `isLossSure`: a long step is no late stamp.
void StreamAssembler::takeRow(const Row& row, bool isLossSure) {
    m_lastTime_s = row.time_s;
    m_lastRowArrival_s = row.arrival_s;
    if (m_waiting.empty() && (isLossSure || !m_grid.isInDoubt({&row.time_s, 1}, m_lookAhead))) {
        placeRow(row, m_grid.missingBefore({&row.time_s, 1}, isLossSure));
        return;
    }
    if (isLossSure) {
        settle(true); // what is behind the loss tells nothing of the rows before it
        placeRow(row, m_grid.missingBefore({&row.time_s, 1}, true));
        return;
    }
    m_waiting.push_back({row.time_s, row.arrival_s, {row.values.begin(), row.values.end()}});
    settle(false);
}

/// Places the waiting rows of which it is known what is missing before them; at the end of a stretch all.
void StreamAssembler::settle(bool isEnd) {
    std::vector<double> times_s;
    for (const StoredRow& row : m_waiting) {
        times_s.push_back(row.time_s);
    }
    std::span<const double> next_s(times_s);
    while (!m_waiting.empty() && (isEnd || !m_grid.isInDoubt(next_s, m_lookAhead))) {
        const StoredRow& first = m_waiting.front();
        placeRow({first.time_s, first.arrival_s, first.values}, m_grid.missingBefore(next_s));
        m_waiting.pop_front();
        next_s = next_s.subspan(1);
    }
}

void StreamAssembler::placeRow(const Row& row, std::uint64_t missing) {
    m_grid.take(row.time_s, missing);
    const std::int64_t index = m_nextIndex + static_cast<std::int64_t>(missing);
    // Rows of the stream's rate between the last sample and this one.
    const std::int64_t divider = m_plan.hostDivider;
    m_lostBefore +=
        static_cast<std::uint64_t>((index + divider - 1) / divider - (m_nextIndex + divider - 1) / divider);
    m_nextIndex = index + 1;
    if (index % divider == 0) {
        storeRow(row);
    }
}

void StreamAssembler::storeRow(const Row& row) {
    if (m_lostBefore != 0 || m_isBreak) {
        closeBlock();
    }
    if (!m_open) {
        m_open = std::make_shared<SampleBlock>();
        m_open->layout = m_plan.layout;
        m_open->lostRows = std::exchange(m_lostBefore, 0);
        m_open->isBreak = std::exchange(m_isBreak, false);
    }
    m_open->time_s.push_back(row.time_s);
    m_open->values.insert(m_open->values.end(), row.values.begin(), row.values.end());
    m_open->hostArrival_s = row.arrival_s;
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
