#pragma once

#include <string>

namespace halbench::devices {

/// The udev rules that let a user open boards without being root (resources/system/70-halbench.rules).
std::string udevRules();
/// The entry for the desktop's menu that starts this very program (resources/system/halbench.desktop).
std::string desktopFile();

} // namespace halbench::devices
