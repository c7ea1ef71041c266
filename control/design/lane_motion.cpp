#include "control/design/lane_motion.h"

#include "control/base/assert.h"
#include "control/design/held_rotor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::control {

namespace {

using Lanes = Eigen::Array<double, LaneWidth, 1>;

/// Exact motion of a few rotors over an interval of constant current, as `advance` has it.
struct Rotors {
    Lanes decay;   ///< of the speed
    Lanes coast_s; ///< angle per speed
    Lanes drive;   ///< speed per current
    Lanes push;    ///< angle per current

    Rotors(const LoopBatch& batch, std::size_t first, double interval_s) {
        for (int i = 0; i < LaneWidth; ++i) {
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

} // namespace

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

void runLanes(const LoopBatch& batch, std::size_t first, const LaneRun& run, LaneCurves& curves,
              std::size_t row) {
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
    const auto lanes = static_cast<Eigen::Index>(std::min<std::size_t>(LaneWidth, batch.size() - first));
    for (std::size_t i = 0; next < run.kept.size(); ++i) {
        if (i % static_cast<std::size_t>(run.pointsPerSample) == 0) {
            const Lanes error = run.reference_rad - angle;
            pending[(sample + delay) % MostPending] =
                gains.proportional * error + integral - gains.derivative / T * (angle - last);
            integral += T * gains.integral * error;
            last = angle;
            current = pending[sample++ % MostPending];
        }
        if (i == run.kept[next]) {
            curves.col(static_cast<Eigen::Index>(next++)).segment(static_cast<Eigen::Index>(row), lanes) =
                angle.head(lanes);
        }
        angle += speed * rotors.coast_s + rotors.push * (current + run.load_A);
        speed = speed * rotors.decay + rotors.drive * (current + run.load_A);
    }
}

} // namespace halbench::control
