#include "app/procedures/move/move_judgement.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halbench::app {
namespace {

/// Of the largest excursion: the board's sine comes from a table on small processors.
constexpr double ShapeTolerance_ratio = 1e-3;
constexpr double FloatResolution_ratio = 1e-6;
constexpr double LeastTolerance_rad = 1e-4;

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
    double low_rad, high_rad;
};

/// Of the commanded reference around a time: which sample it began with is known to a period of the loop, and
/// worse where rows are missing.
std::optional<Interval> commandedAround(const MoveReference& reference, double time_s, double uncertainty_s) {
    std::optional<Interval> interval;
    for (const double shift_s : {-uncertainty_s, 0.0, uncertainty_s}) {
        const auto value_rad = referenceAt_rad(reference, std::max(0.0, time_s + shift_s));
        if (!value_rad) {
            return std::nullopt;
        }
        const Interval before = interval.value_or(Interval{*value_rad, *value_rad});
        interval = Interval{std::min(before.low_rad, *value_rad), std::max(before.high_rad, *value_rad)};
    }
    return interval;
}

/// By how much the board's reference left the commanded one.
double largestDeparture_rad(const MoveResponse& response, const MoveConfig& config, double uncertainty_s) {
    double departure_rad = 0.0;
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        const auto commanded = commandedAround(config.reference, response.time_s[i], uncertainty_s);
        if (!commanded) {
            return 0.0;
        }
        const double value_rad = response.reference_rad[i];
        departure_rad =
            std::max({departure_rad, commanded->low_rad - value_rad, value_rad - commanded->high_rad});
    }
    return departure_rad;
}

void judgeReference(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                    double origin_rad, DataQuality& quality) {
    const double period_s = static_cast<double>(response.rowsPerReference) / config.rate_Hz;
    const double uncertainty_s = 2.0 * period_s + static_cast<double>(lostRows) / config.rate_Hz;
    const double departure_rad = largestDeparture_rad(response, config, uncertainty_s);
    const double excursion_rad = referenceExcursion_rad(config.reference, config.duration_s);
    const double allowed_rad = ShapeTolerance_ratio * excursion_rad +
                               FloatResolution_ratio * std::fabs(origin_rad) + LeastTolerance_rad;
    if (departure_rad > allowed_rad) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back(
            {"reference_differs",
             fmt::format("the board followed another reference than commanded, {:.3g} degrees away",
                         radiansToDegrees(departure_rad)),
             "See where the rotor stands and that no other program uses the board, then move again."});
    }
}

/// Friction holds the published gains up to 8 degrees away; half of the way and 20 degrees are no friction.
void judgeEnd(const MoveResponse& response, const MoveConfig& config, DataQuality& quality) {
    using Shape = MoveReference::Shape;
    constexpr double LeastMiss_rad = 20.0 * Pi / 180.0;
    const bool endsAtRest =
        config.reference.shape == Shape::Step || config.reference.shape == Shape::Staircase;
    if (!endsAtRest || config.reference.base_rad_s != 0.0) {
        return;
    }
    const double end_rad = *referenceAt_rad(config.reference, config.duration_s);
    const double miss_rad = std::fabs(response.position_rad.back() - end_rad);
    if (miss_rad > std::max(0.5 * std::fabs(end_rad), LeastMiss_rad)) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(
            {"ended_elsewhere",
             fmt::format("the rotor ended at {:.1f} instead of {:.1f} degrees",
                         radiansToDegrees(response.position_rad.back()), radiansToDegrees(end_rad)),
             "Move for longer; check the gains and that nothing blocks the rotor."});
    }
}

} // namespace

DataQuality judgeMotion(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                        double origin_rad) {
    DataQuality quality;
    judgeRows(response, config, lostRows, quality);
    judgeReference(response, config, lostRows, origin_rad, quality);
    judgeEnd(response, config, quality);
    return quality;
}

} // namespace halbench::app
