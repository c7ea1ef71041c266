#pragma once

#include "control/signals/pose_motion.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// A table of poses as a file holds it (resources/help/command-line.md, "Paths from a table"): a column an
/// axis, called AXIS_UNIT, and perhaps time_s. Values in SI; which axes a device has is checked later.
struct PoseTable {
    struct Column {
        std::string axis;      ///< "x"
        std::string unit;      ///< "m" or "rad", as of devices::AxisSpec
        std::string name;      ///< "x_mm", as it is written
        std::size_t place = 1; ///< of its name in the line, from 1
    };
    std::string origin; ///< file, for messages
    std::size_t headerLine = 1;
    std::vector<Column> columns;
    std::vector<double> time_s; ///< of each row; empty: the table has no times
    control::PoseRows rows;
    std::vector<std::size_t> lines; ///< in the file, of each row

    std::optional<std::size_t> columnOf(std::string_view axis) const;
    /// "poses.csv:4", of a row from 0.
    std::string placeOf(std::size_t row) const;
};

} // namespace halbench::app
