#pragma once

#include "control/base/parameter_spec.h"
#include "control/base/result.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A shipped parameter set of one model: resources/presets/<model>/<name>.json, compiled in.
struct Preset {
    std::string model;
    std::string name;
    std::string title;
    std::string source; ///< where its numbers come from
    std::vector<ParameterValue> values;
};

/// Names of the shipped presets, of any model: the published one first, the others by name.
std::vector<std::string> presetNames();

/// Errors: UnknownName; InvalidInput when the shipped file is damaged.
Result<Preset> findPreset(const std::string& model, const std::string& name);

/// Errors: InvalidInput naming origin and key.
Result<Preset> parsePreset(const std::string& text, const std::string& origin);

} // namespace halbench::app
