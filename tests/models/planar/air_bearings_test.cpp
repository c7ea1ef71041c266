#include "models/planar/air_bearings.h"
#include "models/planar/windings_wrench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

using Lifts = Eigen::Matrix<double, CoilCount, 1>;

const PlanarGeometry Nominal;
constexpr double Stiffness_N_per_m = 1.7e7;

AirBearings bearings(const Eigen::Vector2d& massCentre_m = Eigen::Vector2d::Zero()) {
    return {Nominal, Stiffness_N_per_m, 0.64, massCentre_m};
}

Lifts setLifts(double set12_N, double set34_N, double set56_N) {
    Lifts lift_N;
    lift_N << set12_N / 2, set12_N / 2, set34_N / 2, set34_N / 2, set56_N / 2, set56_N / 2;
    return lift_N;
}

TEST(AirBearings, carryTheWeightAndItsMoments) {
    const Eigen::Vector2d centre_m(0.8e-3, -0.6e-3);
    const AirBearings air = bearings(centre_m);
    EXPECT_NEAR(air.weight_N(), 6.28, 0.005); // theory section 8
    const BearingState rest = air.under(Lifts::Zero());
    double sum = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        sum += rest.load_N[i];
        moment += rest.load_N[i] * air.places_m()[i];
    }
    EXPECT_NEAR(sum, air.weight_N(), 1e-13);
    EXPECT_LT((moment - air.weight_N() * centre_m).norm(), 1e-14);
    EXPECT_TRUE(rest.isCarried);
    EXPECT_EQ(rest.lift_m, 0.0);
}

TEST(AirBearings, liftAndTiltsMeetThePublishedNumbers) {
    // Section 10, items 8 and 9: 4.4 N on one bearing, printed with two or three digits.
    const AirBearings air = bearings();
    const BearingState lifted = air.under(setLifts(4.4, 4.4, 4.4));
    EXPECT_NEAR(lifted.lift_m, 0.259e-6, 0.5e-9);
    EXPECT_NEAR(lifted.tiltX_rad, 0.0, 1e-18);
    const BearingState across = air.under(setLifts(4.4, -4.4, 0.0));
    EXPECT_NEAR(across.tiltY_rad, 6.79e-6, 0.005e-6); // coils 1 and 2 on the side of negative x' rise
    const BearingState along = air.under(setLifts(-4.4, -4.4, 4.4));
    EXPECT_NEAR(along.tiltX_rad, 7.41e-6, 0.005e-6);
}

TEST(AirBearings, fullCurrentsInTheWorstPhasesExceedTheWeight) {
    // Section 8: 13.2 N; published model, sqrt(2) b1 for each of three sets would be 13.14 N.
    const AirBearings air = bearings();
    const BearingState worst = air.under(setLifts(4.381, 4.381, 4.381));
    EXPECT_NEAR(worst.liftForce_N, 13.14, 0.005);
    EXPECT_GT(worst.liftForce_N, air.weight_N());
    EXPECT_FALSE(worst.isCarried);
}

TEST(AirBearings, gapsLieOnThePlaneOfLiftAndTilts) {
    const AirBearings air = bearings();
    Lifts lift_N;
    lift_N << 0.5, -1.2, 0.3, 0.8, -0.4, 1.1;
    const BearingState state = air.under(lift_N);
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d& place_m = air.places_m()[i];
        EXPECT_NEAR(state.gapChange_m[i],
                    state.lift_m + state.tiltX_rad * place_m.y() - state.tiltY_rad * place_m.x(), 1e-20);
    }
}

} // namespace
} // namespace halbench::models
