#pragma once

#include "devices/device.h"

#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// The known word that is fewest edits away, empty when none is near: "did you mean".
std::string nearestName(std::string_view wrong, const std::vector<std::string>& known);

/// UnknownName for a signal or parameter that the device does not have, with the nearest name.
Error unknownName(const devices::Catalogue& catalogue, const std::string& name);

/// "A,B" into its parts; spaces around a part are dropped, an empty text has none.
std::vector<std::string> splitList(std::string_view text, char separator = ',');

} // namespace halbench::app
