#include "control/base/random.h"
#include "models/planar/current_allocation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::models {
namespace {

const PlanarGeometry Nominal;
const double Pitch_m = Nominal.matrix.pitch_m;
constexpr double Resistance_Ohm = 1.98;

PlanarPose randomPose(Random& random, double angle_rad) {
    return {0.1 * (random.uniform() - 0.5), 0.1 * (random.uniform() - 0.5),
            2.0 * angle_rad * (random.uniform() - 0.5)};
}

PlanarWrench randomWrench(Random& random) {
    return {2.0 * (random.uniform() - 0.5), 2.0 * (random.uniform() - 0.5), 0.08 * (random.uniform() - 0.5)};
}

double distance(const PlanarWrench& a, const PlanarWrench& b) {
    return (vectorOf(a) - vectorOf(b)).norm();
}

TEST(CurrentAllocation, meetsTheCheckValues) {
    const CoilCurrents_A current_A =
        setWiseCurrents_A(PublishedWrench(Nominal, -3.09772), {2e-3, -3e-3, 0.0}, {0.5, -0.2, 0.01});
    const double expected_A[] = {-0.1548378, 0.0669588, -0.0413322, 0.0955779, -0.1359387, 0.0870259};
    for (int k = 0; k < CoilCount; ++k) {
        EXPECT_NEAR(current_A(k), expected_A[k], 3e-7); // the force constant is printed to 1.6e-6 of itself
    }
    EXPECT_NEAR(Resistance_Ohm * current_A.squaredNorm(), 0.129402, 1e-6);
}

TEST(CurrentAllocation, setWiseIsTheLeastNormOfThePublishedModelWithoutLift) {
    const PublishedWrench model(Nominal);
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const PlanarPose pose = randomPose(random, 0.02);
        const PlanarWrench wrench = randomWrench(random);
        const CoilCurrents_A setWise_A = setWiseCurrents_A(model, pose, wrench);
        const auto least_A = leastNormCurrents_A(model.at(pose), wrench);
        ASSERT_TRUE(least_A);
        EXPECT_LT((setWise_A - *least_A).cwiseAbs().maxCoeff(), 1e-14);
        const Eigen::Matrix<double, CoilCount, 1> lift_N =
            model.at(pose).lift_N_per_A.transpose().cwiseProduct(setWise_A);
        for (int set = 0; set < 3; ++set) {
            EXPECT_NEAR(lift_N(2 * set) + lift_N(2 * set + 1), 0.0, 1e-14);
        }
    }
}

TEST(CurrentAllocation, everyMethodIsExactOnItsOwnModel) {
    Random random(2);
    for (const AllocationMethod method :
         {AllocationMethod::SetWise, AllocationMethod::HeadingFundamental, AllocationMethod::Full}) {
        const CurrentAllocator allocator(method, Nominal, -3.2, 10.0);
        for (int i = 0; i < 100; ++i) {
            const PlanarPose pose = randomPose(random, 0.02);
            const PlanarWrench wrench = randomWrench(random);
            const Allocation allocation = allocator.allocate(pose, wrench);
            EXPECT_FALSE(allocation.isLimited);
            EXPECT_LT(distance(allocator.wrench(pose, allocation.current_A), wrench), 1e-13);
        }
    }
}

TEST(CurrentAllocation, fullAllocationIsExactOnTheDevice) {
    const WindingsWrench device(Nominal);
    const CurrentAllocator allocator(AllocationMethod::Full, Nominal, windingsForceConstant_N_per_A(Nominal),
                                     10.0);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const PlanarPose pose = randomPose(random, 0.02);
        const PlanarWrench wrench = randomWrench(random);
        const CoilCurrents_A current_A = allocator.allocate(pose, wrench).current_A;
        EXPECT_LT((device.at(pose).wrench * current_A - vectorOf(wrench)).norm(), 1e-13);
    }
}

TEST(CurrentAllocation, powersAreThoseOfTheTheoryAtEveryPlace) {
    const CurrentAllocator allocator(AllocationMethod::SetWise, Nominal, -3.09772, 10.0);
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        const PlanarPose pose = randomPose(random, 0.0);
        const auto power_W = [&](const PlanarWrench& wrench) {
            return Resistance_Ohm * allocator.allocate(pose, wrench).current_A.squaredNorm();
        };
        EXPECT_NEAR(power_W({1.0, 0.0, 0.0}), 0.3464, 5e-5);
        EXPECT_NEAR(power_W({0.0, 1.0, 0.0}), 0.1032, 5e-5);
        EXPECT_NEAR(power_W({0.0, 0.0, 0.04}), 0.1137, 5e-5);
    }
}

TEST(CurrentAllocation, oneAmpereGivesTheForcesOfTheTheoryEverywhere) {
    // Worst place: one coil of each set carries the whole force.
    const CurrentAllocator allocator(AllocationMethod::SetWise, Nominal, -3.09772, 1.0);
    double x = 10.0;
    double y = 10.0;
    double torque = 10.0;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            // The phases of the table: zeros of chi and psi lie on this grid.
            const PlanarPose pose{1.25 * Pitch_m - Nominal.winding.width_m + Pitch_m * i / 40,
                                  1.25 * Pitch_m - Nominal.arm56_m + Pitch_m * j / 40, 0.0};
            // Fx needs its own torque cancelled: set 5-6 alone limits it.
            x = std::min(x, 10.0 * allocator.allocate(pose, {10.0, 0.0, -Nominal.arm56_m * 10.0}).scale);
            y = std::min(y, 10.0 * allocator.allocate(pose, {0.0, 10.0, 0.0}).scale);
            torque = std::min(torque, allocator.allocate(pose, {0.0, 0.0, 1.0}).scale);
        }
    }
    EXPECT_NEAR(x, 3.098, 5e-4);
    EXPECT_NEAR(y, 6.195, 1e-3);
    EXPECT_NEAR(torque, 0.2360, 1e-4);
}

TEST(CurrentAllocation, theLimitScalesAllCurrentsTogether) {
    const CurrentAllocator allocator(AllocationMethod::Full, Nominal, windingsForceConstant_N_per_A(Nominal),
                                     1.0);
    const PlanarPose pose{3e-3, -4e-3, 5e-3};
    const PlanarWrench asked{8.0, -3.0, 0.1};
    const Allocation allocation = allocator.allocate(pose, asked);
    EXPECT_TRUE(allocation.isLimited);
    EXPECT_NEAR(allocation.current_A.cwiseAbs().maxCoeff(), 1.0, 1e-15);
    EXPECT_LT(
        (vectorOf(allocator.wrench(pose, allocation.current_A)) - allocation.scale * vectorOf(asked)).norm(),
        1e-13);
}

TEST(CurrentAllocation, refusesCoilsThatCannotPush) {
    CoilWrench coils = PublishedWrench(Nominal).at({});
    coils.wrench.row(0).setZero();
    EXPECT_FALSE(leastNormCurrents_A(coils, {1.0, 0.0, 0.0}));
}

// Largest errors over one cell when `allocator` drives `device`: Fx, Fy in N, Tz in N m, total lift in N.
struct WorstErrors {
    Eigen::Vector3d wrench = Eigen::Vector3d::Zero();
    double lift_N = 0.0;
};

WorstErrors worstErrors(const WrenchMap& device, const CurrentAllocator& allocator,
                        const PlanarWrench& demand, double angle_rad) {
    constexpr int Steps = 40;
    WorstErrors worst;
    for (int i = 0; i < Steps; ++i) {
        for (int j = 0; j < Steps; ++j) {
            const PlanarPose pose{Pitch_m * i / Steps, Pitch_m * j / Steps, angle_rad};
            const CoilCurrents_A current_A = allocator.allocate(pose, demand).current_A;
            const CoilWrench coils = device.at(pose);
            const Eigen::Vector3d error = coils.wrench * current_A - vectorOf(demand);
            worst.wrench = worst.wrench.cwiseMax(error.cwiseAbs());
            worst.lift_N = std::fmax(worst.lift_N, std::fabs(coils.lift_N_per_A * current_A));
        }
    }
    return worst;
}

struct ErrorRow {
    double angle_rad;
    WrenchModel device;
    double x[3], y[3], turn[3]; ///< mN, mN, mN m for the demands Fx 1 N, Fy 1 N, Tz 40 mN m
};

TEST(CurrentAllocation, errorsOfThePublishedModelAreThoseOfTheTable) {
    // Theory section 5.4: two digits, and worst places of another grid, between whose nodes the ninth order
    // (period L/10 together with the currents) hides up to 5 %.
    const ErrorRow rows[] = {
        {0.0, WrenchModel::Prism, {9.5, 0, 0.84}, {0, 9.4, 0}, {0, 0, 0.38}},
        {0.0, WrenchModel::Windings, {12.9, 2.9, 0.95}, {0, 9.7, 0}, {3.0, 0, 0.47}},
        {5e-3, WrenchModel::Windings, {13.1, 4.2, 1.13}, {0, 9.8, 0.25}, {3.0, 1.2, 0.51}},
        {10e-3, WrenchModel::Prism, {13.0, 6.5, 1.22}, {1.0, 10.2, 0.62}, {0.2, 5.1, 0.55}},
        {10e-3, WrenchModel::Windings, {14.1, 5.4, 1.29}, {0, 10.5, 0.50}, {2.9, 2.4, 0.58}}};
    for (const ErrorRow& row : rows) {
        const double b = row.device == WrenchModel::Prism ? publishedForceConstant_N_per_A(Nominal)
                                                          : windingsForceConstant_N_per_A(Nominal);
        const CurrentAllocator allocator(AllocationMethod::SetWise, Nominal, b, 10.0);
        const WrenchMap device(row.device, Nominal);
        const std::pair<PlanarWrench, const double*> demands[] = {
            {{1.0, 0.0, 0.0}, row.x}, {{0.0, 1.0, 0.0}, row.y}, {{0.0, 0.0, 0.04}, row.turn}};
        for (const auto& [demand, expected] : demands) {
            const WorstErrors worst = worstErrors(device, allocator, demand, row.angle_rad);
            const double half[] = {0.051, 0.051, 0.0051};
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(1e3 * worst.wrench(i), expected[i], 0.05 * expected[i] + half[i])
                    << row.angle_rad << " rad, demand " << demand.forceX_N << ' ' << demand.forceY_N
                    << ", row " << i;
            }
        }
    }
}

TEST(CurrentAllocation, headingTakesMostOfTheCrossErrorsAway) {
    // Section 5.4, last paragraph: full device at 10 mrad, fundamental only; tolerances as above.
    const WrenchMap device(WrenchModel::Windings, Nominal);
    const CurrentAllocator aware(AllocationMethod::HeadingFundamental, Nominal,
                                 windingsForceConstant_N_per_A(Nominal), 10.0);
    EXPECT_NEAR(1e3 * worstErrors(device, aware, {1.0, 0.0, 0.0}, 0.01).wrench(1), 2.3, 0.12);
    EXPECT_NEAR(1e3 * worstErrors(device, aware, {0.0, 1.0, 0.0}, 0.01).wrench(2), 0.08, 0.009);
    EXPECT_NEAR(1e3 * worstErrors(device, aware, {0.0, 0.0, 0.04}, 0.01).wrench(0), 0.25, 0.018);
}

} // namespace
} // namespace halbench::models
