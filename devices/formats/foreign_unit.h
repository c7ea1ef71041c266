#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace halbench::devices {

/// A unit as other programs write it. SI value = written value * factor / divisor + offset: with one of the
/// first two 1, so that a prefix costs one rounding.
struct ForeignUnit {
    std::string_view written; ///< "mA"
    std::string_view symbol;  ///< "A", of control/base/units.h
    double factor = 1.0;
    double divisor = 1.0;
    double offset = 0.0; ///< of a temperature
};

/// Reads a unit with or without brackets around it; "", "-" and "1" say that there is none. Beside the table
/// of what other programs write, all that recordings read (control/base/unit_conversion.h) of times, angles,
/// their rates, currents, voltages, fields, temperatures, lengths, forces and torques. Nothing for one that
/// is not known; "C" is not: coulomb or Celsius.
std::optional<ForeignUnit> readForeignUnit(std::string_view written);

/// Every way of writing one that is read, for what offers them.
std::vector<std::string_view> foreignUnitWords();

} // namespace halbench::devices
