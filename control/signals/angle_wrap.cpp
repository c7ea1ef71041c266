#include "control/signals/angle_wrap.h"

#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

constexpr double Turn_rad = 2.0 * Pi;
/// A motor that passes the end at 40 rad/s and 100 rows a second is seen up to 0.4 rad before it; a range may
/// be longer by what the numbers of a file are rounded to.
constexpr double Missed_rad = 0.5;
constexpr double Rounding_rad = 0.01;

/// The turn that the values stay within; nothing for any other range.
std::optional<double> turnOf(const std::vector<double>& angle_rad) {
    if (angle_rad.empty()) {
        return std::nullopt;
    }
    const auto [least, most] = std::minmax_element(angle_rad.begin(), angle_rad.end());
    const double range_rad = *most - *least;
    const double turns = std::ceil((range_rad - Rounding_rad) / Turn_rad);
    const bool isWhole = turns >= 1.0 && range_rad > turns * Turn_rad - Missed_rad;
    return isWhole ? std::optional(turns * Turn_rad) : std::nullopt;
}

} // namespace

std::optional<double> unwrapAngle(std::vector<double>& angle_rad) {
    const std::optional<double> turn_rad = turnOf(angle_rad);
    if (!turn_rad) {
        return std::nullopt;
    }
    std::vector<double> whole = angle_rad;
    double offset_rad = 0.0;
    for (std::size_t row = 1; row < whole.size(); ++row) {
        const double step_rad = angle_rad[row] - angle_rad[row - 1];
        if (std::abs(step_rad) > 0.5 * *turn_rad) {
            offset_rad -= std::copysign(*turn_rad, step_rad);
        }
        whole[row] += offset_rad;
    }
    if (offset_rad == 0.0 && whole == angle_rad) {
        return std::nullopt;
    }
    angle_rad = std::move(whole);
    return turn_rad;
}

} // namespace halbench::control
