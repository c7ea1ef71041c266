#include "devices/firmware/planar/hb_planar_tracker.h"
#include "models/planar/pose_tracker.h"
#include "tests/devices/firmware/planar/planar_board.h"

#include <gtest/gtest.h>

#include <cmath>

// The tracking filter in single precision beside the same filter in double precision, which the tests of
// models/planar hold against the theory.

namespace halbench::devices::firmware {
namespace {

constexpr double Noise_T = 18e-6;
constexpr double Tick_s = 1e-3;

struct Bench {
    hb_planar_calibration page = initialCalibration();
    models::PoseSensing sensing;
    models::PoseTrackerConfig config;
    hb_tracker tracker{};
    models::PoseTrackerState exact;
    Random random{9};

    Bench() {
        page.chips.deviation_T = static_cast<float>(Noise_T);
        sensing = sensingOf(page);
    }
    models::ChipFields_T noisyFields(const models::PlanarPose& pose) {
        models::ChipFields_T fields = fieldsAt(sensing, pose);
        for (Eigen::Index k = 0; k < fields.size(); ++k) {
            fields(k) += Noise_T * random.gaussian();
        }
        return fields;
    }
    void start(const models::PlanarPose& pose) {
        const hb_pose known{static_cast<float>(pose.x_m), static_cast<float>(pose.y_m),
                            static_cast<float>(pose.angle_rad)};
        hb_tracker_start(&tracker, &known, 10e-6F);
        exact = models::startTracker(config, models::estimatePose(sensing, fieldsAt(sensing, pose), pose));
    }
    /// One tick; returns both chi-squares of the innovation.
    std::pair<double, double> step(const models::PlanarPose& pose, const Eigen::Vector3d& acceleration) {
        const models::ChipFields_T fields = noisyFields(pose);
        const float single_[3] = {static_cast<float>(acceleration.x()), static_cast<float>(acceleration.y()),
                                  static_cast<float>(acceleration.z())};
        hb_tracker_predict(&tracker, single_);
        const Fields readings = single(fields);
        const float chi =
            hb_tracker_update(&tracker, &page.chips, page.coils.pitch_m, readings.data(), HB_ALL_CHIPS);
        models::predict(config, exact, acceleration);
        return {static_cast<double>(chi), models::update(sensing, exact, fields).chiSquare};
    }
};

TEST(PlanarTracker, isTheFilterInDoublePrecision) {
    Bench bench;
    models::PlanarPose pose{6.35e-3, -6.35e-3, 0.0};
    bench.start(pose);
    double chi = 0.0;
    constexpr int Ticks = 3000;
    for (int k = 0; k < Ticks; ++k) {
        // A millimetre along y and back, 2 Hz, known acceleration.
        const double phase = 4.0 * 3.14159265358979323846 * Tick_s * k;
        const double omega = 4.0 * 3.14159265358979323846;
        pose.y_m = -6.35e-3 + 1e-3 * (1.0 - std::cos(phase));
        const auto [single_, exact] = bench.step(pose, {0.0, 1e-3 * omega * omega * std::cos(phase), 0.0});
        if (k > 500) { // both have forgotten how they started
            ASSERT_NEAR(single_, exact, 0.02 * exact + 0.02);
            chi += single_;
        }
    }
    // Consistent: 5.3 to 6.5 for six readings.
    EXPECT_GT(chi / (Ticks - 501), 5.3);
    EXPECT_LT(chi / (Ticks - 501), 6.5);
    for (int i = 0; i < HB_TRACKER_STATES; ++i) {
        const double deviation = std::sqrt(bench.exact.covariance(i, i));
        // Roundings of 4 nm in a pose known to 3 um, each forgotten after some ticks: 1 % of the deviation.
        EXPECT_NEAR(static_cast<double>(bench.tracker.mean[i]), bench.exact.mean(i), 0.02 * deviation) << i;
        EXPECT_NEAR(std::sqrt(static_cast<double>(bench.tracker.covariance[i][i])), deviation,
                    0.01 * deviation)
            << i;
    }
}

TEST(PlanarTracker, leavesOutTheChipsThatAreNotUsed) {
    Bench bench;
    bench.start({6.35e-3, -6.35e-3, 0.0});
    const hb_tracker before = bench.tracker;
    const Fields fields = single(fieldsAt(bench.sensing, {6.5e-3, -6.2e-3, 1e-4}));
    EXPECT_EQ(
        hb_tracker_update(&bench.tracker, &bench.page.chips, bench.page.coils.pitch_m, fields.data(), 0),
        0.0F);
    for (int i = 0; i < HB_TRACKER_STATES; ++i) {
        EXPECT_EQ(bench.tracker.mean[i], before.mean[i]);
    }
}

} // namespace
} // namespace halbench::devices::firmware
