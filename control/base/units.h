#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace halbench {

/// One physical unit: the symbol used in metadata, JSON and A2L; the suffix used in CSV headers and
/// identifiers.
struct Unit {
    std::string_view symbol;   ///< "rad/s"
    std::string_view suffix;   ///< "rad_s"
    std::string_view quantity; ///< "angular speed"
};

/// The closed list of units. Every signal, parameter, axis, CSV header and report uses one of these.
std::span<const Unit> units();

/// The unit with this symbol; an empty symbol is the dimensionless unit.
std::optional<Unit> findUnit(std::string_view symbol);

constexpr double Pi = 3.14159265358979323846;
constexpr double degreesToRadians(double angle_deg) {
    return angle_deg * (Pi / 180.0);
}
constexpr double radiansToDegrees(double angle_rad) {
    return angle_rad * (180.0 / Pi);
}
constexpr double rpmToRadPerSecond(double speed_rpm) {
    return speed_rpm * (Pi / 30.0);
}
constexpr double radPerSecondToRpm(double speed_rad_s) {
    return speed_rad_s * (30.0 / Pi);
}

} // namespace halbench
