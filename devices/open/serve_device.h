#pragma once

#include "control/base/result.h"
#include "devices/transport/faulty_line.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace halbench::devices {

enum class ServedLine { Tcp, Udp, Pty };

/// What `halbench serve` was asked for.
struct ServeRequest {
    std::string device; ///< `sim:htm?...`
    ServedLine line = ServedLine::Tcp;
    std::string address;               ///< HOST:PORT or PORT, port 0 picks one; not for a pseudo terminal
    std::optional<std::uint64_t> seed; ///< wins over `?seed=`; also of the faults
    LineFaults faults{};
    SxiProfile profile{}; ///< of a pseudo terminal
};

/// Told once, when masters are answered: "tcp:127.0.0.1:PORT", "udp:127.0.0.1:PORT" or "pty:/dev/pts/N", and
/// whether other machines reach that.
using ListeningHook = std::function<void(const std::string& address, bool isOpenToNetwork)>;

/// Serves a simulated board to other XCP tools, paced by the wall clock, until the flag is set. Gives what
/// was made to go wrong. Errors: InvalidInput, UnknownName, NotFinite, OutOfRange (device, address, faults),
/// DeviceLost.
Result<LineTraffic> serveDevice(const ServeRequest& request, const ListeningHook& onListening,
                                const std::atomic<int>& interruptSignal);

} // namespace halbench::devices
