#pragma once

#include "devices/device.h"

#include <deque>
#include <optional>

namespace halbench::devices::xcp {

/// Compares two clocks from readings of one that were asked for on the other (resources/help/protocol.md
/// 3.9). A reading holds for the middle of its round trip, within half of it; so only the fastest round
/// trips count: up to twice the shortest. The straight line
///
///     board - host = offset + drift * host
///
/// is fitted to them by least squares; the interval is Student's, from what is left over.
class ClockFit {
public:
    void add(double sent_s, double answered_s, double board_s);
    /// Nothing before six readings with fast round trips.
    std::optional<ClockDrift> drift() const;

private:
    struct Reading {
        double host_s;
        double difference_s; ///< board - host
        double roundTrip_s;
    };
    std::deque<Reading> m_readings;
};

} // namespace halbench::devices::xcp
