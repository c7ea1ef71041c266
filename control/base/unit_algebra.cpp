#include "control/base/unit_algebra.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

namespace halbench {

namespace {

using Powers = std::map<std::string, int>; ///< of each factor of a unit; none is zero

constexpr const char* Celsius = "degC";
constexpr const char* Kelvin = "K";
constexpr const char* Radian = "rad";
constexpr const char* Number = "1";
constexpr int Points = 12;     ///< where the function is tried
constexpr int LeastPoints = 3; ///< with a value that says something
constexpr double Same = 1e-9;  ///< relative: many roundings of 2e-16 of a short formula
constexpr double Whole = 1e-6; ///< distance of a power from its whole number
constexpr double Scales[] = {2.0, 3.0};
constexpr double Shift = 10.0;

/// The number behind a ^, "2" or "-1", and moves behind it.
int exponentAt(const std::string& symbol, std::size_t& at) {
    int power = 1;
    const std::from_chars_result read =
        std::from_chars(symbol.data() + at, symbol.data() + symbol.size(), power);
    at = static_cast<std::size_t>(read.ptr - symbol.data());
    return power;
}

/// "N*m*s/rad", "A/(rad*s)", "rad/s^2/A": what follows a / stands below, in parentheses all of it.
Powers powersIn(const std::string& symbol) {
    Powers powers;
    int sign = 1;
    bool isInside = false;
    std::size_t at = 0;
    while (at < symbol.size()) {
        const char letter = symbol[at];
        if (letter == '/') {
            sign = -1;
        } else if (letter == '*' && !isInside) {
            sign = 1;
        } else if (letter == '(' || letter == ')') {
            isInside = letter == '(';
        }
        const std::size_t end = std::min(symbol.find_first_of("*/()^", at), symbol.size());
        if (end == at) {
            ++at;
            continue;
        }
        const std::string factor = symbol.substr(at, end - at);
        at = end;
        int power = 1;
        if (at < symbol.size() && symbol[at] == '^') {
            power = exponentAt(symbol, ++at);
        }
        if (factor != Number) {
            powers[factor] += sign * power;
        }
    }
    std::erase_if(powers, [](const auto& entry) { return entry.second == 0; });
    return powers;
}

std::string product(const Powers& powers, int sign) {
    std::string text;
    for (const auto& [factor, power] : powers) {
        if (power * sign > 0) {
            text += (text.empty() ? "" : "*") + factor;
            text += power * sign > 1 ? fmt::format("^{}", power * sign) : "";
        }
    }
    return text;
}

std::string symbolOf(const Powers& powers) {
    for (const Unit& unit : units()) {
        if (!unit.symbol.empty() && powersIn(std::string(unit.symbol)) == powers) {
            return std::string(unit.symbol);
        }
    }
    const std::string above = product(powers, 1);
    const std::string below = product(powers, -1);
    const std::string shownAbove = above.empty() ? Number : above;
    if (below.empty()) {
        return shownAbove;
    }
    return shownAbove + '/' + (below.find('*') == std::string::npos ? below : '(' + below + ')');
}

/// Spread over a decade and both signs, every argument otherwise (multiples of the golden ratio).
std::vector<double> argumentsAt(int point, std::size_t count) {
    std::vector<double> arguments;
    for (std::size_t i = 0; i < count; ++i) {
        const double step =
            0.618033988749895 * static_cast<double>((i + 1) * static_cast<std::size_t>(point + 1));
        const double magnitude = 0.3 + 2.7 * (step - std::floor(step));
        const bool isNegative = point >= Points / 2 && (static_cast<std::size_t>(point) >> (i % 3)) % 2 == 1;
        arguments.push_back(isNegative ? -magnitude : magnitude);
    }
    return arguments;
}

bool isNear(double one, double other, double tolerance) {
    return std::abs(one - other) <= tolerance * std::max(std::abs(one), std::abs(other));
}

/// The power of one factor, when all points and both scales agree.
std::optional<int> powerOf(const UnitFunction& f, const std::vector<int>& powers) {
    std::optional<double> found;
    for (const double scale : Scales) {
        int said = 0;
        for (int point = 0; point < Points; ++point) {
            std::vector<double> arguments = argumentsAt(point, powers.size());
            const double before = f(arguments);
            for (std::size_t i = 0; i < powers.size(); ++i) {
                arguments[i] *= std::pow(scale, powers[i]);
            }
            const double after = f(arguments);
            if (!std::isfinite(before) || !std::isfinite(after) || (before == 0.0 && after == 0.0)) {
                continue;
            }
            const double ratio = before != 0.0 ? after / before : 0.0; // from nothing comes something
            if (ratio <= 0.0 ||
                !isNear(ratio, std::pow(scale, found.value_or(std::log(ratio) / std::log(scale))), Same)) {
                return std::nullopt;
            }
            found = found.value_or(std::log(ratio) / std::log(scale));
            ++said;
        }
        if (said < LeastPoints) {
            return std::nullopt;
        }
    }
    const double whole = std::round(*found);
    return std::abs(*found - whole) < Whole ? std::optional(static_cast<int>(whole)) : std::nullopt;
}

/// How the result moves with the zero of Celsius: 1 as a temperature, 0 as a difference.
std::optional<std::string> temperatureOf(const UnitFunction& f, const std::vector<std::string>& units) {
    std::optional<std::string> found;
    for (int point = 0; point < Points; ++point) {
        std::vector<double> arguments = argumentsAt(point, units.size());
        const double before = f(arguments);
        for (std::size_t i = 0; i < units.size(); ++i) {
            arguments[i] += units[i] == Celsius ? Shift : 0.0;
        }
        const double moved = f(arguments) - before;
        if (!std::isfinite(moved)) {
            continue;
        }
        const bool isTemperature = std::abs(moved - Shift) < Same * Shift;
        const bool isDifference = std::abs(moved) < Same * Shift;
        const std::string unit = isTemperature ? Celsius : Kelvin;
        if ((!isTemperature && !isDifference) || unit != found.value_or(unit)) {
            return std::nullopt;
        }
        found = unit;
    }
    return found;
}

std::optional<Powers> powersOf(const UnitFunction& f, const std::vector<Powers>& arguments) {
    Powers result;
    Powers factors;
    for (const Powers& argument : arguments) {
        factors.insert(argument.begin(), argument.end());
    }
    const auto tryFactor = [&](const std::string& factor) {
        std::vector<int> powers;
        for (const Powers& argument : arguments) {
            const auto found = argument.find(factor);
            powers.push_back(found != argument.end() ? found->second : 0);
        }
        return powerOf(f, powers);
    };
    for (const auto& [factor, anything] : factors) {
        std::optional<int> power = tryFactor(factor);
        if (!power && factor != Radian) {
            return std::nullopt;
        }
        if (power.value_or(0) != 0) {
            result[factor] = *power;
        }
    }
    return result;
}

} // namespace

std::optional<std::string> unitOf(const UnitFunction& f, const std::vector<std::string>& units) {
    std::vector<Powers> arguments;
    for (const std::string& unit : units) {
        arguments.push_back(powersIn(unit));
    }
    const std::optional<Powers> powers = powersOf(f, arguments);
    if (!powers) {
        return std::nullopt;
    }
    if (powers->count(Celsius) != 0) {
        return *powers == Powers{{Celsius, 1}} ? temperatureOf(f, units) : std::nullopt;
    }
    return powers->empty() ? Number : symbolOf(*powers);
}

} // namespace halbench
