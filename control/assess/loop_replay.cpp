#include "control/assess/loop_replay.h"

#include "control/base/assert.h"
#include "control/law/board_law_run.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

std::vector<double> differences(std::span<const double> values) {
    std::vector<double> result;
    for (std::size_t i = 1; i < values.size(); ++i) {
        result.push_back(values[i] - values[i - 1]);
    }
    return result;
}

/// The median of each value and its neighbours: one that stands alone goes, a slope stays.
std::vector<double> withoutSpikes(const std::vector<double>& values) {
    std::vector<double> result = values;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const auto [low, high] = std::minmax(values[i - 1], values[i + 1]);
        result[i] = std::clamp(values[i], low, high);
    }
    return result;
}

} // namespace

LoopReplay replayLoop(const LoopReplayConfig& config, const HeldCurrentPlant& plant) {
    constexpr double Row_s = 1e-3;
    constexpr double Rounding_s = 1e-12; // an instant this near to a row is at it
    const double period_s = config.law.period_s;
    HB_ASSERT(period_s > 0.0 && !config.reference.empty());
    HB_ASSERT(config.disturbance_A.empty() || config.disturbance_A.size() >= config.rows);
    BoardLawRun<double> law(config.law);
    double angle_rad = 0.0;
    double current_A = 0.0;
    std::size_t sample = 0;
    const auto nextSample_s = [&] { return static_cast<double>(sample) * period_s; };
    const auto compute = [&] {
        current_A = law.step(config.reference[std::min(sample++, config.reference.size() - 1)], angle_rad);
    };
    LoopReplay replay;
    replay.angle_rad.reserve(config.rows);
    replay.current_A.reserve(config.rows);
    for (std::size_t row = 0; row < config.rows; ++row) {
        const double begin_s = static_cast<double>(row) / 1000.0;
        if (nextSample_s() < begin_s + Rounding_s) {
            compute();
        }
        replay.angle_rad.push_back(angle_rad);
        replay.current_A.push_back(current_A);
        const double disturbance_A = config.disturbance_A.empty() ? 0.0 : config.disturbance_A[row];
        const auto moveFor = [&](double duration_s) {
            angle_rad = plant(current_A + disturbance_A, duration_s);
        };
        double done_s = 0.0; // of this row; a period of whole milliseconds has no instant within it
        while (nextSample_s() < begin_s + Row_s - Rounding_s) {
            const double until_s = nextSample_s() - begin_s;
            moveFor(until_s - done_s);
            done_s = until_s;
            compute();
        }
        moveFor(Row_s - done_s);
    }
    return replay;
}

std::vector<ReferencePoint> referencePoints(std::span<const double> value_rad, double period_s) {
    std::vector<ReferencePoint> points(value_rad.size());
    for (std::size_t i = 0; i < value_rad.size(); ++i) {
        points[i].value_rad = value_rad[i];
    }
    if (value_rad.size() < 3) {
        return points;
    }
    const std::vector<double> raw_rad = differences(value_rad);
    const std::vector<double> step_rad = withoutSpikes(raw_rad); // a jump is one
    const std::vector<double> bend_rad = withoutSpikes(differences(raw_rad));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double before_rad = step_rad[i == 0 ? 0 : i - 1];
        const double after_rad = step_rad[std::min(i, step_rad.size() - 1)];
        points[i].speed_rad_s = 0.5 * (before_rad + after_rad) / period_s;
        const std::size_t bend = std::clamp<std::size_t>(i, 1, bend_rad.size()) - 1;
        points[i].acceleration_rad_s2 = bend_rad[bend] / (period_s * period_s);
    }
    return points;
}

} // namespace halbench::control
