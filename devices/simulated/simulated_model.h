#pragma once

#include "control/base/result.h"
#include "devices/simulated/simulated_board.h"

#include <deque>
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

/// Every simulated device of the program, one row per actuator, in the order of lists.
const std::deque<SimulatedModel>& simulatedModels();

/// Adds a row, for tests: before the first device is opened, since the table is not guarded. A row of the
/// same name is replaced.
void addSimulatedModel(SimulatedModel model);

/// nullptr if there is none.
const SimulatedModel* findSimulatedModel(const std::string& name);

} // namespace halbench::devices
