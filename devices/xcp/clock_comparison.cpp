#include "devices/xcp/clock_comparison.h"

namespace halbench::devices::xcp {

namespace {

/// GET_DAQ_CLOCK tells 32 bits; a clock with fewer in its time stamps turns over earlier.
constexpr std::size_t ClockOctets = 4;
constexpr double Period_s = 1.0;

} // namespace

void ClockComparison::begin(const DaqAbility& ability) {
    if (ability.format.timestampSize == ClockOctets) {
        m_tick_s = ability.tick_s;
        m_boardClock.emplace(ClockOctets, m_tick_s);
    }
}

Result<void> ClockComparison::compare(XcpMaster& master, const XcpLink& link) {
    m_next_s = link.transport().now_s() + Period_s;
    const Result<std::optional<std::uint32_t>> ticks = master.clockTicks();
    if (!ticks) {
        return failure(ticks.error());
    }
    if (!*ticks) {
        m_boardClock.reset();
        return {};
    }
    const XcpLink::Exchange& exchange = link.lastExchange();
    const auto passed = static_cast<double>(m_boardClock->unwrap(**ticks, exchange.answered_s));
    m_fit.add(exchange.sent_s, exchange.answered_s, passed * m_tick_s);
    return {};
}

} // namespace halbench::devices::xcp
