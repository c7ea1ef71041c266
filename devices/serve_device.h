#pragma once

#include "control/base/result.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace halbench::devices {

/// What `halbench serve` was asked for.
struct ServeRequest {
    std::string device;                ///< `sim:htm?...`
    std::string address;               ///< HOST:PORT; port 0 picks one
    std::optional<std::uint64_t> seed; ///< wins over `?seed=`
};

/// Serves a simulated board to other XCP tools over TCP, paced by the wall clock, until the flag is set.
/// `onListening` gets "tcp:127.0.0.1:PORT" once, when connections are accepted.
/// Errors: InvalidInput, UnknownName, OutOfRange (device, address), DeviceLost.
Result<void> serveTcp(const ServeRequest& request, const std::function<void(const std::string&)>& onListening,
                      const std::atomic<int>& interruptSignal);

} // namespace halbench::devices
