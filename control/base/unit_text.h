#pragma once

#include <string>
#include <string_view>

namespace halbench {

/// A unit symbol as people write it: "N*m*s/rad" -> "N·m·s/rad", "kg*m^2" -> "kg·m²", "degC" -> "°C",
/// "A/deg" -> "A/°", "A/sqrt(Hz)" -> "A/√Hz". Only for showing; files and metadata keep the symbol.
std::string unitText(std::string_view symbol);

} // namespace halbench
