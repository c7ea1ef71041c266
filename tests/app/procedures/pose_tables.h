#pragma once

#include "app/procedures/excite/pose_table.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace halbench::app {

/// A table as its file would be read, which is a matter of app/documents: cells between commas, in mm, m,
/// mrad and s.
inline PoseTable poseTable(const std::string& text) {
    static const std::map<std::string, std::pair<std::string, double>> units = {
        {"mm", {"m", 1e-3}}, {"m", {"m", 1.0}}, {"mrad", {"rad", 1e-3}}, {"s", {"s", 1.0}}};
    PoseTable table;
    table.origin = "p.csv";
    std::vector<double> factors;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        std::istringstream cells(line);
        std::string cell;
        std::vector<double> row;
        for (std::size_t column = 0, place = 1; std::getline(cells, cell, ','); ++column) {
            if (number == 1) {
                const std::size_t mark = cell.rfind('_');
                const auto& [unit, factor] = units.at(cell.substr(mark + 1));
                factors.push_back(factor);
                if (unit != "s") {
                    table.columns.push_back({cell.substr(0, mark), unit, cell, place});
                }
            } else {
                row.push_back(std::stod(cell) * factors.at(column));
            }
            place += cell.size() + 1;
        }
        if (!row.empty()) {
            const bool hasTime = factors.size() > table.columns.size();
            if (hasTime) {
                table.time_s.push_back(row.front());
            }
            table.rows.emplace_back(row.begin() + (hasTime ? 1 : 0), row.end());
            table.lines.push_back(number);
        }
    }
    return table;
}

} // namespace halbench::app
