#pragma once

#include <string>
#include <vector>

namespace halbench::app {

/// Whether these arguments ask for the window: none, or only those of the window.
bool isWindowCall(const std::vector<std::string>& arguments);

/// Opens the workstation: `halbench [--project FILE] [--connect DEVICE]`. Gives the exit code; 2 with one
/// line on stderr without a display or with an option that makes no sense.
int runWindow(const std::vector<std::string>& arguments);

} // namespace halbench::app
