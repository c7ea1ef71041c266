#include "models/thermal/coil_heating.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

TEST(CoilHeating, timeConstantIsCapacityTimesResistance) {
    const CoilHeatingConfig coil; // 32 J/K * 15 K/W = 480 s
    CoilHeatingState state{75.0};
    stepCoilHeating(coil, state, 0.0, 480.0);
    EXPECT_NEAR(state.temperature_degC, 25.0 + 50.0 * std::exp(-1.0), 1e-10);
}

TEST(CoilHeating, twoAmpereRotatingAmplitudeMeetsTheQuotedTemperatures) {
    const CoilHeatingConfig coil;
    CoilHeatingState state;
    for (int second = 0; second < 600; ++second) {
        stepCoilHeatingSquare(coil, state, 2.0, 1.0); // 2 A amplitude: i_rms^2 = 2 A^2 in each phase
    }
    EXPECT_NEAR(state.temperature_degC, 60.1, 0.05);
    stepCoilHeatingSquare(coil, state, 2.0, 1e5);
    EXPECT_NEAR(state.temperature_degC, 79.7, 0.05);
}

TEST(CoilHeating, instantaneousSquareOfATurningCurrentEqualsItsMean) {
    const CoilHeatingConfig coil;
    CoilHeatingState state;
    for (int ms = 0; ms < 60000; ++ms) {
        stepCoilHeating(coil, state, 2.0 * std::sin(0.01 * ms), 1e-3);
    }
    CoilHeatingState mean;
    stepCoilHeatingSquare(coil, mean, 2.0, 60.0);
    // The ripple of i^2 at 20 rad/s moves the temperature by 3 W / (32 J/K) / 20 rad/s = 5 mK.
    EXPECT_NEAR(state.temperature_degC, mean.temperature_degC, 6e-3);
}

TEST(CoilHeating, fourAmperesInOnePhaseReachTheLimitIn71Seconds) {
    const CoilHeatingConfig coil;
    CoilHeatingState state;
    stepCoilHeating(coil, state, 4.0, 70.5);
    EXPECT_LT(state.temperature_degC, 80.0);
    stepCoilHeating(coil, state, 4.0, 1.0);
    EXPECT_GT(state.temperature_degC, 80.0);
}

TEST(CoilHeating, hasNoEquilibriumAbove3p36Amperes) {
    const CoilHeatingConfig coil;
    // R alpha i^2 = 1/R_th: i = sqrt(1/(1.5 * 0.00393 * 15)) = 3.363 A
    CoilHeatingState below;
    CoilHeatingState above;
    stepCoilHeating(coil, below, 3.35, 1e7);
    stepCoilHeating(coil, above, 3.37, 1e5);
    const double first_degC = below.temperature_degC;
    stepCoilHeating(coil, below, 3.35, 1e6);
    EXPECT_NEAR(below.temperature_degC, first_degC, 1e-6 * first_degC);
    const double hot_degC = above.temperature_degC;
    stepCoilHeating(coil, above, 3.37, 1e5);
    EXPECT_GT(above.temperature_degC, 2.0 * hot_degC);
}

TEST(CoilHeating, stepSizeDoesNotMatter) {
    const CoilHeatingConfig coil;
    CoilHeatingState once;
    CoilHeatingState often;
    stepCoilHeating(coil, once, 3.0, 10.0);
    for (int i = 0; i < 10000; ++i) {
        stepCoilHeating(coil, often, 3.0, 1e-3);
    }
    EXPECT_NEAR(once.temperature_degC, often.temperature_degC, 1e-9);
}

TEST(CoilHeating, resistanceAndSensorFollowTheCoil) {
    const CoilHeatingConfig coil;
    const CoilHeatingState state{80.0};
    EXPECT_NEAR(coilResistance_Ohm(coil, state), 1.5 * (1.0 + 0.00393 * 55.0), 1e-12);
    EXPECT_DOUBLE_EQ(hallTemperature_degC(coil, state), 52.5);
}

} // namespace
} // namespace halbench::models
