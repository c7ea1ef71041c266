#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices {

/// What a transport saw on the wire.
struct TransportStatistics {
    std::uint64_t packetsReceived = 0;
    std::uint64_t packetsSent = 0;
    std::uint64_t packetsLost = 0;    ///< gaps of the message counter
    std::uint64_t packetsLate = 0;    ///< of those, what came behind a later one and was dropped
    std::uint64_t packetsDamaged = 0; ///< bad length, bad checksum
    std::uint64_t octetsReceived = 0; ///< whatever they were; 0 on the loopback
};

/// Moves whole XCP packets and owns the time they are stamped with: the host's steady clock on hardware, the
/// simulation's clock on the loopback, where time passes only inside receive().
/// Thread: one, the connection's.
class Transport {
public:
    virtual ~Transport() = default;

    virtual Result<void> open() = 0;
    virtual void close() noexcept = 0;
    virtual Result<void> send(std::span<const std::uint8_t> packet) = 0;

    /// Waits at most `timeout_s` for one packet and puts it into `packet` (whose storage is reused).
    /// False when nothing came in time. Error: DeviceLost.
    virtual Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) = 0;

    virtual double now_s() const = 0;
    virtual TransportStatistics statistics() const = 0;
    /// "loopback", "tcp:127.0.0.1:5555" ...
    virtual std::string description() const = 0;

    /// How long a board may take to answer its first CONNECT.
    virtual double connectPatience_s() const { return 1.8; }
    /// What to say before a stream of so many packets of this size begins; nothing when all is well.
    virtual std::optional<std::string> remarkOnStream(double packets_Hz, std::size_t octets) const {
        (void)packets_Hz;
        (void)octets;
        return std::nullopt;
    }
    /// A line that has several ways to frame packets tries the next one.
    virtual void noteUnansweredConnect() {}
};

} // namespace halbench::devices
