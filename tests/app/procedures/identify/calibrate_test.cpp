#include "app/procedures/calibrate_procedure.h"
#include "devices/open_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Degree = M_PI / 180.0;

std::unique_ptr<devices::Device> open(const std::string& uri) {
    auto device = devices::openDevice(uri, {});
    EXPECT_TRUE(device) << (device ? "" : device.error().message);
    return device ? std::move(*device) : nullptr;
}

double figure(const CalibrateResult& result, const std::string& name) {
    const auto found = std::find_if(result.figures.begin(), result.figures.end(),
                                    [&name](const CalibrationFigure& f) { return f.name == name; });
    EXPECT_NE(found, result.figures.end()) << name;
    return found == result.figures.end() ? NAN : *found->estimate.value;
}

TEST(Calibrate, findsOffsetGainAndQuadratureOfTheHallSensors) {
    const auto device =
        open("sim:htm?imperfections=off&hall_offset_mT=4&hall_gain_error=0.05&quadrature_deg=1");
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    const auto result = runCalibrate(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    // one ADC count is 0.39 mT; averaging over a thousand readings leaves a tenth of it
    EXPECT_NEAR(figure(*result, "hall.offset_a"), 4e-3, 5e-5);
    EXPECT_NEAR(figure(*result, "hall.offset_b"), 4e-3, 5e-5);
    // gains a/b = 1.05 with mean 1
    EXPECT_NEAR(figure(*result, "hall.gain_ratio"), 1.0 / 1.05, 5e-4);
    EXPECT_NEAR(figure(*result, "hall.quadrature"), 1.0 * Degree, 0.03 * Degree);
    EXPECT_NEAR(figure(*result, "hall.amplitude"), 0.157 * 2.1 / 2.05, 1e-4);
    EXPECT_GT(result->residualBefore_rad, 1.0 * Degree);
    EXPECT_FALSE(result->isApplied);
}

TEST(Calibrate, findsTheStrayCoefficientAtStandstill) {
    for (const char* value : {"2.5", "1.8"}) {
        const auto device = open(std::string("sim:htm?seed=2&stray_mT_per_A=") + value);
        CalibrateConfig config;
        config.which = {Calibration::Stray};
        const auto result = runCalibrate(*device, config, {});
        ASSERT_TRUE(result) << result.error().message;
        // must be known to 35 % for stability (resources/help/htm-theory.md section 8.4); quantisation allows
        // 3 %
        EXPECT_NEAR(figure(*result, "stray.coefficient") * 1e3 / std::stod(value), 1.0, 0.03);
    }
}

TEST(Calibrate, findsTheStaticFriction) {
    const auto device = open("sim:htm?imperfections=off&Ks_over_Kf=1.15");
    CalibrateConfig config;
    config.which = {Calibration::StaticFriction};
    const auto result = runCalibrate(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->staticFriction.size(), 12u);
    // 1.15 K_f/phi; 20 mA are 33 ms of the ramp
    EXPECT_NEAR(figure(*result, "static_friction.current"), 1.15 * 2.05e-2 / 1.43e-2, 0.02);
}

TEST(Calibrate, appliesInOneTransactionAndImprovesTheAngle) {
    const auto device = open("sim:htm?seed=9");
    CalibrateConfig config;
    config.apply = true;
    const auto result = runCalibrate(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->isApplied);
    ASSERT_EQ(result->proposed.size(), 6u);
    for (const ParameterValue& value : result->proposed) {
        const std::string name[] = {value.name};
        // single precision on the board
        EXPECT_NEAR(device->readParameters(name)->front(), value.value, 1e-6 * std::fabs(value.value));
    }
    const auto again = runCalibrate(*device, {.which = {Calibration::Hall}}, {});
    ASSERT_TRUE(again);
    EXPECT_LT(again->residualBefore_rad, 0.2 * result->residualBefore_rad);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(Calibrate, withoutApplyTheBoardStaysAsItWas) {
    const auto device = open("sim:htm?seed=10");
    const auto result = runCalibrate(*device, {.which = {Calibration::Hall, Calibration::Stray}}, {});
    ASSERT_TRUE(result);
    for (const ParameterValue& value : result->before) {
        const std::string name[] = {value.name};
        EXPECT_EQ(device->readParameters(name)->front(), value.value);
    }
}

TEST(Calibrate, refusesAMotorThatDoesNotTurn) {
    const auto device = open("sim:htm?Kf=0.2");
    const auto result = runCalibrate(*device, {.which = {Calibration::Hall}, .apply = true}, {});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    EXPECT_FALSE(result->isApplied);
}

} // namespace
} // namespace halbench::app
