#include "control/design/moved_motors.h"
#include "control/design/percentiles.h"
#include "control/design/uncertainty_bands.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>

namespace halbench::control {

namespace {

/// Lanes that stayed within all numbers.
std::vector<Eigen::Index> finiteLanes(const LaneCurves& curves) {
    std::vector<Eigen::Index> lanes;
    for (Eigen::Index lane = 0; lane < curves.rows(); ++lane) {
        if (std::isfinite(curves(lane, curves.cols() - 1))) { // what once is none stays so
            lanes.push_back(lane);
        }
    }
    return lanes;
}

Result<void> checkExtent(double amplitude_rad, double points, int pointsPerSample) {
    constexpr double MostPoints = 1e7;
    const bool isPossible = std::isfinite(amplitude_rad) && amplitude_rad != 0.0 && pointsPerSample >= 1 &&
                            points > 0.0 && points < MostPoints;
    return isPossible
               ? Result<void>()
               : failure(ErrorCode::OutOfRange, "a band of steps of this height and length is not possible");
}

} // namespace

Result<StepBand> stepBandOf(const MovedMotors& motors, double amplitude_rad, double duration_s,
                            int pointsPerSample, std::size_t mostPoints) {
    const double interval_s = motors.period_s / pointsPerSample;
    if (const auto valid = checkExtent(amplitude_rad, duration_s / interval_s, pointsPerSample); !valid) {
        return failure(valid.error());
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    const LaneRun run{amplitude_rad, 0.0, pointsPerSample, keptPoints(points, mostPoints)};
    LaneCurves curves(static_cast<Eigen::Index>(motors.count), static_cast<Eigen::Index>(run.kept.size()));
    for (std::size_t first = 0; first < motors.count; first += LaneWidth) {
        motors.run(first, run, curves, first);
    }
    const std::vector<Eigen::Index> lanes = finiteLanes(curves);
    if (lanes.empty()) {
        return failure(ErrorCode::Refused, "none of the drawn plants is a motor",
                       "identify the motor again, or correct the model file");
    }
    StepBand band;
    Eigen::ArrayXd values(static_cast<Eigen::Index>(lanes.size()));
    for (std::size_t i = 0; i < run.kept.size(); ++i) {
        band.time_s.push_back(static_cast<double>(run.kept[i]) * interval_s);
        for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
            values[static_cast<Eigen::Index>(lane)] = curves(lanes[lane], static_cast<Eigen::Index>(i));
        }
        const MiddleNineTenths middle = middleNineTenths(values);
        band.response_rad.p5.push_back(middle.p5);
        band.response_rad.p95.push_back(middle.p95);
    }
    return band;
}

Result<StepBand> stepBand(const std::vector<PositionPlant>& plants, const PidGains& gains,
                          const LoopTiming& timing, double amplitude_rad, double duration_s,
                          int pointsPerSample, std::size_t mostPoints) {
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return failure(batch.error());
    }
    const MovedMotors motors{batch->size(), timing.period_s,
                             [&batch](std::size_t first, const LaneRun& run, LaneCurves& curves,
                                      std::size_t row) { runLanes(*batch, first, run, curves, row); }};
    return stepBandOf(motors, amplitude_rad, duration_s, pointsPerSample, mostPoints);
}

} // namespace halbench::control
