#pragma once

#include "control/base/result.h"

#include <optional>
#include <string>

namespace halbench::devices {

/// Why a device node cannot be opened, and what to do about it.
struct PortTrouble {
    std::string reason; ///< "no permission", "busy: minicom (process 1234)", "not there"
    std::string hint;
};

/// Looks at a node without opening it: not there, or no permission.
std::optional<PortTrouble> troubleOf(const std::string& node);
/// Whether somebody sets up device nodes by rules here; not so in containers and on small systems.
bool isUdevRunning();
/// The node may not be opened by this user. Rules help only where somebody reads them.
PortTrouble permissionTrouble(const std::string& node, bool hasUdev = isUdevRunning());
/// Another program has the node; it is named when this user may know.
PortTrouble busyTrouble(const std::string& node);
/// The name of a process that has the node open and its number; nothing when none is seen.
std::optional<std::string> holderOf(const std::string& node);

/// DeviceLost in these words.
Error portError(const std::string& description, const PortTrouble& trouble);

} // namespace halbench::devices
