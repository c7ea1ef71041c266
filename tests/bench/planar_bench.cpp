// The models of the planar positioner against the times that a simulated board at 1 kHz can spend on them.
#include "control/base/random.h"
#include "control/signals/travel_profile.h"
#include "models/planar/planar_plant.h"
#include "models/planar/pose_estimator.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace halbench::bench {
namespace {

constexpr int Calls = 20000;
constexpr int Rounds = 9;

double perCall_us(const std::function<void(int)>& work) {
    const double all_s = processorTime_s(
        [&] {
            for (int i = 0; i < Calls; ++i) {
                work(i);
            }
        },
        Rounds);
    return 1e6 * all_s / Calls;
}

void benchWrench(Goals& goals) {
    const models::WindingsWrench windings{models::PlanarGeometry{}};
    const double time_us = perCall_us([&](int i) {
        benchmark::DoNotOptimize(windings.at({1e-6 * i, 2e-6 * i, 1e-6 * i}).wrench.data());
    });
    goals.below("forces of the windings model at one pose", time_us, 1.0, "us");
}

void benchPose(Goals& goals) {
    const models::PoseSensing sensing = models::nominalSensing({});
    const models::PlanarPose pose{3e-3, 4e-3, 5e-3};
    models::ChipFields_T field_T;
    for (std::size_t j = 0; j < sensing.place_m.size(); ++j) {
        field_T.segment<2>(2 * static_cast<Eigen::Index>(j)) =
            models::chipField_T(sensing.waveNumber_per_m, sensing.amplitude_T[j], sensing.place_m[j], pose);
    }
    // From a start as far off as a tick at 0.16 m/s.
    const double time_us = perCall_us([&](int i) {
        const double away_m = 160e-6 + 1e-9 * i;
        benchmark::DoNotOptimize(
            models::estimatePose(sensing, field_T, {pose.x_m + away_m, pose.y_m, pose.angle_rad}).pose.x_m);
    });
    goals.below("pose from six readings", time_us, 2.0, "us");
}

/// Over a million random moves: how long one takes to solve, and by how much a limit or the end is missed.
void benchProfile(Goals& goals) {
    Random random(1);
    const auto decades = [&random](double from, double to) {
        return std::pow(10.0, from + (to - from) * random.uniform());
    };
    double excess = 0.0;
    double miss = 0.0;
    for (int i = 0; i < 1000000; ++i) {
        const double distance = decades(-6.0, 0.0);
        const control::TravelLimits limits{decades(-3.0, 1.0), decades(-2.0, 2.0), decades(-1.0, 4.0)};
        const auto profile = control::TravelProfile::solve(distance, limits);
        excess = std::max({excess, profile->peakSpeed() / limits.speed - 1.0,
                           profile->peakAcceleration() / limits.acceleration - 1.0,
                           *profile->jerk() / *limits.jerk - 1.0});
        const double middle_s = 0.5 * profile->duration_s();
        miss = std::max(miss, std::fabs(2.0 * profile->at(middle_s).value / distance - 1.0));
    }
    goals.below("limits of a million random travels missed by", 1e10 * excess, 1.0, "1e-10");
    goals.below("their distance missed by", 1e8 * miss, 1.0, "1e-8");
    const double solve_us = perCall_us([](int i) {
        const auto profile = control::TravelProfile::solve(1e-3 + 1e-6 * i, {0.1, 0.5, 10.0});
        benchmark::DoNotOptimize(profile->duration_s());
    });
    goals.below("jerk-limited profile solved", solve_us, 5.0, "us");
}

void benchPlant(Goals& goals) {
    auto plant = *models::PlanarPlant::make({}, 1);
    std::array<float, models::PlanarPlant::ReadingCount> codes{};
    const double tick_us = perCall_us([&](int) {
        plant.advance(4);
        plant.read(codes);
        benchmark::DoNotOptimize(codes.data());
    });
    // The whole chain shall reach 50 times real time; the plant takes at most a quarter of its 20 us.
    goals.below("one millisecond of the plant with all imperfections", tick_us, 5.0, "us");
}

} // namespace
} // namespace halbench::bench

int main() {
    halbench::bench::Goals goals;
    halbench::bench::benchWrench(goals);
    halbench::bench::benchPose(goals);
    halbench::bench::benchPlant(goals);
    halbench::bench::benchProfile(goals);
    return goals.exitCode();
}
