#pragma once

#include "app/actuators/actuator.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The sweep of `identify`.
struct SweepOptions {
    std::vector<std::string> given; ///< NAME=VALUE
    std::string currentTolerance;   ///< --current-tolerance-percent PERCENT
    std::string currents;           ///< FROM:TO:STEP
    std::string directions;
    std::string bare;         ///< --bare MODEL.json
    std::string addedInertia; ///< --added-inertia KGM2
};

/// `identify --frequency`, besides --base-rad-s.
struct FrequencyOptions {
    std::string excitation, from, to, amplitude, periods, coherence;
    std::string effortRatio; ///< of several axes
    std::string bodeFile;
    std::string calibrationFile;
};

/// `identify --relay`, besides --base-rad-s.
struct RelayOptions {
    std::string model, gain, current, cycles;
};

/// `identify`: a sweep, a frequency response or the relay experiment.
struct IdentifyOptions {
    std::string device; ///< or FILE.csv
    std::string axis;
    std::string recordFile, out;
    std::string base; ///< --base-rad-s, of --frequency and --relay
    SweepOptions sweep;
    bool isFrequency = false;
    FrequencyOptions frequency;
    bool isRelay = false;
    RelayOptions relay;
};

/// The sweep, directions and given constants for the actuator that is identified. Errors: Usage, UnknownName,
/// NotFinite, OutOfRange, naming the option; FileSystem, InvalidInput of --bare.
Result<IdentifyConfig> identifyConfigFrom(const SweepOptions& options, const std::string& axis,
                                          const Actuator& actuator);

} // namespace halbench::app
