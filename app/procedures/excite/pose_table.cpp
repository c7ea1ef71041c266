#include "app/procedures/excite/pose_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

std::optional<std::size_t> PoseTable::columnOf(std::string_view axis) const {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [axis](const Column& column) { return column.axis == axis; });
    return found == columns.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

std::string PoseTable::placeOf(std::size_t row) const {
    return fmt::format("{}:{}", origin, lines[row]);
}

} // namespace halbench::app
