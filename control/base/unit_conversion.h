#pragma once

#include <optional>
#include <string_view>

namespace halbench {

/// value in the new unit = value * factor / divisor + offset; factor and divisor apart, so that a prefix
/// costs one rounding.
struct UnitConversion {
    double factor = 1.0;
    double divisor = 1.0;
    double offset = 0.0;

    double operator()(double value) const { return value * factor / divisor + offset; }
    bool isIdentity() const { return factor == divisor && offset == 0.0; }
};

/// How a number in one unit becomes one in another: products, quotients and powers of SI units with prefixes,
/// angles (rad, deg, rev, gon), r/min, gauss and temperatures, as files write them ("A/deg", "mNm/A",
/// "g*cm^2", "1/min"). An angle may be left out of a torque, inertia or damping ("N*m*s" is "N*m*s/rad")
/// and of an acceleration ("1/(A*s^2)" is "rad/s^2/A"), nowhere else: "1/s" and "1/min" may mean turns, "A" a
/// gain per degree. Nothing when a unit is not known or is of another dimension.
std::optional<UnitConversion> conversionBetween(std::string_view from, std::string_view to);

/// It can be read at all.
bool isReadableUnit(std::string_view text);

} // namespace halbench
