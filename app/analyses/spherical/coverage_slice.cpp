#include "app/analyses/spherical/coverage_slice.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

models::WorkControl stopOnly(const AnalysisControl& control) {
    models::WorkControl work;
    work.isStopped = control.isStopped;
    return work;
}

models::PoseGrid gridOf(const CoverageSliceConfig& config) {
    models::PoseGrid grid = models::workspaceGrid(config.step_rad);
    models::AngleRange& held = config.held == HeldAngle::Alpha  ? grid.alpha
                               : config.held == HeldAngle::Beta ? grid.beta
                                                                : grid.gamma;
    held = {config.held_rad, config.step_rad, 1};
    return grid;
}

} // namespace

Result<SliceOfCoverage> coverageSlice(const models::CoverageModel& model, const CoverageSliceConfig& config,
                                      const AnalysisControl& control) {
    using models::CoverageQuantity;
    SliceOfCoverage slice;
    slice.grid = gridOf(config);
    auto least = models::coverageMap(model, CoverageQuantity::LeastComponent_T, config.noise_T, slice.grid,
                                     stopOnly(control));
    if (!least) {
        return failure(least.error());
    }
    slice.least_T = *std::move(least);
    slice.uncovered = static_cast<std::size_t>(
        std::count_if(slice.least_T.begin(), slice.least_T.end(),
                      [&](float value_T) { return !(static_cast<double>(value_T) > config.threshold_T); }));
    slice.value = slice.least_T;
    if (config.quantity != CoverageQuantity::LeastComponent_T) {
        auto value =
            models::coverageMap(model, config.quantity, config.noise_T, slice.grid, stopOnly(control));
        if (!value) {
            return failure(value.error());
        }
        slice.value = *std::move(value);
    }
    return slice;
}

Result<CoverageJudgement> judgeCoverage(const models::CoverageModel& model, double threshold_T,
                                        const AnalysisControl& control) {
    CoverageJudgement judgement{true, {}};
    std::vector<Counterexample>& found = judgement.counterexamples;
    for (const bool isPositive : {false, true}) {
        models::CoverageProofConfig config;
        config.threshold_T = threshold_T;
        (isPositive ? config.box.low : config.box.high).gamma_rad = 0.0;
        const auto proof = models::proveCoverage(model, config, stopOnly(control));
        if (!proof) {
            return failure(proof.error());
        }
        judgement.isProven = judgement.isProven && proof->isProven();
        for (int component = 0; component < models::ComponentCount; ++component) {
            const models::ComponentProof& one = proof->component[static_cast<std::size_t>(component)];
            if (one.verdict == models::CoverageVerdict::Refuted) {
                found.push_back({component, one.leastAt, one.least_T});
            }
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Counterexample& a, const Counterexample& b) {
        return std::abs(a.at.gamma_rad) < std::abs(b.at.gamma_rad);
    });
    return judgement;
}

} // namespace halbench::app
