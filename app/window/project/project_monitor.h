#pragma once

#include "app/window/project/project_reader.h"
#include "app/workspaces/monitor/monitor_view.h"

#include <toml++/toml.h>

#include <vector>

namespace halbench::app {

/// `[monitor]` of a project.
toml::table projectMonitor(const MonitorView& view);
void readMonitor(ProjectReader& reader, const ConfigNode& node, MonitorView& view);

/// `[monitor2]` and the like, with their plots.
toml::table projectFurtherMonitor(const MonitorView& view);
void readFurtherMonitor(ProjectReader& reader, const ConfigNode& node, MonitorView& view);

/// `[[derived]]`.
toml::array projectDerived(const std::vector<devices::DerivedSignal>& list);
void readDerived(ProjectReader& reader, const ConfigNode& node, std::vector<devices::DerivedSignal>& list);

/// `[[cursors]]`.
toml::array projectCursors(const std::vector<CursorChoice>& list);
void readCursors(ProjectReader& reader, const ConfigNode& node, std::vector<CursorChoice>& list);

} // namespace halbench::app
