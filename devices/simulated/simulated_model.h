#pragma once

#include "control/base/result.h"
#include "devices/simulated/simulated_board.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// KEY and VALUE of a device address, as written.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// One key of an address: its number in `unit`, from `min` to `max`.
struct OverrideSpec {
    std::string key;
    std::string unit; ///< of the value as written
    double min = 0.0;
    double max = 0.0;
    std::optional<double> standard;        ///< nothing: drawn from the seed
    std::string meaning;                   ///< a few words
    std::vector<std::string> choices = {}; ///< of a key that takes words
    bool isText = false;                   ///< takes any text, e.g. the name of a file
};

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
    std::vector<OverrideSpec> keys = {}; ///< those of `overrides` with ranges; empty: the device has no table
};

} // namespace halbench::devices
