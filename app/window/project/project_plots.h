#pragma once

#include "app/window/project/project_reader.h"
#include "app/workspaces/monitor/monitor_view.h"

#include <toml++/toml.h>

#include <vector>

namespace halbench::app {

/// `[[plot]]` of a project. Which column a plot is in, its share of the room and the units of its signals are
/// as usual where the file says what cannot be (ProjectReader::reset()).
toml::array projectPlots(const std::vector<PlotChoice>& list);
void readPlots(ProjectReader& reader, const ConfigNode& node, std::vector<PlotChoice>& plots);

} // namespace halbench::app
