#include "control/robustness/simulated_ensemble.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace halbench::control {

namespace {

BatchCurves curvesAt(const SimulatedEnsemble& motors, const BatchRun& run) {
    BatchCurves curves(static_cast<Eigen::Index>(motors.count), static_cast<Eigen::Index>(run.kept.size()));
    for (std::size_t first = 0; first < motors.count; first += LaneWidth) {
        motors.run(first, run, curves, first);
    }
    return curves;
}

void append(std::vector<double>& to, const std::vector<double>& from) {
    std::copy(from.begin(), from.end(), std::back_inserter(to));
}

} // namespace

SimulatedEnsemble simulatedEnsemble(const LoopBatch& batch) {
    return {batch.size(), batch.timing().period_s,
            [&batch](std::size_t first, const BatchRun& run, BatchCurves& curves, std::size_t row) {
                runBatch(batch, first, run, curves, row);
            },
            [&batch](const BatchRun& run) { return middleOfLanes(batch, run); }};
}

std::optional<Band> middleByParts(const SimulatedEnsemble& motors, const BatchRun& run,
                                  std::size_t mostValues) {
    const std::size_t part =
        std::clamp<std::size_t>(mostValues / std::max<std::size_t>(motors.count, 1), 1, run.kept.size());
    const bool fits = part == run.kept.size();
    BatchRun some = run;
    if (!fits) {
        some.kept = {run.kept.back()}; // what once is no number stays so
    }
    const BatchCurves curves = curvesAt(motors, some);
    const std::vector<Eigen::Index> lanes = finiteLanes(curves);
    if (lanes.empty()) {
        return std::nullopt;
    }
    if (fits) {
        return middleOfLanes(curves, lanes);
    }
    Band band;
    for (std::size_t begin = 0; begin < run.kept.size(); begin += part) {
        const std::size_t end = std::min(begin + part, run.kept.size());
        some.kept.assign(run.kept.begin() + static_cast<std::ptrdiff_t>(begin),
                         run.kept.begin() + static_cast<std::ptrdiff_t>(end));
        const Band middle = middleOfLanes(curvesAt(motors, some), lanes);
        append(band.p5, middle.p5);
        append(band.p95, middle.p95);
    }
    return band;
}

} // namespace halbench::control
