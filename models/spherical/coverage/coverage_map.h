#pragma once

#include "models/spherical/coverage/coverage_model.h"
#include "models/spherical/coverage/parallel_work.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace halbench::models {

/// Evenly spaced angles.
struct AngleRange {
    double first_rad = 0.0;
    double step_rad = 0.0;
    int count = 1;

    double at(int index) const { return first_rad + index * step_rad; }
};

struct PoseGrid {
    AngleRange alpha;
    AngleRange beta;
    AngleRange gamma;

    std::size_t size() const {
        return static_cast<std::size_t>(alpha.count) * static_cast<std::size_t>(beta.count) *
               static_cast<std::size_t>(gamma.count);
    }
};

/// The workspace: alpha, beta -45 ... 45 degrees inclusive, gamma -90 degrees up to 90 less one step. The
/// step divides 45 degrees.
PoseGrid workspaceGrid(double step_rad);

/// Largest number of poses of a grid, so that a slip of the step does not take the machine's memory.
constexpr std::size_t LargestGrid = 200000000;
/// OutOfRange or NotFinite: empty, or more than LargestGrid poses.
Result<void> checkPoseGrid(const PoseGrid& grid);

/// Coverage by the component rule: for R, Theta and Phi the largest magnitude of the three sensors exceeds
/// the threshold.
struct CoverageCount {
    std::uint64_t poses = 0;
    std::uint64_t uncovered = 0;
    std::array<std::uint64_t, ComponentCount> uncoveredBy{}; ///< each component alone
    std::array<double, ComponentCount> least_T{};            ///< least largest magnitude
    std::array<OrientationAngles, ComponentCount> leastAt{}; ///< and its pose
    OrientationAngles low; ///< box around the uncovered poses, when there are some
    OrientationAngles high;

    double uncovered_ratio() const { return static_cast<double>(uncovered) / static_cast<double>(poses); }
};
Result<CoverageCount> countCoverage(const CoverageModel& model, double threshold_T, const PoseGrid& grid,
                                    const WorkControl& control = {});

/// Quantities of a map. The last two do not depend on how a sensor is rolled about its radius.
enum class CoverageQuantity {
    LeastComponent_T,       ///< least of the three components' largest magnitudes
    SmallestSingularValue,  ///< of the orientation Jacobian, T/rad
    PredictedDeviation_rad, ///< rms of the rotation angle for the given noise, bound of Cramer and Rao
};
inline constexpr std::array<std::string_view, 3> CoverageQuantityNames = {"component", "singular", "error"};

/// The quantity at each pose; gamma runs fastest, then beta. `deviation_T` is the noise of a channel.
Result<std::vector<float>> coverageMap(const CoverageModel& model, CoverageQuantity quantity,
                                       double deviation_T, const PoseGrid& grid,
                                       const WorkControl& control = {});

double coverageValue(const CoverageModel& model, CoverageQuantity quantity, double deviation_T,
                     const OrientationAngles& angles);

} // namespace halbench::models
