// The models of the planar positioner against the times that a simulated board at 1 kHz can spend on them.
#include "models/planar/planar_plant.h"
#include "models/planar/pose_estimator.h"
#include "tests/bench/goal.h"

#include <benchmark/benchmark.h>

#include <array>
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
    return goals.exitCode();
}
