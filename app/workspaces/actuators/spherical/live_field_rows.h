#pragma once

#include "app/workbench/played_recording.h"
#include "app/workbench/workbench.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Signals of the device that rows for estimators are made of: nine fields, and where it has them the coil's
/// current and the true angles of a simulation.
std::vector<std::string> liveFieldSignals(const devices::Catalogue& catalogue);

/// The rows of the last seconds in which all of these have a value, as a recording whose columns have the
/// usual names. True angles and current are columns only where they were streamed.
devices::RecordedFile liveFieldRows(Workbench& bench, double length_s);

} // namespace halbench::app
