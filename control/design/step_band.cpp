#include "control/base/assert.h"
#include "control/design/held_rotor.h"
#include "control/design/loop_batch.h"
#include "control/design/percentiles.h"
#include "control/design/uncertainty_bands.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::control {

namespace {

constexpr int Width = 16; ///< lanes that go together: their state stays in the nearest memory
using Lanes = Eigen::Array<double, Width, 1>;
using Curves = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>; ///< lane by point

/// Exact motion of a few rotors over an interval of constant current, as `advance` has it.
struct Rotors {
    Lanes decay;   ///< of the speed
    Lanes coast_s; ///< angle per speed
    Lanes drive;   ///< speed per current
    Lanes push;    ///< angle per current

    Rotors(const LoopBatch& batch, std::size_t first, double interval_s) {
        for (int i = 0; i < Width; ++i) {
            const PositionPlant& plant =
                batch.plant(std::min(first + static_cast<std::size_t>(i), batch.size() - 1));
            const double x = plant.dampingRate_1_s * interval_s;
            decay[i] = std::exp(-x);
            coast_s[i] = interval_s * heldSpeedShare(x);
            drive[i] = plant.accelerationGain_rad_s2_A * coast_s[i];
            push[i] = plant.accelerationGain_rad_s2_A * interval_s * interval_s * heldAngleShare(x);
        }
    }
};

/// Which points of how many are kept.
std::vector<std::size_t> keptPoints(std::size_t points, std::size_t most) {
    std::vector<std::size_t> kept;
    const std::size_t count = std::min(points, std::max<std::size_t>(most, 2));
    for (std::size_t i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        const double place =
            count == points ? static_cast<double>(i) : share * share * static_cast<double>(points - 1);
        const auto at = static_cast<std::size_t>(std::lround(place));
        if (kept.empty() || at > kept.back()) {
            kept.push_back(at);
        }
    }
    return kept;
}

/// What is asked of every lane.
struct Run {
    double amplitude_rad;
    int pointsPerSample;
    std::vector<std::size_t> kept;
};

/// The law of `linearStep` on some lanes from `first` on.
void runLanes(const LoopBatch& batch, std::size_t first, const Run& run, Curves& curves) {
    constexpr std::size_t MostPending = 16;
    const double T = batch.timing().period_s;
    const PidGains& gains = batch.gains();
    const Rotors rotors(batch, first, T / run.pointsPerSample);
    const auto delay = static_cast<std::size_t>(batch.timing().delay_samples);
    HB_ASSERT(delay < MostPending);
    std::array<Lanes, MostPending> pending;
    pending.fill(Lanes::Zero());
    Lanes angle = Lanes::Zero();
    Lanes speed = Lanes::Zero();
    Lanes integral = Lanes::Zero();
    Lanes last = Lanes::Zero();
    Lanes current = Lanes::Zero();
    std::size_t sample = 0;
    std::size_t next = 0;
    const auto lanes = static_cast<Eigen::Index>(std::min<std::size_t>(Width, batch.size() - first));
    for (std::size_t i = 0; next < run.kept.size(); ++i) {
        if (i % static_cast<std::size_t>(run.pointsPerSample) == 0) {
            const Lanes error = run.amplitude_rad - angle;
            pending[(sample + delay) % MostPending] =
                gains.proportional * error + integral - gains.derivative / T * (angle - last);
            integral += T * gains.integral * error;
            last = angle;
            current = pending[sample++ % MostPending];
        }
        if (i == run.kept[next]) {
            curves.col(static_cast<Eigen::Index>(next++)).segment(static_cast<Eigen::Index>(first), lanes) =
                angle.head(lanes);
        }
        angle += speed * rotors.coast_s + rotors.push * current;
        speed = speed * rotors.decay + rotors.drive * current;
    }
}

/// Lanes that stayed within all numbers.
std::vector<Eigen::Index> finiteLanes(const Curves& curves) {
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

Result<StepBand> stepBand(const std::vector<PositionPlant>& plants, const PidGains& gains,
                          const LoopTiming& timing, double amplitude_rad, double duration_s,
                          int pointsPerSample, std::size_t mostPoints) {
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return failure(batch.error());
    }
    const double interval_s = timing.period_s / pointsPerSample;
    if (const auto valid = checkExtent(amplitude_rad, duration_s / interval_s, pointsPerSample); !valid) {
        return failure(valid.error());
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    const Run run{amplitude_rad, pointsPerSample, keptPoints(points, mostPoints)};
    Curves curves(static_cast<Eigen::Index>(batch->size()), static_cast<Eigen::Index>(run.kept.size()));
    for (std::size_t first = 0; first < batch->size(); first += Width) {
        runLanes(*batch, first, run, curves);
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

} // namespace halbench::control
