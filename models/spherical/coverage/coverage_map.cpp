#include "models/spherical/coverage/coverage_map.h"

#include "control/base/units.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

struct SpinTable {
    explicit SpinTable(const AngleRange& gamma) {
        for (int i = 0; i < gamma.count; ++i) {
            cosine.push_back(std::cos(2.0 * gamma.at(i)));
            sine.push_back(std::sin(2.0 * gamma.at(i)));
        }
    }
    std::vector<double> cosine;
    std::vector<double> sine;
};

void include(CoverageCount& count, const OrientationAngles& pose) {
    if (count.uncovered == 0) {
        count.low = count.high = pose;
    }
    count.low = {std::min(count.low.alpha_rad, pose.alpha_rad), std::min(count.low.beta_rad, pose.beta_rad),
                 std::min(count.low.gamma_rad, pose.gamma_rad)};
    count.high = {std::max(count.high.alpha_rad, pose.alpha_rad),
                  std::max(count.high.beta_rad, pose.beta_rad),
                  std::max(count.high.gamma_rad, pose.gamma_rad)};
}

CoverageCount emptyCount() {
    CoverageCount count;
    count.least_T.fill(HUGE_VAL);
    return count;
}

void merge(CoverageCount& sum, const CoverageCount& part) {
    if (part.uncovered > 0) {
        include(sum, part.low);
        ++sum.uncovered; // so that the next box is added, not taken over
        include(sum, part.high);
        --sum.uncovered;
    }
    sum.poses += part.poses;
    sum.uncovered += part.uncovered;
    for (std::size_t c = 0; c < ComponentCount; ++c) {
        sum.uncoveredBy[c] += part.uncoveredBy[c];
        if (part.least_T[c] < sum.least_T[c]) {
            sum.least_T[c] = part.least_T[c];
            sum.leastAt[c] = part.leastAt[c];
        }
    }
}

CoverageCount countSlice(const CoverageModel& model, double threshold_T, const PoseGrid& grid,
                         const SpinTable& spins, double alpha_rad) {
    CoverageCount count = emptyCount();
    for (int b = 0; b < grid.beta.count; ++b) {
        const double beta_rad = grid.beta.at(b);
        const SpinReadings spin = model.spinReadings(alpha_rad, beta_rad);
        for (int g = 0; g < grid.gamma.count; ++g) {
            const auto at = static_cast<std::size_t>(g);
            const SphericalReadings readings_T = spin.at(spins.cosine[at], spins.sine[at]);
            bool isCovered = true;
            for (int c = 0; c < ComponentCount; ++c) {
                const auto component = static_cast<std::size_t>(c);
                const double largest_T = largestOfComponent_T(readings_T, c);
                if (largest_T < count.least_T[component]) {
                    count.least_T[component] = largest_T;
                    count.leastAt[component] = {alpha_rad, beta_rad, grid.gamma.at(g)};
                }
                if (largest_T <= threshold_T) {
                    ++count.uncoveredBy[component];
                    isCovered = false;
                }
            }
            if (!isCovered) {
                include(count, {alpha_rad, beta_rad, grid.gamma.at(g)});
                ++count.uncovered;
            }
        }
    }
    count.poses = static_cast<std::uint64_t>(grid.beta.count) * static_cast<std::uint64_t>(grid.gamma.count);
    return count;
}

} // namespace

PoseGrid workspaceGrid(double step_rad) {
    const int tilts = static_cast<int>(std::round(0.5 * Pi / step_rad)) + 1;
    const int spins = static_cast<int>(std::round(Pi / step_rad));
    return {{-0.25 * Pi, step_rad, tilts}, {-0.25 * Pi, step_rad, tilts}, {-0.5 * Pi, step_rad, spins}};
}

Result<void> checkPoseGrid(const PoseGrid& grid) {
    double poses = 1.0;
    for (const AngleRange& range : {grid.alpha, grid.beta, grid.gamma}) {
        if (!std::isfinite(range.first_rad) || !std::isfinite(range.step_rad)) {
            return failure(ErrorCode::NotFinite, "A number of the grid of poses is not finite.");
        }
        if (range.count < 1) {
            return failure(ErrorCode::OutOfRange, "The grid of poses is empty.");
        }
        poses *= range.count;
    }
    if (poses > static_cast<double>(LargestGrid)) {
        return failure(ErrorCode::OutOfRange, "The grid has more than 200 million poses.",
                       "Make its step larger.");
    }
    return {};
}

Result<CoverageCount> countCoverage(const CoverageModel& model, double threshold_T, const PoseGrid& grid,
                                    const WorkControl& control) {
    if (auto checked = checkPoseGrid(grid); !checked) {
        return failure(checked.error());
    }
    const SpinTable spins(grid.gamma);
    std::vector<CoverageCount> slices(static_cast<std::size_t>(grid.alpha.count));
    const auto worked = forEachInParallel(slices.size(), control, [&](std::size_t a) {
        slices[a] = countSlice(model, threshold_T, grid, spins, grid.alpha.at(static_cast<int>(a)));
    });
    if (!worked) {
        return failure(worked.error());
    }
    CoverageCount sum = emptyCount();
    for (const CoverageCount& slice : slices) {
        merge(sum, slice);
    }
    return sum;
}

double coverageValue(const CoverageModel& model, CoverageQuantity quantity, double deviation_T,
                     const OrientationAngles& angles) {
    if (quantity == CoverageQuantity::LeastComponent_T) {
        const SphericalReadings readings_T = model.readings_T(angles);
        return std::min({largestOfComponent_T(readings_T, 0), largestOfComponent_T(readings_T, 1),
                         largestOfComponent_T(readings_T, 2)});
    }
    const OrientationJacobian jacobian = model.jacobian(angles);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(jacobian.transpose() * jacobian, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d squares = eigen.eigenvalues().cwiseMax(0.0);
    if (quantity == CoverageQuantity::SmallestSingularValue) {
        return std::sqrt(squares[0]);
    }
    return std::min(Pi, deviation_T * std::sqrt(squares.cwiseInverse().sum()));
}

Result<std::vector<float>> coverageMap(const CoverageModel& model, CoverageQuantity quantity,
                                       double deviation_T, const PoseGrid& grid, const WorkControl& control) {
    if (auto checked = checkPoseGrid(grid); !checked) {
        return failure(checked.error());
    }
    std::vector<float> values(grid.size());
    const std::size_t slice = values.size() / static_cast<std::size_t>(grid.alpha.count);
    const auto worked =
        forEachInParallel(static_cast<std::size_t>(grid.alpha.count), control, [&](std::size_t a) {
            std::size_t at = a * slice;
            for (int b = 0; b < grid.beta.count; ++b) {
                for (int g = 0; g < grid.gamma.count; ++g) {
                    const OrientationAngles angles{grid.alpha.at(static_cast<int>(a)), grid.beta.at(b),
                                                   grid.gamma.at(g)};
                    values[at++] = static_cast<float>(coverageValue(model, quantity, deviation_T, angles));
                }
            }
        });
    if (!worked) {
        return failure(worked.error());
    }
    return values;
}

} // namespace halbench::models
