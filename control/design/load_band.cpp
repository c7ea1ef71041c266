#include "control/design/load_band.h"

#include "control/design/moved_motors.h"
#include "control/design/percentiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace halbench::control {

namespace {

constexpr double Never_s = std::numeric_limits<double>::infinity();

/// One motor's figures, as `loadStep` measures them.
struct Figures {
    std::vector<double> peak_rad;
    std::vector<double> recovery_s;
};

void measureLane(const Eigen::Ref<const Eigen::Array<double, 1, Eigen::Dynamic>>& angle,
                 const std::vector<std::size_t>& points, double final_rad, double interval_s,
                 Figures& figures) {
    constexpr double Recovered_ratio = 0.1;
    Eigen::Index at = 0;
    angle.abs().maxCoeff(&at);
    const double band_rad = Recovered_ratio * std::abs(angle[at]);
    Eigen::Index within = angle.size();
    while (within > 0 && std::abs(angle[within - 1] - final_rad) <= band_rad) {
        --within;
    }
    figures.peak_rad.push_back(angle[at]);
    figures.recovery_s.push_back(
        within < angle.size() ? static_cast<double>(points[static_cast<std::size_t>(within)]) * interval_s
                              : Never_s);
}

Robustness::Interval intervalOf(const std::vector<double>& values) {
    Eigen::ArrayXd sorted =
        Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    const MiddleNineTenths middle = middleNineTenths(sorted);
    return {middle.p5, middle.p95};
}

Result<void> checkExtent(double load_A, double points, int pointsPerSample) {
    constexpr double MostPoints = 1e7;
    const bool isPossible =
        std::isfinite(load_A) && load_A != 0.0 && pointsPerSample >= 1 && points > 0.0 && points < MostPoints;
    return isPossible ? Result<void>()
                      : failure(ErrorCode::OutOfRange,
                                fmt::format("a band under a load of {} A is not possible", load_A));
}

/// Those by which the peak and the recovery are measured: all of the first, then 0.5 % apart; the kept ones
/// are among them.
std::vector<std::size_t> measuredPoints(std::size_t points, const std::vector<std::size_t>& kept) {
    constexpr std::size_t All = 10001;
    constexpr double Apart_ratio = 0.005;
    std::vector<std::size_t> measured;
    for (std::size_t point = 0; point < points;) {
        measured.push_back(point);
        point += point < All ? 1 : static_cast<std::size_t>(Apart_ratio * static_cast<double>(point));
    }
    std::vector<std::size_t> all;
    std::set_union(measured.begin(), measured.end(), kept.begin(), kept.end(), std::back_inserter(all));
    return all;
}

/// Where in `all` those of `some` stand.
std::vector<Eigen::Index> placesOf(const std::vector<std::size_t>& some,
                                   const std::vector<std::size_t>& all) {
    std::vector<Eigen::Index> places;
    for (const std::size_t point : some) {
        places.push_back(std::lower_bound(all.begin(), all.end(), point) - all.begin());
    }
    return places;
}

} // namespace

Result<LoadBand> loadBandOf(const MovedMotors& motors, double final_rad, double load_A, double duration_s,
                            int pointsPerSample, std::size_t mostPoints) {
    const double interval_s = motors.period_s / pointsPerSample;
    if (const auto valid = checkExtent(load_A, duration_s / interval_s, pointsPerSample); !valid) {
        return failure(valid.error());
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    const std::vector<std::size_t> kept = keptPoints(points, mostPoints);
    const LaneRun run{0.0, load_A, pointsPerSample, measuredPoints(points, kept)};
    const std::vector<Eigen::Index> places = placesOf(kept, run.kept);
    Figures figures;
    const bool fits = kept.size() * motors.count <= MostLaneValues;
    LaneCurves curves(fits ? static_cast<Eigen::Index>(motors.count) : 0,
                      static_cast<Eigen::Index>(kept.size())); // of all motors
    std::vector<Eigen::Index> lanes;                           // that stay within numbers
    LaneCurves group(LaneWidth, static_cast<Eigen::Index>(run.kept.size()));
    for (std::size_t first = 0; first < motors.count; first += LaneWidth) {
        motors.run(first, run, group, 0);
        const std::size_t count = std::min<std::size_t>(LaneWidth, motors.count - first);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const auto row = group.row(static_cast<Eigen::Index>(lane));
            if (!std::isfinite(row[row.size() - 1])) {
                continue; // what once is none stays so
            }
            measureLane(row, run.kept, final_rad, interval_s, figures);
            lanes.push_back(static_cast<Eigen::Index>(first + lane));
            for (std::size_t i = 0; fits && i < kept.size(); ++i) {
                curves(lanes.back(), static_cast<Eigen::Index>(i)) = row[places[i]];
            }
        }
    }
    if (figures.peak_rad.empty()) {
        return failure(ErrorCode::Refused, "none of the drawn plants is a motor",
                       "identify the motor again, or correct the model file");
    }
    LoadBand band;
    for (const std::size_t point : kept) {
        band.time_s.push_back(static_cast<double>(point) * interval_s);
    }
    band.angle_rad = fits ? middleOfLanes(curves, lanes)
                          : motors.middle({0.0, load_A, pointsPerSample, kept}).value_or(Band{});
    band.peak_rad = intervalOf(figures.peak_rad);
    const Robustness::Interval recovery = intervalOf(figures.recovery_s);
    if (std::isfinite(recovery.p95)) {
        band.recoveryTime_s = recovery;
    }
    return band;
}

Result<LoadBand> loadBand(const std::vector<PositionPlant>& plants, const PidGains& gains,
                          const LoopTiming& timing, double load_A, double duration_s, int pointsPerSample,
                          std::size_t mostPoints) {
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return failure(batch.error());
    }
    const PidGains& board = batch->gains();
    const double final_rad = board.integral > 0.0 ? 0.0 : load_A / board.proportional;
    return loadBandOf(movedMotors(*batch), final_rad, load_A, duration_s, pointsPerSample, mostPoints);
}

} // namespace halbench::control
