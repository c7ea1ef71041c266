#pragma once

#include <string>

namespace halbench::devices {

/// Title of the simulated actuator of an address, "Two-phase Halbach-cylinder motor" of "sim:htm?seed=7";
/// empty for another device.
std::string simulatedTitle(const std::string& address);

} // namespace halbench::devices
