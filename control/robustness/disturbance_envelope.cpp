#include "control/robustness/disturbance_envelope.h"

#include "control/robustness/percentiles.h"
#include "control/robustness/simulated_ensemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

namespace halbench::control {

namespace {

constexpr double Never_s = std::numeric_limits<double>::infinity();

/// One motor's figures, as `loadStep` measures them.
struct Figures {
    std::vector<double> peak_rad;
    std::vector<double> recovery_s;
};

using Lane = Eigen::Ref<const Eigen::Array<double, 1, Eigen::Dynamic>, 0, Eigen::InnerStride<>>;

void measureLane(const Lane& angle, const std::vector<std::size_t>& points, double final_rad,
                 double interval_s, Figures& figures) {
    constexpr double Recovered_ratio = 0.1;
    Eigen::Index at = 0;
    angle.abs().maxCoeff(&at);
    // Approached from below it is not reached within any time that is looked at.
    const double peak_rad = std::abs(final_rad) > std::abs(angle[at]) ? final_rad : angle[at];
    const double band_rad = Recovered_ratio * std::abs(peak_rad);
    Eigen::Index within = angle.size();
    while (within > 0 && std::abs(angle[within - 1] - final_rad) <= band_rad) {
        --within;
    }
    figures.peak_rad.push_back(peak_rad);
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

constexpr std::size_t AllMeasured = 10001; ///< points, from the first on

/// Those by which the peak and the recovery of a slow loop are measured: all of the first, then 0.5 % apart.
std::vector<std::size_t> measuredPoints(std::size_t points) {
    constexpr double Apart_ratio = 0.005;
    std::vector<std::size_t> measured;
    for (std::size_t point = 0; point < points;) {
        measured.push_back(point);
        point += point < AllMeasured ? 1 : static_cast<std::size_t>(Apart_ratio * static_cast<double>(point));
    }
    return measured;
}

std::vector<std::size_t> everyPoint(std::size_t points) {
    std::vector<std::size_t> all(points);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// Whether the points that are apart tell the way between them: each lies where its neighbours lead. Of a
/// loop that rings for so long they do not.
bool isResolved(const Lane& angle, const std::vector<std::size_t>& points) {
    constexpr double Near_ratio = 0.01; // of the peak, whose tenth is the band of the recovery
    const double near_rad = Near_ratio * angle.abs().maxCoeff();
    for (std::size_t i = AllMeasured; i + 1 < points.size(); ++i) {
        const auto before = static_cast<double>(points[i] - points[i - 1]);
        const auto behind = static_cast<double>(points[i + 1] - points[i]);
        const auto at = static_cast<Eigen::Index>(i);
        const double led_rad = (behind * angle[at - 1] + before * angle[at + 1]) / (before + behind);
        if (std::abs(angle[at] - led_rad) > near_rad) {
            return false;
        }
    }
    return true;
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

/// A load at some points, and where among them those stand that are kept.
struct MeasuredRun {
    BatchRun run;
    std::vector<Eigen::Index> places;

    MeasuredRun(double load_A, int pointsPerSample, const std::vector<std::size_t>& measured,
                const std::vector<std::size_t>& kept)
        : run{0.0, load_A, pointsPerSample, {}} {
        std::set_union(measured.begin(), measured.end(), kept.begin(), kept.end(),
                       std::back_inserter(run.kept));
        places = placesOf(kept, run.kept);
    }
};

bool isStillANumber(const Lane& angle) {
    return std::isfinite(angle[angle.size() - 1]); // what once is none stays so
}

} // namespace

Result<DisturbanceEnvelope> disturbanceEnvelopeOf(const SimulatedEnsemble& motors, double final_rad,
                                                  double load_A, double duration_s, int pointsPerSample,
                                                  std::size_t mostPoints) {
    const double interval_s = motors.period_s / pointsPerSample;
    if (const auto valid = checkExtent(load_A, duration_s / interval_s, pointsPerSample); !valid) {
        return failure(valid.error());
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    const std::vector<std::size_t> kept = keptPoints(points, mostPoints);
    const MeasuredRun few(load_A, pointsPerSample, measuredPoints(points), kept);
    std::optional<MeasuredRun> every; // where the few do not do
    Figures figures;
    const bool fits = kept.size() * motors.count <= MostLaneValues;
    BatchCurves curves(fits ? static_cast<Eigen::Index>(motors.count) : 0,
                       static_cast<Eigen::Index>(kept.size())); // of all motors
    std::vector<Eigen::Index> lanes;                            // that stay within numbers
    BatchCurves group;
    for (std::size_t first = 0; first < motors.count; first += LaneWidth) {
        const auto count = static_cast<Eigen::Index>(std::min<std::size_t>(LaneWidth, motors.count - first));
        const auto isTold = [&](Eigen::Index lane) {
            return !isStillANumber(group.row(lane)) || isResolved(group.row(lane), few.run.kept);
        };
        const MeasuredRun* measured = &few;
        group.resize(LaneWidth, static_cast<Eigen::Index>(few.run.kept.size()));
        motors.run(first, few.run, group, 0);
        for (Eigen::Index lane = 0; lane < count && measured == &few; ++lane) {
            if (!isTold(lane)) {
                every = every ? every : MeasuredRun(load_A, pointsPerSample, everyPoint(points), kept);
                measured = &*every;
            }
        }
        if (measured != &few) {
            group.resize(LaneWidth, static_cast<Eigen::Index>(points));
            motors.run(first, measured->run, group, 0);
        }
        for (Eigen::Index lane = 0; lane < count; ++lane) {
            if (!isStillANumber(group.row(lane))) {
                continue;
            }
            measureLane(group.row(lane), measured->run.kept, final_rad, interval_s, figures);
            lanes.push_back(static_cast<Eigen::Index>(first) + lane);
            for (std::size_t i = 0; fits && i < kept.size(); ++i) {
                curves(lanes.back(), static_cast<Eigen::Index>(i)) = group(lane, measured->places[i]);
            }
        }
    }
    if (figures.peak_rad.empty()) {
        return failure(ErrorCode::Refused, "no valid motor among the samples", "identify the motor again");
    }
    DisturbanceEnvelope band;
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

Result<DisturbanceEnvelope> disturbanceEnvelope(const std::vector<PositionPlant>& plants,
                                                const PidGains& gains, const LoopTiming& timing,
                                                double load_A, double duration_s, int pointsPerSample,
                                                std::size_t mostPoints) {
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return failure(batch.error());
    }
    const PidGains& board = batch->gains();
    const double final_rad = board.integral > 0.0 ? 0.0 : load_A / board.proportional;
    return disturbanceEnvelopeOf(simulatedEnsemble(*batch), final_rad, load_A, duration_s, pointsPerSample,
                                 mostPoints);
}

} // namespace halbench::control
