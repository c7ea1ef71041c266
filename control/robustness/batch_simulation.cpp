#include "control/robustness/batch_simulation.h"

#include "control/base/assert.h"
#include "control/robustness/batch_axis.h"
#include "control/robustness/percentiles.h"
#include "control/robustness/state_powers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::control {

namespace {

using Lanes = BatchState::Lanes;

/// The law and the rotors.
struct BatchLoop {
    BatchAxis rotors;
    PidGains gains;
    double period_s;
    std::size_t delay; ///< in samples

    BatchLoop(const LoopBatch& batch, std::size_t first, int pointsPerSample)
        : rotors(batch.plants(), first, batch.timing().period_s / pointsPerSample), gains(batch.gains()),
          period_s(batch.timing().period_s), delay(static_cast<std::size_t>(batch.timing().delay_samples)) {}

    void control(BatchState& now, double reference_rad) const {
        const Lanes error = reference_rad - now.angle;
        now.pending[(now.sample + delay) % BatchState::MostPending] =
            gains.proportional * error + now.integral - gains.derivative / period_s * (now.angle - now.last);
        now.integral += period_s * gains.integral * error;
        now.last = now.angle;
        now.current = now.pending[now.sample++ % BatchState::MostPending];
    }
    void coast(BatchState& now, double load_A) const {
        rotors.move(now.angle, now.speed, now.current + load_A);
    }
};

/// From a state to the kept point `until`; nothing where no points are far enough apart.
std::optional<StatePowers> leapsOf(const BatchLoop& loop, const BatchRun& run, const BatchState& state,
                                   std::size_t until) {
    std::size_t longest = 0;
    std::size_t point = state.point;
    for (std::size_t next = state.next; next < until; ++next) {
        longest = std::max(longest, run.kept[next] - point);
        point = run.kept[next];
    }
    if (run.pointsPerSample != 1 || longest < StatePowers::shortest(loop.delay)) {
        return std::nullopt;
    }
    const auto sample = [&loop](BatchState& one, double reference_rad, double load_A) {
        loop.control(one, reference_rad);
        loop.coast(one, load_A);
    };
    return StatePowers(sample, loop.delay, run, longest);
}

void addMiddle(Band& band, const BatchCurves& curves, Eigen::Index columns,
               const std::vector<Eigen::Index>& lanes) {
    Eigen::ArrayXd values(static_cast<Eigen::Index>(lanes.size()));
    for (Eigen::Index column = 0; column < columns; ++column) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            values[static_cast<Eigen::Index>(i)] = curves(lanes[i], column);
        }
        const MiddleNineTenths middle = middleNineTenths(values);
        band.p5.push_back(middle.p5);
        band.p95.push_back(middle.p95);
    }
}

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

void runBatch(const LoopBatch& batch, std::size_t first, const BatchRun& run, BatchCurves& curves,
              std::size_t row) {
    BatchState state;
    runBatch(batch, first, run, state, run.kept.size(), curves, row);
}

void runBatch(const LoopBatch& batch, std::size_t first, const BatchRun& run, BatchState& state,
              std::size_t until, BatchCurves& curves, std::size_t row) {
    const BatchLoop loop(batch, first, run.pointsPerSample);
    HB_ASSERT(loop.delay < BatchState::MostPending && until <= run.kept.size());
    BatchState now = state; // its own, so that it stays in the nearest memory
    const std::size_t begin = now.next;
    const auto leaps = leapsOf(loop, run, now, until);
    const std::size_t shortest = leaps ? StatePowers::shortest(loop.delay) : run.kept.back() + 1;
    const auto lanes = static_cast<Eigen::Index>(std::min<std::size_t>(LaneWidth, batch.size() - first));
    for (; now.next < until; ++now.point) {
        if (run.kept[now.next] >= now.point + shortest) {
            leaps->leap(now, run.kept[now.next] - now.point);
        }
        if (now.point % static_cast<std::size_t>(run.pointsPerSample) == 0) {
            loop.control(now, run.reference_rad);
        }
        if (now.point == run.kept[now.next]) {
            curves.col(static_cast<Eigen::Index>(now.next++ - begin))
                .segment(static_cast<Eigen::Index>(row), lanes) = now.angle.head(lanes);
        }
        loop.coast(now, run.load_A);
    }
    state = now;
}

std::vector<Eigen::Index> finiteLanes(const BatchCurves& curves) {
    std::vector<Eigen::Index> lanes;
    for (Eigen::Index lane = 0; lane < curves.rows(); ++lane) {
        if (std::isfinite(curves(lane, curves.cols() - 1))) {
            lanes.push_back(lane);
        }
    }
    return lanes;
}

Band middleOfLanes(const BatchCurves& curves, const std::vector<Eigen::Index>& lanes) {
    Band band;
    addMiddle(band, curves, curves.cols(), lanes);
    return band;
}

std::optional<Band> middleOfLanes(const LoopBatch& batch, const BatchRun& run, std::size_t mostValues) {
    const std::size_t points = run.kept.size();
    const std::size_t part = std::clamp<std::size_t>(mostValues / batch.size(), 1, points);
    const bool fits = part == points;
    const auto rows = static_cast<Eigen::Index>(batch.size());
    BatchCurves curves(rows, static_cast<Eigen::Index>(part));
    BatchRun end = run;
    end.kept = {run.kept.back()};
    for (std::size_t first = 0; first < batch.size(); first += LaneWidth) {
        runBatch(batch, first, fits ? run : end, curves, first);
    }
    const std::vector<Eigen::Index> lanes = finiteLanes(fits ? curves : BatchCurves(curves.leftCols(1)));
    if (lanes.empty()) {
        return std::nullopt;
    }
    if (fits) {
        return middleOfLanes(curves, lanes);
    }
    Band band;
    std::vector<BatchState> states((batch.size() + LaneWidth - 1) / LaneWidth);
    for (std::size_t begin = 0; begin < points; begin += part) {
        const std::size_t until = std::min(begin + part, points);
        for (std::size_t group = 0; group < states.size(); ++group) {
            runBatch(batch, group * LaneWidth, run, states[group], until, curves, group * LaneWidth);
        }
        addMiddle(band, curves, static_cast<Eigen::Index>(until - begin), lanes);
    }
    return band;
}

} // namespace halbench::control
