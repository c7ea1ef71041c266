#include "devices/acquisition/known_signals.h"

#include <algorithm>
#include <array>

namespace halbench::devices {

namespace {

constexpr std::array KnownSignals = {
    KnownSignal{"position", "rad"},
    KnownSignal{"speed", "rad/s"},
    KnownSignal{"reference", "rad"},
    KnownSignal{"current_command", "A"},
    KnownSignal{"current.a", "A"},
    KnownSignal{"current.b", "A"},
    KnownSignal{"hall.a", "T"},
    KnownSignal{"hall.b", "T"},
    KnownSignal{"coil_temperature.a", "degC"},
    KnownSignal{"coil_temperature.b", "degC"},
    KnownSignal{"truth.position", "rad"},
    KnownSignal{"truth.speed", "rad/s"},
    KnownSignal{"status", ""},
    KnownSignal{"fault", ""},
    KnownSignal{"torn_count", ""},
    KnownSignal{"reference.segment", ""},
    KnownSignal{"reference.running", ""},
};

} // namespace

std::span<const KnownSignal> knownSignals() {
    return KnownSignals;
}

std::optional<std::string> unitOfKnownSignal(const std::string& name) {
    const auto known = std::find_if(KnownSignals.begin(), KnownSignals.end(),
                                    [&](const KnownSignal& signal) { return signal.name == name; });
    return known == KnownSignals.end() ? std::nullopt : std::optional(std::string(known->unit));
}

} // namespace halbench::devices
