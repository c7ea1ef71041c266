#pragma once

#include "app/window/project/project_reader.h"
#include "app/workbench/recording_choice.h"

#include <toml++/toml.h>

namespace halbench::app {

/// `[recording]` of a project.
toml::table projectRecording(const RecordingChoice& choice);
void readRecording(ProjectReader& reader, const ConfigNode& node, RecordingChoice& choice);

} // namespace halbench::app
