#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/frequency/axes_frequency.h"

#include <string>

namespace halbench::app {

/// halbench.axis-frequency/1 (resources/help/command-line.md, "Results")
inline constexpr const char* AxisFrequencySchema = "halbench.axis-frequency/1";
JsonValue axesFrequencyDocument(ResultHeader header, const AxesFrequencyResult& result);
/// The same without the header.
JsonValue axesFrequencyBody(const AxesFrequencyResult& result);

/// The points as a table (CSV; resources/help/command-line.md, "Frequency response", --bode).
std::string axesFrequencyTable(const AxesFrequencyResult& result);

} // namespace halbench::app
