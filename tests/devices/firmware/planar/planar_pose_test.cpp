#include "control/base/random.h"
#include "devices/firmware/planar/hb_planar_pose.h"
#include "tests/devices/firmware/planar/planar_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Figures of resources/help/planar-theory.md section 7.

namespace halbench::devices::firmware {
namespace {

/// Single precision: phases up to 9 rad and fields of 20 mT are rounded by 5e-7 rad and 1 nT, which move a
/// pose by 4 nm and 0.5 nm; worst geometry (563 against 72 urad) eight times that.
constexpr double Rounding_m = 4e-8;

struct Bench {
    hb_planar_calibration page = initialCalibration();
    models::PoseSensing sensing = sensingOf(page);

    hb_pose_estimate fit(const Fields& fields, std::uint8_t used = HB_ALL_CHIPS) const {
        hb_pose start;
        EXPECT_EQ(hb_pose_start(&page.chips, page.coils.pitch_m, fields.data(), used, &start), 1);
        return hb_pose_fit(&page.chips, page.coils.pitch_m, fields.data(), &start, used);
    }
    void setDeviation(double deviation_T) {
        page.chips.deviation_T = static_cast<float>(deviation_T);
        sensing.deviation_T = deviation_T;
    }
};

void expectPose(const hb_pose& pose, double x_m, double y_m, double angle_rad) {
    EXPECT_NEAR(static_cast<double>(pose.x_m), x_m, Rounding_m);
    EXPECT_NEAR(static_cast<double>(pose.y_m), y_m, Rounding_m);
    EXPECT_NEAR(static_cast<double>(pose.phi_rad), angle_rad, Rounding_m / 0.05);
}

TEST(PlanarPose, followsFromTheReadingsOfTheTheory) {
    const Bench bench;
    const Fields still{-19.3911973e-3F, -8.0517890e-3F, 19.3911973e-3F,
                       -8.0517890e-3F,  4.8970876e-3F,  18.3076130e-3F};
    hb_pose start;
    ASSERT_EQ(hb_pose_start(&bench.page.chips, bench.page.coils.pitch_m, still.data(), HB_ALL_CHIPS, &start),
              1);
    expectPose(start, 2e-3, -3e-3, 0.0); // exact without rotation
    const hb_pose_estimate atRest = bench.fit(still);
    EXPECT_EQ(atRest.is_determined, 1);
    expectPose(atRest.pose, 2e-3, -3e-3, 0.0);
    const Fields turned{-6.3433533e-3F,  -18.7137777e-3F, 6.0469347e-3F,
                        -19.5325259e-3F, 18.8134548e-3F,  5.5827933e-3F};
    const hb_pose_estimate rotated = bench.fit(turned);
    EXPECT_EQ(rotated.is_determined, 1);
    expectPose(rotated.pose, 10e-3, 4e-3, 8e-3);
}

TEST(PlanarPose, isFoundAtAThousandRandomPlacesWithTheSpreadOfTheNoise) {
    Bench bench;
    bench.setDeviation(18e-6);
    Random random(7);
    double sum = 0.0;
    constexpr int Poses = 1000;
    for (int i = 0; i < Poses; ++i) {
        const models::PlanarPose pose{within(random, 25e-3), within(random, 25e-3), within(random, 20e-3)};
        models::ChipFields_T fields = fieldsAt(bench.sensing, pose);
        for (Eigen::Index k = 0; k < fields.size(); ++k) {
            fields(k) += 18e-6 * random.gaussian();
        }
        const hb_pose_estimate found = bench.fit(single(fields));
        ASSERT_EQ(found.is_determined, 1) << pose.x_m << " " << pose.y_m << " " << pose.angle_rad;
        // The same estimate in double precision, which knows its covariance.
        const models::PoseEstimate exact = models::estimatePose(bench.sensing, fields, pose);
        const models::PlanarPose nearest =
            models::inNearestCell({static_cast<double>(found.pose.x_m), static_cast<double>(found.pose.y_m),
                                   static_cast<double>(found.pose.phi_rad)},
                                  pose, bench.sensing.pitch_m());
        EXPECT_NEAR(nearest.x_m, exact.pose.x_m, Rounding_m);
        EXPECT_NEAR(nearest.y_m, exact.pose.y_m, Rounding_m);
        EXPECT_NEAR(nearest.angle_rad, exact.pose.angle_rad, Rounding_m / 0.05);
        EXPECT_NEAR(static_cast<double>(found.chi_square), exact.chiSquare, 1e-2 + 1e-2 * exact.chiSquare);
        const Eigen::Vector3d error(nearest.x_m - pose.x_m, nearest.y_m - pose.y_m,
                                    nearest.angle_rad - pose.angle_rad);
        sum += error.dot(exact.covariance.inverse() * error);
    }
    // Chi-square of 3000 degrees of freedom: five standard deviations are 5 sqrt(2/3000) = 13 %.
    EXPECT_NEAR(sum / (3.0 * Poses), 1.0, 0.13);
}

/// Largest minus smallest error of x over one pitch of travel along x, and of the angle, when the fields are
/// read wrongly.
template <typename Wrong>
std::pair<double, double> periodicError(const Wrong& readWrongly) {
    const Bench bench;
    std::array<double, 2> x_m{1.0, -1.0};
    std::array<double, 2> phi_rad{1.0, -1.0};
    for (int step = 0; step < 200; ++step) {
        const models::PlanarPose pose{bench.sensing.pitch_m() * (step / 200.0 - 0.5), -6.35e-3, 0.0};
        models::ChipFields_T fields = fieldsAt(bench.sensing, pose);
        readWrongly(fields);
        const Fields wrong = single(fields);
        const hb_pose start{static_cast<float>(pose.x_m), static_cast<float>(pose.y_m), 0.0F};
        const hb_pose_estimate found =
            hb_pose_fit(&bench.page.chips, bench.page.coils.pitch_m, wrong.data(), &start, HB_ALL_CHIPS);
        const double error_m = static_cast<double>(found.pose.x_m) - pose.x_m;
        x_m = {std::min(x_m[0], error_m), std::max(x_m[1], error_m)};
        phi_rad = {std::min(phi_rad[0], static_cast<double>(found.pose.phi_rad)),
                   std::max(phi_rad[1], static_cast<double>(found.pose.phi_rad))};
    }
    return {x_m[1] - x_m[0], phi_rad[1] - phi_rad[0]};
}

TEST(PlanarPose, hasThePeriodicErrorOfAWrongCalibration) {
    // Chip 3, the only one with quadrature in x: 1 % of gain make 57 um and 0.4 mrad peak to peak, 0.1 mT of
    // offset 81 um; printed with two digits and one.
    const auto gain = periodicError([](models::ChipFields_T& fields) { fields(4) *= 1.01; });
    EXPECT_NEAR(gain.first, 57e-6, 1e-6);
    EXPECT_NEAR(gain.second, 0.4e-3, 0.05e-3);
    const auto offset = periodicError([](models::ChipFields_T& fields) { fields(4) += 1e-4; });
    EXPECT_NEAR(offset.first, 81e-6, 1e-6);
}

TEST(PlanarPose, doesNotChangeWhenThePlatenMovesByAPitch) {
    const Bench bench;
    const models::PlanarPose pose{7e-3, 11e-3, 4e-3};
    const Fields here = single(fieldsAt(bench.sensing, pose));
    const Fields there =
        single(fieldsAt(bench.sensing, {pose.x_m + bench.sensing.pitch_m(),
                                        pose.y_m - bench.sensing.pitch_m(), pose.angle_rad}));
    for (std::size_t i = 0; i < here.size(); ++i) {
        EXPECT_NEAR(here[i], there[i], 2e-9F) << i; // 20 mT in single precision
    }
    expectPose(bench.fit(there).pose, pose.x_m, pose.y_m, pose.angle_rad);
}

TEST(PlanarPose, leavesOutTheChipThatContradicts) {
    Bench bench;
    bench.setDeviation(18e-6);
    const models::PlanarPose pose{2e-3, -3e-3, 0.0};
    const hb_pose predicted{2.05e-3F, -3.02e-3F, 1e-4F};
    const Fields healthy = single(fieldsAt(bench.sensing, pose));
    const auto check = [&](const Fields& fields, std::uint8_t trusted = HB_ALL_CHIPS) {
        return hb_pose_check(&bench.page.chips, bench.page.coils.pitch_m, fields.data(), &predicted, trusted,
                             0.5e-3F);
    };
    EXPECT_EQ(check(healthy).verdict, HB_CHIPS_AGREE);
    // Without chip 3 nothing tells x (chips 1 and 2 are 2.5 pitches apart), without 1 or 2 the others do.
    for (const std::size_t dead : {std::size_t{0}, std::size_t{1}}) {
        Fields fields = healthy;
        fields[2 * dead] = fields[2 * dead + 1] = 0.0F;
        const hb_checked_pose found = check(fields);
        EXPECT_EQ(found.verdict, HB_CHIP_LEFT_OUT) << dead;
        EXPECT_EQ(found.used, HB_ALL_CHIPS & ~(1U << dead));
        expectPose(found.estimate.pose, pose.x_m, pose.y_m, 0.0);
    }
    Fields fields = healthy;
    fields[0] = fields[1] = fields[2] = fields[3] = 0.0F;
    EXPECT_EQ(check(fields).verdict, HB_CHIPS_CONTRADICT);
    EXPECT_EQ(check(healthy, 1U).verdict, HB_CHIPS_CONTRADICT); // one chip alone
    const hb_pose far{2.05e-3F + 1e-3F, -3.02e-3F, 0.0F};       // a pose that is farther than a tick goes
    EXPECT_EQ(hb_pose_check(&bench.page.chips, bench.page.coils.pitch_m, healthy.data(), &far, HB_ALL_CHIPS,
                            0.5e-3F)
                  .verdict,
              HB_CHIPS_CONTRADICT);
}

TEST(PlanarPose, correctsGainsOffsetsCrossAxisAndCrosstalk) {
    Bench bench;
    const models::ChipFields_T fields = fieldsAt(bench.sensing, {10e-3, 4e-3, 8e-3});
    const float currents_A[HB_COILS] = {0.5F, -0.25F, 0.75F, 0.1F, -1.0F, 0.3F};
    models::ChipFields_T readings = fields;
    for (int j = 0; j < HB_CHIPS; ++j) {
        hb_chips& chips = bench.page.chips;
        chips.gain_x[j] = 0.01F * static_cast<float>(j + 1);
        chips.gain_y[j] = -0.02F;
        chips.cross_xy[j] = 0.005F;
        chips.cross_yx[j] = -0.003F * static_cast<float>(j);
        chips.offset_x_T[j] = 1e-4F;
        chips.offset_y_T[j] = -2e-4F;
        Eigen::Matrix2d sensitivity;
        sensitivity << 1.0 + 0.01 * (j + 1), 0.005, -0.003 * j, 0.98;
        readings.segment<2>(2 * j) = sensitivity * fields.segment<2>(2 * j) + Eigen::Vector2d(1e-4, -2e-4);
    }
    for (int i = 0; i < HB_CHIP_FIELDS; ++i) {
        for (int k = 0; k < HB_COILS; ++k) {
            const double share = 1e-4 * (i + 1) - 5e-5 * k;
            bench.page.chips.crosstalk_T_per_A[i * HB_COILS + k] = static_cast<float>(share);
            readings(i) += share * static_cast<double>(currents_A[k]);
        }
    }
    Fields corrected = single(readings);
    hb_chips_correct(&bench.page.chips, corrected.data(), currents_A);
    for (std::size_t i = 0; i < corrected.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(corrected[i]), fields(static_cast<Eigen::Index>(i)), 5e-9) << i;
    }
}

} // namespace
} // namespace halbench::devices::firmware
