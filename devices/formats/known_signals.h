#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace halbench::devices {

/// A signal by whose name procedures find what they work with.
struct KnownSignal {
    std::string_view name;
    std::string_view unit;
};

/// Those of every board of ours: resources/help/command-line.md, "Signals and parameters of htm". A table of
/// another program that uses one of these names must mean the same quantity.
std::span<const KnownSignal> knownSignals();

/// "temp", "Motor temperature": what is hardly an angle when it is in "deg".
bool isTemperatureName(std::string_view name);

/// Nothing for any other name.
std::optional<std::string> unitOfKnownSignal(const std::string& name);

} // namespace halbench::devices
