#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halbench {

/// A value computed from others.
using UnitFunction = std::function<double(const std::vector<double>& arguments)>;

/// The unit of f(x₁ … xₙ) when x has `units`, found by trying: were every unit u of the arguments λ times
/// smaller, f would become λᵖ times larger for all arguments, and p is the power of u in the unit of f
/// (Buckingham 1914). An angle may drop out: sin(rad) is a number. Of Celsius, what does not move with the
/// zero is a difference in kelvin. A unit of control/base/units.h where one fits, else its factors ("A^2",
/// "A*rad/s"); "1" for a ratio; nothing when there is no power, as in current + 1, or when p is no whole
/// number.
std::optional<std::string> unitOf(const UnitFunction& f, const std::vector<std::string>& units);

} // namespace halbench
