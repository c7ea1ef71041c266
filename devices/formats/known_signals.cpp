#include "devices/formats/known_signals.h"

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

bool isTemperatureName(std::string_view name) {
    std::string lowered(name);
    std::transform(lowered.begin(), lowered.end(), lowered.begin(), [](char character) {
        return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
    });
    const auto has = [&lowered](const char* word) { return lowered.find(word) != std::string::npos; };
    const bool isTemp = lowered == "temp" || lowered.starts_with("temp_") || lowered.starts_with("temp.") ||
                        lowered.ends_with("temp");
    return isTemp || has("temperat") || has("_temp_") || has(".temp.");
}

std::optional<std::string> unitOfKnownSignal(const std::string& name) {
    const auto known = std::find_if(KnownSignals.begin(), KnownSignals.end(),
                                    [&](const KnownSignal& signal) { return signal.name == name; });
    return known == KnownSignals.end() ? std::nullopt : std::optional(std::string(known->unit));
}

} // namespace halbench::devices
