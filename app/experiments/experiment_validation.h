#pragma once

#include "app/documents/text/config_node.h"

namespace halbench::app {

/// Judges a whole experiment by the table of keys: unknown and missing keys, types, ranges, choices, names of
/// steps that are used before they ran, checks without a limit. Error: InvalidInput with origin, line, column
/// and what is allowed.
Result<void> validateExperiment(const ConfigNode& root);

} // namespace halbench::app
