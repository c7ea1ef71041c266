#pragma once

#include "devices/formats/csv_columns.h"

#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

// What the first lines of another program's table say of its columns.

/// "time", "t", "Zeit" ..., whatever its case.
bool isTimeName(const std::string& name);

/// Takes the unit as it is written, known or not.
void setUnit(CsvColumn& column, std::string_view written);

/// Names, units and the signals of ours that they mean; `units` is a row of its own, or empty.
std::vector<CsvColumn> readHeaders(const std::vector<std::string>& names,
                                   const std::vector<std::string>& units, std::size_t width);

} // namespace halbench::devices
