#include "app/procedures/move/move_judgement.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace halbench::app {
namespace {

/// Of the largest excursion: the board's sine comes from a table on small processors.
constexpr double ShapeTolerance_ratio = 1e-3;
constexpr double FloatResolution_ratio = 1e-6;

/// Angles of a rotor read best in degrees.
std::string readable(const devices::AxisSpec& axis, double position) {
    return axis.turnsForever ? fmt::format("{:.3g} degrees", radiansToDegrees(position))
                             : fmt::format("{:.3g} {}", position, axis.positionUnit);
}

void judgeRows(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
               DataQuality& quality) {
    const double expected = config.duration_s * config.rate_Hz;
    const auto rows = static_cast<double>(response.time_s.size());
    if (lostRows > 0 || rows < expected - 0.5) {
        quality.verdict = Verdict::Doubtful;
        quality.findings.push_back(
            {"rows_lost", fmt::format("{:.0f} of {:.0f} samples arrived", rows, expected + 1.0), ""});
    }
}

struct Interval {
    double low, high;
};

/// Of the commanded reference around a time: which sample it began with is known to a period of the loop, and
/// worse where rows are missing.
std::optional<Interval> commandedAround(const MoveReference& reference, const std::string& axis,
                                        double time_s, double uncertainty_s) {
    std::optional<Interval> interval;
    for (const double shift_s : {-uncertainty_s, 0.0, uncertainty_s}) {
        const auto value = referenceAt(reference, std::max(0.0, time_s + shift_s), axis);
        if (!value) {
            return std::nullopt;
        }
        const Interval before = interval.value_or(Interval{*value, *value});
        interval = Interval{std::min(before.low, *value), std::max(before.high, *value)};
    }
    return interval;
}

/// By how much the board's reference left the commanded one.
double largestDeparture(const MoveResponse& response, const MoveConfig& config, const std::string& axis,
                        double uncertainty_s) {
    double departure = 0.0;
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        const auto commanded = commandedAround(config.reference, axis, response.time_s[i], uncertainty_s);
        if (!commanded) {
            return 0.0;
        }
        const double value = response.reference[i];
        departure = std::max({departure, commanded->low - value, value - commanded->high});
    }
    return departure;
}

void addReference(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                  double origin, const devices::AxisSpec& axis, DataQuality& quality) {
    const double period_s = static_cast<double>(response.rowsPerReference) / config.rate_Hz;
    const double uncertainty_s = 2.0 * period_s + static_cast<double>(lostRows) / config.rate_Hz;
    const double departure = largestDeparture(response, config, axis.id, uncertainty_s);
    const double excursion = referenceExcursion(config.reference, config.duration_s, axis.id);
    const double allowed = ShapeTolerance_ratio * excursion + FloatResolution_ratio * std::fabs(origin) +
                           axis.referenceTolerance;
    if (departure > allowed) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back(
            {"reference_differs",
             fmt::format("the device followed another reference than commanded, deviation {}",
                         readable(axis, departure)),
             axis.turnsForever
                 ? "Check the rotor position and that no other program uses the device, then move again."
                 : "Check that no other program uses the device, then move again."});
    }
}

/// Friction holds the published gains of a motor up to 8 degrees away; half of the way and 20 degrees are no
/// friction.
void judgeEnd(const MoveResponse& response, const MoveConfig& config, const devices::AxisSpec& axis,
              DataQuality& quality) {
    using Shape = MoveReference::Shape;
    const bool endsAtRest =
        config.reference.shape == Shape::Step || config.reference.shape == Shape::Staircase;
    if (!endsAtRest || config.reference.base != 0.0) {
        return;
    }
    const double end = *referenceAt(config.reference, config.duration_s);
    const double miss = std::fabs(response.position.back() - end);
    if (miss > std::max(0.5 * std::fabs(end), axis.endTolerance)) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(
            {"ended_elsewhere",
             axis.turnsForever
                 ? fmt::format("the rotor ended at {:.1f} instead of {:.1f} degrees",
                               radiansToDegrees(response.position.back()), radiansToDegrees(end))
                 : fmt::format("axis {} ended at {:.3g} instead of {:.3g} {}", axis.id,
                               response.position.back(), end, axis.positionUnit),
             axis.turnsForever ? "Use a longer move. Check the gains and that the rotor is free."
                               : "Use a longer move. Check the gains and that the axis is free."});
    }
}

} // namespace

DataQuality judgeMotion(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                        double origin, const devices::AxisSpec& axis) {
    DataQuality quality;
    judgeRows(response, config, lostRows, quality);
    addReference(response, config, lostRows, origin, axis, quality);
    judgeEnd(response, config, axis, quality);
    return quality;
}

DataQuality judgeReference(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                           double origin, const devices::AxisSpec& axis) {
    DataQuality quality;
    addReference(response, config, lostRows, origin, axis, quality);
    return quality;
}

} // namespace halbench::app
