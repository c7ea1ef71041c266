#include "app/analyses/spherical/coverage_slice.h"

#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr double ShaftStep_rad = 3.0 * Pi / 180.0; // divides 45 degrees
constexpr double SpinStep_rad = Pi / 180.0;

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

namespace {

Result<std::vector<UncoveredShaft>> uncoveredShafts(const models::CoverageModel& model, double threshold_T,
                                                    const AnalysisControl& control) {
    models::PoseGrid grid = models::workspaceGrid(ShaftStep_rad);
    grid.gamma = models::workspaceGrid(SpinStep_rad).gamma;
    const auto least_T =
        models::coverageMap(model, models::CoverageQuantity::LeastComponent_T, 0.0, grid, stopOnly(control));
    if (!least_T) {
        return failure(least_T.error());
    }
    std::vector<UncoveredShaft> found;
    auto spin_T = least_T->begin();
    for (int a = 0; a < grid.alpha.count; ++a) {
        for (int b = 0; b < grid.beta.count; ++b) {
            const auto uncovered = std::count_if(spin_T, spin_T + grid.gamma.count, [&](float value_T) {
                return !(static_cast<double>(value_T) > threshold_T);
            });
            spin_T += grid.gamma.count;
            if (uncovered > 0) {
                found.push_back(
                    {grid.alpha.at(a), grid.beta.at(b), static_cast<double>(uncovered) / grid.gamma.count});
            }
        }
    }
    return found;
}

} // namespace

Result<CoverageOfWorkspace> coverageOfWorkspace(const models::CoverageModel& model,
                                                const models::PlacementDevice& device,
                                                const models::SensorTriple& placement,
                                                const CoverageSliceConfig& config,
                                                const AnalysisControl& control) {
    const models::SensorPoses poses = models::sensorPoses(placement, device.frames, device.radius_m);
    if (auto checked = models::checkSensorPoses(poses, device.rotorRadius_m); !checked) {
        return failure(checked.error());
    }
    auto uncovered = uncoveredShafts(model, config.threshold_T, control);
    if (!uncovered) {
        return failure(uncovered.error());
    }
    return CoverageOfWorkspace{*std::move(uncovered),
                               models::assessPlacement(device, placement, config.noise_T)};
}

} // namespace halbench::app
