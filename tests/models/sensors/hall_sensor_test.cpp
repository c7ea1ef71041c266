#include "models/sensors/hall_sensor.h"
#include "models/sensors/temperature_sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::models {
namespace {

TEST(HallSensor, pairReadsCosineAndSineWithQuadratureError) {
    const double quadrature_rad = 0.01;
    const auto [a, b] = hallPair(HallConfig{}, quadrature_rad);
    for (const double psi : {-2.0, 0.0, 0.3, 1.5, 4.0}) {
        EXPECT_NEAR(hallField_T(a, psi, 0.0), 0.157 * std::cos(psi), 1e-15);
        EXPECT_NEAR(hallField_T(b, psi, 0.0), 0.157 * std::sin(psi + quadrature_rad), 1e-15);
    }
}

TEST(HallSensor, addsStrayOffsetAndHarmonicsOfItsOwnPhaseOnly) {
    HallConfig sensor;
    sensor.gain_ratio = 1.05;
    sensor.offset_T = 1e-3;
    sensor.harmonics = {{5, 2e-3, -1e-3}};
    const double psi = 0.7;
    // 4 A of own current are the quoted 10 mT.
    const double expected_T =
        0.157 * 1.05 * (std::cos(psi) + 2e-3 * std::cos(3.5) - 1e-3 * std::sin(3.5)) + 10e-3 + 1e-3;
    EXPECT_NEAR(hallField_T(sensor, psi, 4.0), expected_T, 1e-15);
}

TEST(HallSensor, voltageFollowsTemperatureAndIsUndoneWithTheReportedOne) {
    const HallConfig sensor;
    // 2.5 V + 12.5 mV/mT * 100 mT at 25 degC; at 80 degC 1 + 0.0012 * 55 = 1.066 times the swing.
    EXPECT_DOUBLE_EQ(hallVoltageOfField_V(sensor, 0.1, 25.0), 3.75);
    EXPECT_NEAR(hallVoltageOfField_V(sensor, 0.1, 80.0), 2.5 + 1.25 * 1.066, 1e-15);
    EXPECT_NEAR(hallFieldOfVoltage_T(sensor, hallVoltageOfField_V(sensor, -0.09, 60.0), 60.0), -0.09, 1e-16);
    // The sensor sits at 52.5 degC when the coil reports 80: 0.0012 * 27.5 = 3.3 % of the 25 degC
    // sensitivity.
    const double wrong_T = hallFieldOfVoltage_T(sensor, hallVoltageOfField_V(sensor, 0.1, 52.5), 80.0);
    EXPECT_NEAR(wrong_T, 0.1 * 1.033 / 1.066, 1e-15);
}

TEST(HallSensor, warmCoilBesideACoolerSensorShrinksBothFieldsAlike) {
    // Section 9: the coil's sensor reports 80 degC, the Hall part sits at ambient + half of the rise: 52.5.
    // The correction is then wrong by 0.0012 * 27.5 = 3.3 %, which the arctangent does not see.
    const auto sensors = hallPair(HallConfig{}, 0.0);
    Random silent(1);
    const auto seen_T = [&](std::size_t channel, double psi) {
        return hallFieldOfVoltage_T(sensors[channel], hallVoltage_V(sensors[channel], psi, 0.0, 52.5, silent),
                                    80.0);
    };
    EXPECT_NEAR(0.157 / seen_T(0, 0.0) - 1.0, 0.033, 0.0015); // relative to the gain at 52.5, not at 25 degC
    EXPECT_NEAR(std::atan2(seen_T(1, 0.7), seen_T(0, 0.7)), 0.7, 1e-14);
}

TEST(HallSensor, clipsItsOutput) {
    const HallConfig sensor;
    EXPECT_EQ(hallVoltageOfField_V(sensor, 1.0, 25.0), 4.8);
    EXPECT_EQ(hallVoltageOfField_V(sensor, -1.0, 25.0), 0.2);
    // The stated range of +-169 mT is inside the clip, also at 80 degC.
    EXPECT_LT(hallVoltageOfField_V(sensor, 0.169, 80.0), 4.8);
}

TEST(HallSensor, noiseHasTheConfiguredRmsAndNoneWhenZero) {
    HallConfig sensor;
    Random random(7);
    const double quiet_V = hallVoltage_V(sensor, 0.4, 0.0, 25.0, random);
    EXPECT_EQ(quiet_V, hallVoltageOfField_V(sensor, hallField_T(sensor, 0.4, 0.0), 25.0));
    sensor.noise_T = 18.4e-6;
    double squares = 0.0;
    const int count = 20000;
    for (int i = 0; i < count; ++i) {
        const double error_T = (hallVoltage_V(sensor, 0.4, 0.0, 25.0, random) - quiet_V) / 12.5;
        squares += error_T * error_T;
    }
    // An rms of n samples scatters by 1/sqrt(2n) = 0.5 %; four of that.
    EXPECT_NEAR(std::sqrt(squares / count), 18.4e-6, 0.02 * 18.4e-6);
}

TEST(HallSensor, refusesImpossibleSettings) {
    EXPECT_TRUE(checkHallConfig(HallConfig{}));
    HallConfig sensor;
    sensor.noise_T = -1e-6;
    EXPECT_EQ(checkHallConfig(sensor).error().code, ErrorCode::OutOfRange);
    sensor = HallConfig{};
    sensor.offset_T = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(checkHallConfig(sensor).error().code, ErrorCode::NotFinite);
    sensor = HallConfig{};
    sensor.harmonics = {{0, 1e-3, 0.0}};
    EXPECT_EQ(checkHallConfig(sensor).error().code, ErrorCode::OutOfRange);
    sensor = HallConfig{};
    sensor.clipLow_V = 4.9;
    EXPECT_EQ(checkHallConfig(sensor).error().code, ErrorCode::OutOfRange);
}

TEST(TemperatureSensor, followsTheQuotedFormula) {
    const TemperatureSensorConfig sensor;
    EXPECT_DOUBLE_EQ(temperatureVoltage_V(sensor, 25.0), 0.75);
    EXPECT_NEAR(temperatureOfVoltage_degC(sensor, 0.75), 25.0, 1e-12);
    for (const double voltage_V : {0.3, 1.3}) {
        EXPECT_NEAR(temperatureOfVoltage_degC(sensor, voltage_V), 0.1 * (1e3 * voltage_V) - 50.0, 1e-12);
    }
}

TEST(TemperatureSensor, carriesItsErrorAndStopsAtItsRange) {
    TemperatureSensorConfig sensor;
    sensor.error_K = -1.5;
    EXPECT_NEAR(temperatureOfVoltage_degC(sensor, temperatureVoltage_V(sensor, 60.0)), 58.5, 1e-12);
    EXPECT_NEAR(temperatureOfVoltage_degC(sensor, temperatureVoltage_V(sensor, 300.0)), 125.0, 1e-12);
    EXPECT_NEAR(temperatureOfVoltage_degC(sensor, temperatureVoltage_V(sensor, -300.0)), -40.0, 1e-12);
}

} // namespace
} // namespace halbench::models
