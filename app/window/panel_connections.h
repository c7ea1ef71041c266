#pragma once

#include "app/workbench/workbench.h"

namespace halbench::app {

class DockLayout;

/// How one task hands over to the next: from an identified motor to its gains, from no motor to identifying
/// one; and the window's file dialogs for the panels that save.
void connectPanelConnections(DockLayout& docks, Workbench& bench);

} // namespace halbench::app
