#include "control/base/random.h"
#include "models/planar/planar_parameters.h"
#include "models/planar/pose_estimator.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::models {
namespace {

const PlanarParameters Parameters;
const PoseSensing Sensing = nominalSensing(Parameters);
const double Pitch_m = Parameters.geometry.matrix.pitch_m;

ChipFields_T fieldsAt(const PlanarPose& pose, const PoseSensing& sensing = Sensing) {
    ChipFields_T field_T;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        field_T.segment<2>(2 * static_cast<Eigen::Index>(j)) =
            chipField_T(sensing.waveNumber_per_m, sensing.amplitude_T[j], sensing.place_m[j], pose);
    }
    return field_T;
}

ChipFields_T noisyFieldsAt(const PlanarPose& pose, Random& random) {
    ChipFields_T field_T = fieldsAt(pose);
    for (int i = 0; i < FieldCount; ++i) {
        field_T(i) += Sensing.deviation_T * random.gaussian();
    }
    return field_T;
}

PlanarPose randomPose(Random& random) {
    return {0.1 * (random.uniform() - 0.5), 0.1 * (random.uniform() - 0.5), 0.04 * (random.uniform() - 0.5)};
}

double deviation(const PoseEstimate& estimate, int axis) {
    return std::sqrt(estimate.covariance(axis, axis));
}

TEST(PoseEstimator, startIsTheTwoArctangentsOfTheTheory) {
    const double gamma = Sensing.waveNumber_per_m;
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const ChipFields_T B = noisyFieldsAt(randomPose(random), random);
        const double mean_T = 0.5 * (B(1) + B(3));
        const auto start = startPose(Sensing, B);
        ASSERT_TRUE(start);
        // Section 7; the layout is exact quadrature, so both are the same least squares: rounding.
        EXPECT_NEAR(start->x_m, std::atan2(B(4), 0.5 * (B(2) - B(0))) / gamma, 1e-14);
        EXPECT_NEAR(start->y_m, std::atan2(-(B(5) + mean_T), B(5) - mean_T) / gamma, 1e-14);
    }
}

TEST(PoseEstimator, startNeedsQuadratureInBothDirections) {
    const ChipFields_T B = fieldsAt({3e-3, 5e-3, 0.0});
    // Chips 1 and 2 are 2.5 pitches apart: no quadrature in x.
    EXPECT_FALSE(startPose(Sensing, B, {true, true, false}));
    EXPECT_TRUE(startPose(Sensing, B, {true, false, true}));
}

TEST(PoseEstimator, findsEveryPoseExactlyWithoutNoise) {
    Random random(21);
    for (int i = 0; i < 300; ++i) {
        const PlanarPose pose = randomPose(random);
        const ChipFields_T B = fieldsAt(pose);
        const PlanarPose start = inNearestCell(*startPose(Sensing, B), pose, Pitch_m);
        const PoseEstimate estimate = estimatePose(Sensing, B, start);
        ASSERT_EQ(estimate.verdict, PoseVerdict::Determined);
        // The last step was below 10 nm; with no residual the error after it is its square times gamma.
        EXPECT_NEAR(estimate.pose.x_m, pose.x_m, 1e-13);
        EXPECT_NEAR(estimate.pose.y_m, pose.y_m, 1e-13);
        EXPECT_NEAR(estimate.pose.angle_rad, pose.angle_rad, 2e-12);
        EXPECT_EQ(estimate.freedom, 3);
    }
}

TEST(PoseEstimator, noisyPosesHaveTheStatisticsOfTheirCovariance) {
    Random random(77);
    const int count = 1000;
    double chiSquare = 0.0;
    double normalised = 0.0;
    for (int i = 0; i < count; ++i) {
        const PlanarPose pose = randomPose(random);
        const ChipFields_T B = noisyFieldsAt(pose, random);
        const PlanarPose start = inNearestCell(*startPose(Sensing, B), pose, Pitch_m);
        const PoseEstimate estimate = estimatePose(Sensing, B, start);
        ASSERT_EQ(estimate.verdict, PoseVerdict::Determined);
        const Eigen::Vector3d error(estimate.pose.x_m - pose.x_m, estimate.pose.y_m - pose.y_m,
                                    estimate.pose.angle_rad - pose.angle_rad);
        normalised += error.dot(estimate.covariance.inverse() * error);
        chiSquare += estimate.chiSquare;
    }
    // Both are chi-square of 3 degrees of freedom: mean 3, spread of the mean sqrt(6/1000) = 0.077; four of
    // them.
    EXPECT_NEAR(chiSquare / count, 3.0, 0.31);
    EXPECT_NEAR(normalised / count, 3.0, 0.31);
}

TEST(PoseEstimator, covarianceAtTheStartPoseIsTheBoundOfTheTheory) {
    const PlanarPose pose{6.35e-3, -6.35e-3, 0.0};
    const PoseEstimate estimate = estimatePose(Sensing, fieldsAt(pose), pose);
    EXPECT_NEAR(deviation(estimate, 0), 5.99e-6, 0.005e-6);
    EXPECT_NEAR(deviation(estimate, 1), 5.15e-6, 0.005e-6);
    EXPECT_NEAR(deviation(estimate, 2), 73.3e-6, 0.05e-6);
}

TEST(PoseEstimator, covarianceOverOneCellIsThatOfTheTheory) {
    std::array<std::vector<double>, 3> deviations;
    const int steps = 40; // the grid of the theory's numbers: centres of 40 x 40 squares
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const PlanarPose pose{Pitch_m * (i + 0.5) / steps, Pitch_m * (j + 0.5) / steps, 0.0};
            const PoseEstimate estimate = estimatePose(Sensing, fieldsAt(pose), pose);
            ASSERT_EQ(estimate.verdict, PoseVerdict::Determined);
            for (int axis = 0; axis < 3; ++axis) {
                deviations[static_cast<std::size_t>(axis)].push_back(deviation(estimate, axis));
            }
        }
    }
    // Section 7, printed with two or three digits.
    const double expected[3][3] = {
        {5.4e-6, 6.3e-6, 13e-6}, {5.2e-6, 6.0e-6, 8.4e-6}, {72e-6, 109e-6, 563e-6}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::sort(deviations[axis].begin(), deviations[axis].end());
        EXPECT_NEAR(deviations[axis].front(), expected[axis][0], 0.02 * expected[axis][0]);
        EXPECT_NEAR(deviations[axis][deviations[axis].size() / 2], expected[axis][1],
                    0.03 * expected[axis][1]);
        EXPECT_NEAR(deviations[axis].back(), expected[axis][2], 0.01 * expected[axis][2]);
    }
}

TEST(PoseEstimator, aThirdChipInLineWithTheFirstLosesXOnWholeLines) {
    // Section 7: offset 127 mm (or 0) of chip 3 against chip 1 leaves no quadrature in x.
    PoseSensing sensing = Sensing;
    sensing.place_m[2].x() = sensing.place_m[1].x();
    const double lost_m = 0.25 * Pitch_m - sensing.place_m[0].x();
    const PlanarPose lost{lost_m, 2e-3, 0.0};
    EXPECT_EQ(estimatePose(sensing, fieldsAt(lost, sensing), lost).verdict, PoseVerdict::NotDetermined);
    const PlanarPose seen{lost_m + 0.25 * Pitch_m, 2e-3, 0.0};
    EXPECT_EQ(estimatePose(sensing, fieldsAt(seen, sensing), seen).verdict, PoseVerdict::Determined);
    EXPECT_EQ(estimatePose(Sensing, fieldsAt(lost), lost).verdict, PoseVerdict::Determined);
}

TEST(PoseEstimator, oneChipDeterminesNoPose) {
    const PlanarPose pose{3e-3, 5e-3, 0.0};
    EXPECT_EQ(estimatePose(Sensing, fieldsAt(pose), pose, {true, false, false}).verdict,
              PoseVerdict::NotDetermined);
}

TEST(PoseEstimator, correctionUndoesErrorsAndCrosstalk) {
    PoseSensing sensing = Sensing;
    Random random(4);
    CoilCurrents_A current_A;
    for (int k = 0; k < CoilCount; ++k) {
        current_A(k) = random.uniform() - 0.5;
        for (int i = 0; i < FieldCount; ++i) {
            sensing.crosstalk_T_per_A(i, k) = 6e-4 * random.gaussian();
        }
    }
    const ChipFields_T field_T = fieldsAt({1e-3, 2e-3, 3e-3});
    ChipFields_T reading_T = sensing.crosstalk_T_per_A * current_A;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        sensing.sensitivity[j] << 1.01, 0.004, -0.003, 0.985;
        sensing.offset_T[j] = {1e-4, -2e-4};
        const auto row = 2 * static_cast<Eigen::Index>(j);
        reading_T.segment<2>(row) += sensing.sensitivity[j] * field_T.segment<2>(row) + sensing.offset_T[j];
    }
    EXPECT_LT((correctedFields_T(sensing, reading_T, current_A) - field_T).norm(), 1e-16);
}

TEST(PoseEstimator, pitchesAreCountedFromTheLastPose) {
    const PlanarPose near{2.6 * Pitch_m, -1.4 * Pitch_m, 0.0};
    const PlanarPose counted = inNearestCell({-0.45 * Pitch_m, 0.49 * Pitch_m, 1e-3}, near, Pitch_m);
    EXPECT_NEAR(counted.x_m, 2.55 * Pitch_m, 1e-15);
    EXPECT_NEAR(counted.y_m, -1.51 * Pitch_m, 1e-15);
    EXPECT_EQ(counted.angle_rad, 1e-3);
}

TEST(PoseEstimator, refusesReadingsThatNoPoseExplains) {
    // Fields three times the amplitude lead far away or nowhere; never to a believed pose.
    const PlanarPose pose{3e-3, 5e-3, 0.0};
    const CheckedPose checked = estimateChecked(Sensing, 3.0 * fieldsAt({15e-3, -9e-3, 0.0}), pose);
    EXPECT_EQ(checked.verdict, ChipVerdict::NoPose);
}

TEST(PoseEstimator, healthyChipsAreAllUsed) {
    Random random(6);
    for (int i = 0; i < 300; ++i) {
        const PlanarPose pose = randomPose(random);
        const CheckedPose checked = estimateChecked(Sensing, noisyFieldsAt(pose, random), pose);
        EXPECT_EQ(checked.verdict, ChipVerdict::AllUsed);
    }
}

TEST(PoseEstimator, leavesADeadChipOutWhereTheOthersDetermineThePose) {
    Random random(8);
    int leftOut = 0;
    int wrong = 0;
    const int count = 600;
    for (int i = 0; i < count; ++i) {
        const PlanarPose pose = randomPose(random);
        const int dead = i % ChipCount;
        ChipFields_T B = noisyFieldsAt(pose, random);
        B.segment<2>(2 * dead).setZero();
        const PlanarPose predicted{pose.x_m + 3e-6, pose.y_m - 2e-6, pose.angle_rad + 2e-5};
        const CheckedPose checked = estimateChecked(Sensing, B, predicted);
        if (checked.verdict == ChipVerdict::OneLeftOut) {
            ++leftOut;
            EXPECT_FALSE(checked.used[static_cast<std::size_t>(dead)]);
            const Eigen::Vector3d error(checked.estimate.pose.x_m - pose.x_m,
                                        checked.estimate.pose.y_m - pose.y_m,
                                        checked.estimate.pose.angle_rad - pose.angle_rad);
            // 600 draws of chi-square with 3 degrees of freedom: beyond 30 with a probability of 1e-3.
            EXPECT_LT(error.dot(checked.estimate.covariance.inverse() * error), 30.0);
        } else if (checked.verdict == ChipVerdict::AllUsed) {
            ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0);
    // Where two chips lose a direction no pose is given. The share that keeps one is at least a half.
    EXPECT_GT(leftOut, count / 2);
}

TEST(PoseEstimator, withoutTheThirdChipXIsLostWhereTheOthersHaveNoSlope) {
    ChipMask used = AllChips;
    used[2] = false;
    const double lost_m = 0.25 * Pitch_m - Sensing.place_m[0].x();
    const PlanarPose lost{lost_m, 2e-3, 0.0};
    EXPECT_EQ(estimateChecked(Sensing, fieldsAt(lost), lost, {}, used).verdict, ChipVerdict::NoPose);
    const PlanarPose seen{lost_m + 0.25 * Pitch_m, 2e-3, 0.0};
    const CheckedPose checked = estimateChecked(Sensing, fieldsAt(seen), seen, {}, used);
    EXPECT_EQ(checked.verdict, ChipVerdict::OneLeftOut);
    EXPECT_EQ(checked.used, used);
}

} // namespace
} // namespace halbench::models
