#include "control/base/random.h"
#include "devices/firmware/planar/hb_planar_wrench.h"
#include "tests/devices/firmware/planar/planar_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Figures of resources/help/planar-theory.md sections 5 and 6.

namespace halbench::devices::firmware {
namespace {

using Currents = std::array<float, HB_COILS>;

const hb_pose Pose{2e-3F, -3e-3F, 0.0F};

hb_planar_coils published() {
    return initialCalibration().coils; // b = -3.09772 N/A
}

TEST(PlanarWrench, ofOneAmpereIsThatOfTheTheory) {
    constexpr double Fx[] = {0, 0, 0, 0, -2.6089033, 1.6701813};
    constexpr double Fy[] = {2.8432530, -1.2295505, -1.2295505, 2.8432530, 0, 0};
    constexpr double Tz[] = {-0.1083279, 0.0468459, -0.0468459, 0.1083279, 0.1158353, -0.0741561};
    const hb_planar_coils coils = published();
    for (std::size_t k = 0; k < HB_COILS; ++k) {
        Currents current{};
        current[k] = 1.0F;
        const hb_wrench wrench = hb_planar_wrench(&coils, &Pose, current.data());
        // The force constant is printed with six digits: 2e-6 of 3 N.
        EXPECT_NEAR(static_cast<double>(wrench.x_N), Fx[k], 6e-6) << k;
        EXPECT_NEAR(static_cast<double>(wrench.y_N), Fy[k], 6e-6) << k;
        EXPECT_NEAR(static_cast<double>(wrench.torque_Nm), Tz[k], 6e-7) << k;
    }
}

TEST(PlanarWrench, isAllocatedSetBySet) {
    constexpr double Expected_A[] = {-0.1548378, 0.0669588, -0.0413322, 0.0955779, -0.1359387, 0.0870259};
    const hb_planar_coils coils = published();
    const hb_wrench wrench{0.5F, -0.2F, 0.01F};
    Currents current{};
    hb_planar_allocate(&coils, &Pose, &wrench, current.data());
    double power_W = 0.0;
    for (std::size_t k = 0; k < HB_COILS; ++k) {
        EXPECT_NEAR(static_cast<double>(current[k]), Expected_A[k], 5e-7) << k;
        power_W += 1.98 * std::pow(static_cast<double>(current[k]), 2.0);
    }
    EXPECT_NEAR(power_W, 0.129402, 1e-6);
}

TEST(PlanarWrench, comesBackFromItsCurrentsWithoutVerticalForce) {
    Random random(3);
    const hb_planar_coils coils = published();
    for (int i = 0; i < 1000; ++i) {
        const hb_pose pose{static_cast<float>(within(random, 0.05)), static_cast<float>(within(random, 0.05)),
                           0.0F};
        const hb_wrench wrench{static_cast<float>(within(random, 2.0)),
                               static_cast<float>(within(random, 2.0)),
                               static_cast<float>(within(random, 0.1))};
        Currents current{};
        hb_planar_allocate(&coils, &pose, &wrench, current.data());
        const hb_wrench back = hb_planar_wrench(&coils, &pose, current.data());
        ASSERT_NEAR(back.x_N, wrench.x_N, 2e-6F); // some roundings of 4 N
        ASSERT_NEAR(back.y_N, wrench.y_N, 2e-6F);
        ASSERT_NEAR(back.torque_Nm, wrench.torque_Nm, 2e-7F);
        ASSERT_NEAR(hb_planar_lift_N(&coils, &pose, current.data()), 0.0F, 2e-6F);
    }
}

TEST(PlanarWrench, liftsAsTheTheorySays) {
    const hb_planar_coils coils = published();
    // -b sin psi and -b cos psi at psi = -2.73343298 for coils 1 and 2, chi = -6.85262990 for 5 and 6.
    constexpr double b = -3.09772;
    const double expected[] = {-b * std::sin(-2.73343298), -b * std::cos(-2.73343298),
                               -b * std::cos(-2.73343298), -b * std::sin(-2.73343298),
                               -b * std::sin(-6.85262990), b * std::cos(-6.85262990)};
    for (std::size_t k = 0; k < HB_COILS; ++k) {
        Currents current{};
        current[k] = 1.0F;
        EXPECT_NEAR(static_cast<double>(hb_planar_lift_N(&coils, &Pose, current.data())), expected[k], 6e-6);
    }
}

TEST(PlanarWrench, isAvailableEverywhereUpToItsLimit) {
    // At the worst place with 1 A: 3.098 N, 6.195 N, 0.2360 N m, each alone.
    const hb_planar_coils coils = published();
    const hb_wrench demands[] = {{10.0F, 0.0F, 0.0F}, {0.0F, 10.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};
    const double expected[] = {0.3098, 0.6195, 0.2360};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float least = 1.0F;
        for (int step = 0; step < 400; ++step) {
            const float place_m = 0.0508F * static_cast<float>(step) / 400.0F;
            const hb_pose pose{place_m, place_m, 0.0F};
            Currents current{};
            hb_planar_allocate(&coils, &pose, &demands[axis], current.data());
            const Currents asked = current;
            const float scale = hb_planar_limit(current.data(), 1.0F);
            least = std::min(least, scale);
            for (std::size_t k = 0; k < HB_COILS; ++k) {
                ASSERT_FLOAT_EQ(current[k], scale * asked[k]);
                ASSERT_LE(std::fabs(current[k]), 1.000001F);
            }
        }
        // 400 places in a pitch miss a worst one by at most 1 - cos(pi/400) = 3e-5.
        EXPECT_NEAR(static_cast<double>(least), expected[axis], 1e-4) << axis;
    }
}

} // namespace
} // namespace halbench::devices::firmware
