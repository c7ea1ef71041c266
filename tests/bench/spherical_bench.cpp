// Orientation estimators of the spherical motor against the times of the published solver, coverage and
// placement against what a user waits for.
#include "app/analyses/spherical/coverage_slice.h"
#include "control/base/units.h"
#include "models/spherical/additive_inverse.h"
#include "models/spherical/coverage/coverage_map.h"
#include "models/spherical/coverage/placement_search.h"
#include "models/spherical/orientation.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/swarm_estimator.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

std::size_t allocations = 0;

} // namespace

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace halbench::bench {
namespace {

using namespace models;

constexpr int Poses = 20000;
constexpr int Rounds = 9;
/// Seconds a pose that the publication prints for its solver.
constexpr double FastestPublished_s = 1.266;

OrientationAngles drawn(Random& random) {
    const double alpha_rad = degreesToRadians(90.0 * random.uniform() - 45.0);
    const double beta_rad = degreesToRadians(90.0 * random.uniform() - 45.0);
    return {alpha_rad, beta_rad, degreesToRadians(180.0 * random.uniform() - 90.0)};
}

Eigen::Matrix3d anyRotation(Random& random) {
    Eigen::Vector4d q;
    for (double& entry : q) {
        entry = random.gaussian();
    }
    return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

OrientationEstimator estimatorOf(OrientationMethod method) {
    OrientationConfig config;
    config.method = method;
    return *OrientationEstimator::make({}, config);
}

double perPose_us(const std::function<void(std::size_t)>& work) {
    const double all_s = processorTime_s(
        [&] {
            for (std::size_t i = 0; i < Poses; ++i) {
                work(i);
            }
        },
        Rounds);
    return 1e6 * all_s / Poses;
}

void benchEstimators(Goals& goals) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    Random random(1);
    std::vector<SphericalReadings> exact_T;
    std::vector<SphericalReadings> additive_T;
    for (int i = 0; i < Poses; ++i) {
        exact_T.push_back(field.readings_T(anyRotation(random), sensing.poses));
        additive_T.push_back(additiveReadings_T({}, drawn(random)));
    }
    const auto bare_us = [&](OrientationMethod method) {
        const OrientationEstimator estimator = estimatorOf(method);
        return perPose_us([&](std::size_t i) {
            double strength_T = 0.0;
            benchmark::DoNotOptimize(estimator.solve(exact_T[i], strength_T).data());
        });
    };
    const TensorSystem system(sensing);
    // The tensor by the iterative eigenvalue solver takes 0.4 us where the goals of 0.2, 0.4, 2 and 0.15 us
    // were set.
    const double reference_us = perPose_us([&](std::size_t i) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(tensorOf(system.solve(exact_T[i])));
        benchmark::DoNotOptimize(representative(eigen.eigenvectors()).data());
    });
    const auto judge = [&](const char* name, double time_us, double goal_us) {
        goals.below(fmt::format("{}, {:.3g} us, over an iterative solution", name, time_us),
                    time_us / reference_us, goal_us / 0.4, "times");
    };
    const double projector_us = bare_us(OrientationMethod::Projector);
    judge("tensor with projectors", projector_us, 0.2);
    judge("tensor with one Gauss-Newton step", bare_us(OrientationMethod::TensorRefined), 0.4);
    judge("Levenberg-Marquardt from the identity", perPose_us([&](std::size_t i) {
              const Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
              benchmark::DoNotOptimize(
                  fitRotation(field, sensing.poses, system, exact_T[i], start).chiSquare);
          }),
          2.0);
    judge("closed form of the additive model", perPose_us([&](std::size_t i) {
              benchmark::DoNotOptimize(additiveInverse(0.0991864782, additive_T[i]).alpha_rad);
          }),
          0.15);
    const AngleModel model = angleModel(AdditiveModel{});
    constexpr int SwarmPoses = 400;
    const double swarm_us =
        1e6 / SwarmPoses *
        processorTime_s(
            [&] {
                Random own(2);
                for (std::size_t i = 0; i < SwarmPoses; ++i) {
                    benchmark::DoNotOptimize(estimateBySwarm(model, {}, additive_T[i], own).fitness_T2);
                }
            },
            3);
    fmt::print(
        "published swarm with gradient projection, run here: {:.3g} us a pose; printed: 1.27 to 1.58 s\n",
        swarm_us);
    goals.atLeast("the tensor against the published swarm run here", swarm_us / projector_us, 100.0, "times");
    goals.atLeast("the tensor against the published time", 1e6 * FastestPublished_s / projector_us, 1e4,
                  "times");
}

void benchAllocation(Goals& goals) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const Eigen::Matrix3d truth = rotationOf({0.1, -0.2, 0.3});
    const SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
    ChannelMask masked = AllChannels;
    masked[4] = masked[0] = false;
    std::vector<OrientationEstimator> estimators;
    for (const auto method : {OrientationMethod::Tensor, OrientationMethod::Projector,
                              OrientationMethod::TensorRefined, OrientationMethod::LevenbergMarquardt}) {
        estimators.push_back(estimatorOf(method));
    }
    const std::size_t before = allocations;
    for (const OrientationEstimator& estimator : estimators) {
        benchmark::DoNotOptimize(estimator.estimate(readings_T).chiSquare);
        benchmark::DoNotOptimize(estimator.estimate(readings_T, masked).chiSquare);
    }
    benchmark::DoNotOptimize(additiveInverse(0.1, readings_T).alpha_rad);
    goals.below("allocations of all estimators", static_cast<double>(allocations - before), 0.5, "");
}

void benchMillion(Goals& goals) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const OrientationEstimator estimator = estimatorOf(OrientationMethod::TensorRefined);
    Random random(3);
    double worst_rad = 0.0;
    std::vector<float> noisy_deg;
    int wrongBranches = 0;
    for (int i = 0; i < 1000000; ++i) {
        const Eigen::Matrix3d truth = anyRotation(random);
        SphericalReadings readings_T = field.readings_T(truth, sensing.poses);
        double strength_T = 0.0;
        worst_rad = std::max(worst_rad, symmetricError_rad(estimator.solve(readings_T, strength_T), truth));
        for (double& reading_T : readings_T) {
            reading_T += 100e-6 * random.gaussian();
        }
        const double off_deg =
            radiansToDegrees(symmetricError_rad(estimator.solve(readings_T, strength_T), truth));
        noisy_deg.push_back(static_cast<float>(off_deg));
        wrongBranches += off_deg > 1.0;
    }
    std::sort(noisy_deg.begin(), noisy_deg.end());
    fmt::print("with 100 uT noise: worst {:.3g}, 99.9 % {:.3g} degrees\n", noisy_deg.back(),
               noisy_deg[999000]);
    goals.below("worst of a million poses", radiansToDegrees(worst_rad), 1e-9, "degrees");
    goals.below("wrong branches of a million noisy poses", wrongBranches, 0.5, "");
}

void benchCoverage(Goals& goals) {
    const CoverageModel model({}, sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05));
    WorkControl alone;
    alone.threads = 1;
    const double coverage_s = processorTime_s(
        [&] {
            benchmark::DoNotOptimize(
                countCoverage(model, 0.01, workspaceGrid(degreesToRadians(0.5)), alone)->uncovered);
        },
        3);
    goals.below("coverage of 11.8 million poses, one thread", coverage_s, 3.0, "s");
    // What follows a sensor that is dragged in the window: slice and workspace, on threads of their own
    // there.
    const app::CoverageSliceConfig slice;
    const double drag_s = processorTime_s(
        [&] {
            benchmark::DoNotOptimize(app::coverageSlice(model, slice)->uncovered);
            benchmark::DoNotOptimize(
                app::coverageOfWorkspace(model, {}, publishedPlacement(), slice)->figures.least_T);
        },
        Rounds);
    goals.below("map and figures of a sensor that is dragged", drag_s, 0.1, "s");
    const double search_s = wallTime_s([&] { benchmark::DoNotOptimize(searchPlacement({})->pairs); }, 1);
    goals.below("placement search on the 5-degree lattice", search_s, 120.0, "s");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchEstimators(goals);
    halbench::bench::benchAllocation(goals);
    halbench::bench::benchMillion(goals);
    halbench::bench::benchCoverage(goals);
    return goals.exitCode();
}
