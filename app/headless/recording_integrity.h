#pragma once

#include "app/headless/command_context.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Finding of a result that rests on a recording which is not as it was recorded.
constexpr const char* RecordingIntegrityCode = "recording_changed";

/// `warnings` of a recording that was read (devices::RecordedFile), a line each.
void sayWarnings(const CommandContext& context, const std::vector<std::string>& warnings);

/// The same as findings: what was good is doubtful then.
void noteWarnings(DataQuality& quality, const std::vector<std::string>& warnings);

/// Adds findings and verdict of a result to those that are known; the worse verdict holds.
void addQuality(DataQuality& known, const DataQuality& result);

} // namespace halbench::app
