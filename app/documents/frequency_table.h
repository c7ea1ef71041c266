#pragma once

#include "app/procedures/frequency/frequency_procedure.h"

#include <string>

namespace halbench::app {

/// The points as a table (CSV; resources/help/command-line.md, "Frequency response", --bode).
std::string frequencyTable(const FrequencyResult& result);

} // namespace halbench::app
