#pragma once

#include "app/session/device_session.h"

#include <functional>
#include <string>
#include <vector>

namespace halbench::app {

using DeviceValues = Result<std::vector<double>>;

/// Reads parameters some at a time, so that a stop need not wait for all of them. `then` gets the values in
/// the order of the names, or the first error. Thread: GUI.
void readInPieces(DeviceSession& session, const std::vector<std::string>& names,
                  const std::function<void(const DeviceValues&)>& then);

} // namespace halbench::app
