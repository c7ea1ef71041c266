#include "control/base/units.h"
#include "models/spherical/current_loop.h"
#include "models/spherical/field_sensor.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace halbench::models {
namespace {

TEST(CurrentLoop, axisHasThePublishedValues) {
    const CurrentLoop loop; // 200 turns, 10 mm
    // 10 A; four digits printed.
    for (const auto& [z_m, field_T] :
         {std::pair{0.0, 0.1257}, {0.01, 0.04443}, {0.02, 0.01124}, {0.03, 0.003974}}) {
        const Eigen::Vector3d field = 10.0 * loopField_T_per_A(loop, {z_m, 0, 0});
        EXPECT_NEAR(field.x(), field_T, 5e-4 * field_T);
        EXPECT_EQ(field.y(), 0.0);
    }
    EXPECT_NEAR(10.0 * loopField_T_per_A(loop, {20.99e-3, 0, 0}).x(), 0.01, 1e-5);
}

TEST(CurrentLoop, offTheAxisItIsThePolygonOfManySides) {
    CurrentLoop loop;
    loop.centre_m = {0.07, 0.01, -0.02};
    loop.axis = Eigen::Vector3d(2, -1, 2) / 3.0;
    const Eigen::Vector3d u = loop.axis.unitOrthogonal();
    const Eigen::Vector3d v = loop.axis.cross(u);
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.05, 0, 0), Eigen::Vector3d(0.07, 0.012, -0.02),
                                         Eigen::Vector3d(0.075, 0.03, 0.01)}) {
        // Biot-Savart by the trapezoidal rule, which converges exponentially for a closed smooth loop.
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        constexpr int Sides = 2000;
        for (int i = 0; i < Sides; ++i) {
            const double phi = 2.0 * Pi * i / Sides;
            const Eigen::Vector3d at =
                loop.centre_m + loop.radius_m * (std::cos(phi) * u + std::sin(phi) * v);
            const Eigen::Vector3d along =
                loop.radius_m * (2.0 * Pi / Sides) * (std::cos(phi) * v - std::sin(phi) * u);
            const Eigen::Vector3d arm = point - at;
            sum += 1e-7 * loop.turns * along.cross(arm) / std::pow(arm.norm(), 3);
        }
        EXPECT_LT((loopField_T_per_A(loop, point) - sum).norm(), 1e-11 * sum.norm());
    }
}

TEST(CurrentLoop, seriesAtTheAxisContinuesTheIntegrals) {
    const CurrentLoop loop;
    const Eigen::Vector3d inside = loopField_T_per_A(loop, {0.012, 0.999e-6, 0});
    const Eigen::Vector3d outside = loopField_T_per_A(loop, {0.012, 1.001e-6, 0});
    // The radial part grows in proportion to the distance; the integrals keep about seven digits of it here.
    EXPECT_NEAR(outside.y() / inside.y(), 1.001 / 0.999, 1e-6);
    EXPECT_FALSE(checkCurrentLoop({{0, 0, 0}, {1, 1, 0}, 0.01, 200}).has_value());
}

TEST(FieldSensor, presetsHaveTheirSteps) {
    EXPECT_NEAR(converterPreset(ConverterPreset::Range300mT).step_T, 146.5e-6, 0.05e-6);
    EXPECT_NEAR(converterPreset(ConverterPreset::Range130mT).step_T, 98e-6, 1e-12);
    EXPECT_NEAR(converterPreset(ConverterPreset::Range100mT).step_T, 48.8e-6, 0.05e-6);
}

TEST(FieldSensor, gainCrossAxisAndOffsetComeBeforeTheConverter) {
    FieldSensorConfig config;
    config.gain_ratio = {1.1, 0.9, 1.0};
    config.crossAxis_ratio(0, 1) = 0.02;
    config.offset_T = {1e-3, 0.0, -2e-3};
    config.converter.isQuantised = false;
    FieldSensorState state;
    Random silent(1);
    const FieldSample sample = sampleFieldSensor(config, state, {0.1, 0.2, -0.05}, silent);
    EXPECT_LT((sample.value_T - Eigen::Vector3d(0.11 + 0.02 * 0.18 + 1e-3, 0.18, -0.052)).norm(), 1e-16);
    config.converter.isQuantised = true;
    const FieldSample rounded = sampleFieldSensor(config, state, {0.1, 0.2, -0.05}, silent);
    EXPECT_LE((rounded.value_T - sample.value_T).cwiseAbs().maxCoeff(),
              0.5 * config.converter.step_T + 1e-15);
    // A whole number of steps; the product of code and step is rounded once.
    EXPECT_NEAR(std::remainder(rounded.value_T[0], config.converter.step_T), 0.0, 1e-16);
}

TEST(FieldSensor, marksClippedChannelsAndKeepsFaultyOnes) {
    FieldSensorConfig config;
    config.fault = {ChannelFault::None, ChannelFault::Dead, ChannelFault::Stuck};
    FieldSensorState state;
    Random silent(1);
    const FieldSample first = sampleFieldSensor(config, state, {0.5, 0.1, 0.1}, silent);
    EXPECT_TRUE(first.isClipped[0]);
    EXPECT_NEAR(first.value_T[0], 0.3 - config.converter.step_T, 1e-12);
    EXPECT_EQ(first.value_T[1], 0.0);
    const FieldSample second = sampleFieldSensor(config, state, {-0.5, 0.2, -0.2}, silent);
    EXPECT_NEAR(second.value_T[0], -0.3, 1e-12);
    EXPECT_TRUE(second.isClipped[0]);
    EXPECT_FALSE(second.isClipped[1]);
    EXPECT_EQ(second.value_T[2], first.value_T[2]);
    config.noise_T = -1.0;
    EXPECT_EQ(checkFieldSensor(config).error().code, ErrorCode::OutOfRange);
}

TEST(FieldSensor, aClippedChannelReadsTheEndOfItsRangeOnTheSideOfTheField) {
    FieldSensorConfig config;
    config.fault = {ChannelFault::Clipped, ChannelFault::Clipped, ChannelFault::None};
    FieldSensorState state;
    Random silent(1);
    const FieldSample sample = sampleFieldSensor(config, state, {0.05, -0.05, 0.05}, silent);
    EXPECT_NEAR(sample.value_T[0], 0.3 - config.converter.step_T, 1e-12);
    EXPECT_NEAR(sample.value_T[1], -0.3, 1e-12);
    EXPECT_EQ(sample.isClipped, (std::array{true, true, false}));
    config.converter.isQuantised = false; // no range, no end
    const FieldSample ideal = sampleFieldSensor(config, state, {0.05, -0.05, 0.05}, silent);
    EXPECT_TRUE(std::isinf(ideal.value_T[0]) && std::isinf(ideal.value_T[1]));
    EXPECT_EQ(ideal.isClipped, (std::array{true, true, false}));
    EXPECT_EQ(ideal.value_T[2], 0.05);
}

TEST(FieldSensor, noiseHasItsVariance) {
    FieldSensorConfig config;
    config.noise_T = 1e-4;
    config.converter.isQuantised = false;
    FieldSensorState state;
    Random noise(7);
    double square = 0.0;
    for (int i = 0; i < 20000; ++i) {
        square += sampleFieldSensor(config, state, Eigen::Vector3d::Zero(), noise).value_T.squaredNorm();
    }
    // 60000 draws: the variance scatters by sqrt(2/60000) = 0.6 %; three of that.
    EXPECT_NEAR(square / 60000.0, 1e-8, 0.018e-8);
}

} // namespace
} // namespace halbench::models
