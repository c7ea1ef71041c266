#pragma once

#include "models/spherical/coverage/difference_function.h"
#include "tests/models/spherical/orientation_cases.h"

#include <vector>

namespace halbench::models {

/// A row of the table of section 6 of resources/help/spherical-theory.md.
struct DifferenceRow {
    bool isAbsolute;
    DifferenceReduction reduction;
    double best;
    std::array<double, 3> where_deg; ///< one of the best placements, 999: any
    std::size_t ties;                ///< 0: not known
    double claimed;
    int rank; ///< 0: not known
};

constexpr double Any = 999.0;

inline const std::vector<DifferenceRow> FirstRows = {
    {false, DifferenceReduction::Mean, 0.19189, {0, 0, 90}, 0, 0.09594, 0},
    {false, DifferenceReduction::Max, 0.35417, {Any, 0, 90}, 38, 0.17634, 0},
    {false, DifferenceReduction::Home, 0.35417, {Any, 0, 90}, 38, 0.12789, 0},
    {true, DifferenceReduction::Mean, 0.03576, {0, 45, 45}, 0, 0.03527, 193},
    {true, DifferenceReduction::Max, 0.12789, {Any, 0, 45}, 38, 0.12789, 1},
    {true, DifferenceReduction::Home, 0.12789, {Any, 0, 45}, 38, 0.12789, 1}};
inline const std::vector<DifferenceRow> SecondRows = {
    {false, DifferenceReduction::Mean, 0.32706, {0, 0, -65}, 0, 0.20055, 0},
    {false, DifferenceReduction::Max, 0.55446, {Any, 0, -70}, 38, 0.37166, 0},
    {true, DifferenceReduction::Mean, 0.05662, {45, -45, 20}, 16, 0.05549, 289},
    {true, DifferenceReduction::Max, 0.15095, {45, 0, 45}, 0, 0.14019, 0},
    {true, DifferenceReduction::Home, 0.15095, {45, 0, -45}, 0, 0.07547, 0}};

} // namespace halbench::models
