#pragma once

#include "devices/device.h"
#include "devices/device_options.h"

#include <memory>
#include <string>
#include <vector>

namespace halbench::devices {

/// The user's folder for descriptions, e.g. ~/.cache/halbench/boards (XDG_CACHE_HOME).
std::string userCacheFolder();

/// Opens any device by its address and reads its catalogue.
/// Errors: InvalidInput, UnknownName, OutOfRange (address), DeviceLost, Protocol.
Result<std::unique_ptr<Device>> openDevice(const std::string& uri, const OpenOptions& options);

/// Those that are always there: the simulated ones. At once, also for the window's thread.
std::vector<DeviceListing> listBuiltInDevices();

/// Simulated devices and the ports that are plugged in; opens none of them. Not for the window's thread: it
/// reads many small files of the system.
std::vector<DeviceListing> listDevices();

} // namespace halbench::devices
