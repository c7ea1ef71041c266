#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/frequency/measured_loop.h"

#include <string>

namespace halbench::app {

/// Measured plant and header of RESPONSE.json (halbench.frequency/1).
struct FrequencyFile {
    ResultHeader header;
    MeasuredPlant plant;
};

/// Errors: FileSystem; InvalidInput with the place; Refused for a result that was refused.
Result<FrequencyFile> readFrequencyFile(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<FrequencyFile> parseFrequency(const std::string& text, const std::string& origin);

} // namespace halbench::app
