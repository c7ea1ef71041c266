#include "control/robustness/simulated_ensemble.h"
#include "control/robustness/uncertainty_bands.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace halbench::control {

namespace {

Result<void> checkExtent(double amplitude_rad, double points, int pointsPerSample) {
    constexpr double MostPoints = 1e7;
    const bool isPossible = std::isfinite(amplitude_rad) && amplitude_rad != 0.0 && pointsPerSample >= 1 &&
                            points > 0.0 && points < MostPoints;
    return isPossible
               ? Result<void>()
               : failure(ErrorCode::OutOfRange, "a band of steps of this height and length is not possible");
}

} // namespace

Result<StepBand> stepBandOf(const SimulatedEnsemble& motors, double amplitude_rad, double duration_s,
                            int pointsPerSample, std::size_t mostPoints) {
    const double interval_s = motors.period_s / pointsPerSample;
    if (const auto valid = checkExtent(amplitude_rad, duration_s / interval_s, pointsPerSample); !valid) {
        return failure(valid.error());
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    const BatchRun run{amplitude_rad, 0.0, pointsPerSample, keptPoints(points, mostPoints)};
    auto middle = motors.middle(run);
    if (!middle) {
        return failure(ErrorCode::Refused, "no valid motor among the samples", "identify the motor again");
    }
    StepBand band{{}, *std::move(middle)};
    for (const std::size_t point : run.kept) {
        band.time_s.push_back(static_cast<double>(point) * interval_s);
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
    return stepBandOf(simulatedEnsemble(*batch), amplitude_rad, duration_s, pointsPerSample, mostPoints);
}

} // namespace halbench::control
