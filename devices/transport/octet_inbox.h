#pragma once

#include "control/base/result.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace halbench::devices {

/// Octets on their way from a port's own thread to the connection's. Thread: any; one takes.
class OctetInbox {
public:
    /// More than this waiting means that nobody reads: the connection ends, with what waits still delivered.
    /// A stream without a hole is the only one whose next message is known.
    static constexpr std::size_t MaxWaiting = std::size_t{8} << 20;

    void put(std::span<const std::uint8_t> octets);
    /// The port cannot go on; the first error stays. What arrived before is still delivered.
    void fail(Error error);
    /// Forgets everything, the error included.
    void clear();

    /// Waits at most `timeout_s` and swaps what arrived into `octets`, whose storage is used again. False
    /// when nothing came. Error: what fail() said, once everything before it was taken.
    Result<bool> take(std::vector<std::uint8_t>& octets, double timeout_s);
    std::uint64_t received() const;

private:
    void keepFirst(Error error);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<std::uint8_t> m_waiting;
    std::optional<Error> m_error;
    std::uint64_t m_received = 0;
};

} // namespace halbench::devices
