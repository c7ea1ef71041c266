#pragma once

#include <string>

namespace halbench::app {

/// Unit of a parameter of the position law or of a calibration by its name; empty for any other.
/// Source: resources/help/htm-theory.md section 8.4, resources/help/command-line.md.
std::string parameterUnit(const std::string& name);

} // namespace halbench::app
