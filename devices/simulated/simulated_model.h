#pragma once

#include "control/base/result.h"
#include "devices/simulated/simulated_board.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// KEY and VALUE of a device address, as written.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// One simulated device that can be opened: `sim:NAME?KEY=VALUE&...`.
struct SimulatedModel {
    std::string name;      ///< of the address and of the profile, e.g. "htm"
    std::string title;     ///< of the device, for lists
    std::string overrides; ///< every key that `make` takes, and `seed`, for messages
    /// Errors: UnknownName (a key that does not exist), InvalidInput, NotFinite, OutOfRange.
    std::function<Result<void>(const Overrides&)> check;
    /// The board on a line. Overrides have passed `check`. Errors: OutOfRange (values that are possible alone
    /// and make no device together).
    std::function<Result<std::unique_ptr<SimulatedBoard>>(const Overrides&, std::uint64_t seed,
                                                          SimulatedBoard::Line line)>
        make;
};

} // namespace halbench::devices
