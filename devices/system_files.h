#pragma once

#include <string>

namespace halbench::devices {

/// The udev rules that let a user open boards without being root (resources/system/70-halbench.rules).
std::string udevRules();

} // namespace halbench::devices
