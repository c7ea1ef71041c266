#pragma once

#include "devices/xcp/clock_fit.h"
#include "devices/xcp/daq_list.h"
#include "devices/xcp/xcp_master.h"

#include <optional>

namespace halbench::devices::xcp {

/// The drift of the board's clock, from a reading once a second between two of the host's
/// (resources/help/protocol.md, 3.9). Thread: the connection's.
class ClockComparison {
public:
    /// From now on, unless the board has no clock of 32 bits.
    void begin(const DaqAbility& ability);
    bool isDue(double now_s) const { return m_boardClock && now_s >= m_next_s; }
    /// Ends for good when the board does not tell its clock.
    Result<void> compare(XcpMaster& master, const XcpLink& link);
    std::optional<ClockDrift> drift() const { return m_fit.drift(); }

private:
    std::optional<TickUnwrapper> m_boardClock; ///< absent: not asked for
    double m_tick_s = 0.0;
    double m_next_s = 0.0;
    ClockFit m_fit;
};

} // namespace halbench::devices::xcp
