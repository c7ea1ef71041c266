#pragma once

#include "app/window/project/project_reader.h"
#include "app/workspaces/monitor/monitor_view.h"

#include <toml++/toml.h>

namespace halbench::app {

/// `units` of a `[[plot]]`: the signals that are shown in a unit of their own.
toml::table projectUnits(const PlotChoice& plot);
/// Reads the table; the plot's signals are known by then.
void readUnits(ProjectReader& reader, const ConfigNode& node, PlotChoice& plot);

} // namespace halbench::app
