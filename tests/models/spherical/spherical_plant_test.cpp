#include "models/spherical/additive_model.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/spherical_plant.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace halbench::models {
namespace {

SphericalPlant plant(const SphericalParameters& parameters, std::uint64_t seed = 1) {
    auto made = SphericalPlant::make(parameters, seed);
    EXPECT_TRUE(made.has_value());
    return std::move(*made);
}

std::array<float, SphericalPlant::ReadingCount> codesOf(SphericalPlant& motor) {
    std::array<float, SphericalPlant::ReadingCount> codes{};
    motor.read(codes);
    return codes;
}

SphericalReadings fields_T(SphericalPlant& motor) {
    const auto codes = codesOf(motor);
    SphericalReadings readings_T;
    for (int i = 0; i < 9; ++i) {
        readings_T[i] = static_cast<double>(codes[static_cast<std::size_t>(i)]) * motor.converter().step_T;
    }
    return readings_T;
}

SphericalParameters with(SphericalParameters parameters,
                         std::initializer_list<std::pair<const char*, double>> values) {
    for (const auto& [key, value] : values) {
        EXPECT_TRUE(setSphericalParameter(parameters, key, value).has_value()) << key;
    }
    return parameters;
}

TEST(SphericalParameters, everyKeyCanBeReadWrittenAndHasALegalDefault) {
    std::set<std::string_view> keys;
    for (const SphericalParameterSpec& spec : sphericalParameterSpecs()) {
        EXPECT_TRUE(keys.insert(spec.key).second) << spec.key;
        EXPECT_TRUE((spec.value == nullptr) != (spec.specimen == nullptr)) << spec.key;
        SphericalParameters parameters;
        if (const auto before = sphericalParameter(parameters, spec.key)) {
            // Angles in degrees are rounded on their way.
            EXPECT_GE(*before, spec.min - 1e-12 * std::abs(spec.min)) << spec.key;
            EXPECT_LE(*before, spec.max + 1e-12 * std::abs(spec.max)) << spec.key;
        }
        for (const double value : {spec.min, spec.max}) {
            ASSERT_TRUE(setSphericalParameter(parameters, spec.key, value).has_value()) << spec.key;
            EXPECT_NEAR(*sphericalParameter(parameters, spec.key), value, 1e-12 * std::abs(value))
                << spec.key;
        }
    }
}

TEST(SphericalParameters, refusesUnknownKeysAndImpossibleDevices) {
    SphericalParameters parameters;
    EXPECT_EQ(setSphericalParameter(parameters, "mass", 1.0).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(setSphericalParameter(parameters, "Br", -1.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(setSphericalParameter(parameters, "Br", std::nan("")).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(setSphericalParameter(parameters, "adc", 1.5).error().code, ErrorCode::OutOfRange);
    for (const auto& impossible :
         {with({}, {{"r_mm", 40.0}}), with({}, {{"Ri_mm", 50.0}}), with({}, {{"coil_distance_mm", 30.0}}),
          with({}, {{"s1_gamma_deg", 0.0}})}) {
        EXPECT_EQ(SphericalPlant::make(impossible, 1).error().code, ErrorCode::OutOfRange);
    }
}

// The words stand for the enumerations that the plant takes the values for.
TEST(SphericalParameters, aChoiceHasOneWordForEachOfItsValues) {
    const auto words = [](const char* key) { return sphericalParameterWords(key); };
    const auto namesOf = [](const auto& names, std::size_t count) {
        return std::vector<std::string>(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count));
    };
    EXPECT_EQ(words("adc"), namesOf(ConverterPresetNames, 4));
    EXPECT_EQ(words("motion"), namesOf(MotionNames, 7)); // a table comes from a file
    EXPECT_EQ(words("device"), namesOf(SphericalDeviceNames, 2));
    EXPECT_EQ(words("frames"), namesOf(SensorFrameNames, 3));
    EXPECT_EQ(words("s2_fault_phi"), namesOf(ChannelFaultNames, 4));
    EXPECT_EQ(words("noise").size(), NoisePresets_T.size());
    EXPECT_TRUE(words("noise_uT").empty());
    EXPECT_TRUE(words("mass").empty());
    for (const SphericalParameterSpec& spec : sphericalParameterSpecs()) {
        EXPECT_EQ(spec.isWhole, !words(spec.key.data()).empty()) << spec.key;
        EXPECT_TRUE(!spec.isWhole || spec.max + 1.0 == static_cast<double>(words(spec.key.data()).size()))
            << spec.key;
    }
}

TEST(SphericalPlant, sameSeedGivesTheSameBitsAndAnotherSeedOthers) {
    const SphericalParameters parameters = with({}, {{"motion", 6.0}});
    SphericalPlant first = plant(parameters, 5);
    SphericalPlant second = plant(parameters, 5);
    SphericalPlant other = plant(parameters, 6);
    bool differs = false;
    for (int i = 0; i < 200; ++i) {
        first.advance(4);
        second.advance(4);
        other.advance(4);
        const auto codes = codesOf(first);
        ASSERT_EQ(codes, codesOf(second));
        differs = differs || codes != codesOf(other);
    }
    EXPECT_TRUE(differs);
}

TEST(SphericalPlant, idealChainReadsTheExactFieldInEveryFrame) {
    for (const double frames : {0.0, 1.0, 2.0}) {
        SphericalPlant motor = plant(with(
            withIdealChain({}),
            {{"frames", frames}, {"alpha_deg", 12}, {"beta_deg", -20}, {"gamma_deg", 33}, {"harmonics", 1}}));
        const RotorField field({Q, 0.05, harmonicPreset(HarmonicPreset::H1)});
        const SensorPoses poses =
            sensorPoses(publishedPlacement(), static_cast<SensorFrames>(static_cast<int>(frames)), 0.05);
        // Codes of at most 2000 in single precision: 6e-5 of a step of 146 uT.
        EXPECT_LT((fields_T(motor) - field.readings_T(rotationOf(angles_deg(12, -20, 33)), poses))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-8);
    }
}

TEST(SphericalPlant, additiveDeviceReadsThePublishedModel) {
    SphericalPlant motor =
        plant(with(withIdealChain({}), {{"device", 1}, {"alpha_deg", 30}, {"gamma_deg", 87.5}}));
    EXPECT_LT((fields_T(motor) - additiveReadings_T({}, angles_deg(30, 0, 87.5))).cwiseAbs().maxCoeff(),
              1e-8);
}

TEST(SphericalPlant, withoutImperfectionsOnlyTheConverterIsLeft) {
    SphericalPlant motor = plant(withoutImperfections({}));
    const SphericalReadings readings_T = fields_T(motor);
    EXPECT_LE((readings_T - motor.truth().field_T).cwiseAbs().maxCoeff(),
              0.5 * motor.converter().step_T + 1e-9);
    for (const float code : codesOf(motor)) {
        EXPECT_EQ(code, std::round(code));
    }
}

TEST(SphericalPlant, coilAndUniformFieldAddUp) {
    const SphericalParameters base = withIdealChain({});
    SphericalPlant without = plant(base);
    SphericalPlant motor = plant(with(base, {{"stray_y_uT", 2000}}));
    motor.setCoilCurrent_A(10.0);
    const SensorPoses& poses = motor.specimen().poses;
    const CurrentLoop coil = statorCoilOf(base);
    const SphericalReadings added_T = fields_T(motor) - fields_T(without);
    for (int i = 0; i < 3; ++i) {
        const SensorPose& pose = poses[static_cast<std::size_t>(i)];
        const Eigen::Vector3d expected_T =
            pose.axes.transpose() *
            (10.0 * loopField_T_per_A(coil, pose.position_m) + Eigen::Vector3d(0, 2e-3, 0));
        EXPECT_LT((added_T.segment<3>(3 * i) - expected_T).norm(), 2e-8);
    }
    EXPECT_EQ(codesOf(motor)[SphericalPlant::CurrentIndex], 10.0F);
}

TEST(SphericalPlant, magnetWarmsUpAndWeakens) {
    SphericalPlant motor = plant(with(withIdealChain({}), {{"warm_rise_K", 40}, {"warm_time_s", 1}}));
    const double cold_T = motor.truth().strength_T;
    motor.advance(4000);
    const double warm_K = 40.0 * (1.0 - std::exp(-1.0));
    EXPECT_NEAR(motor.truth().magnet_degC, 25.0 + warm_K, 1e-9);
    EXPECT_NEAR(motor.truth().strength_T / cold_T, 1.0 - 1.1e-3 * warm_K, 1e-12);
    EXPECT_NEAR(codesOf(motor)[SphericalPlant::TemperatureIndex], 25.0 + warm_K, 1e-5);
}

TEST(SphericalPlant, faultyChannelsAreDeadOrStuckAndClippedOnesEndAtTheRange) {
    SphericalPlant motor = plant(with(withoutImperfections({}), {{"motion", 5}, {"adc", 3}}));
    motor.setFault(1, ChannelFault::Dead);
    motor.setFault(5, ChannelFault::Stuck);
    const float held = codesOf(motor)[5];
    bool wasClipped = false;
    for (int i = 0; i < 200; ++i) {
        motor.advance(40);
        const auto codes = codesOf(motor);
        EXPECT_EQ(codes[1], 0.0F);
        EXPECT_EQ(codes[5], held);
        for (std::size_t k = 0; k < 9; ++k) {
            EXPECT_LE(std::abs(codes[k]), 2048.0F); // 12 bit
            wasClipped = wasClipped || isAtRangeEnd(motor.converter(),
                                                    static_cast<double>(codes[k]) * motor.converter().step_T);
        }
    }
    EXPECT_TRUE(wasClipped);
}

TEST(SphericalPlant, errorsAreDrawnWithTheirSpreadsAndIndependently) {
    SphericalParameters parameters;
    RootMeanSquare gain;
    RootMeanSquare offset;
    RootMeanSquare turn;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const SphericalSpecimen specimen = drawSphericalSpecimen(parameters, seed);
        const SensorPoses nominal = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                gain.add(specimen.sensors[i].gain_ratio[k] - 1.0);
                offset.add(specimen.sensors[i].offset_T[k]);
                turn.add(vectorOfRotation(specimen.poses[i].axes * nominal[i].axes.transpose())[k]);
            }
        }
    }
    // A Gaussian cut at two sigma has 0.8796 of it; 2700 draws scatter by 1.5 %, three of that.
    EXPECT_NEAR(gain.value(), 0.8796 * 0.01, 0.045 * 0.01);
    EXPECT_NEAR(offset.value(), 0.8796e-3, 0.045e-3);
    EXPECT_NEAR(radiansToDegrees(turn.value()), 0.8796, 0.045);
    const SphericalSpecimen free = drawSphericalSpecimen(parameters, 9);
    parameters.errors[0].gain_ratio[0] = 0.0;
    const SphericalSpecimen written = drawSphericalSpecimen(parameters, 9);
    EXPECT_EQ(written.sensors[0].gain_ratio[0], 1.0);
    EXPECT_EQ(written.sensors[0].gain_ratio[1], free.sensors[0].gain_ratio[1]);
    EXPECT_EQ(written.sensors[2].offset_T, free.sensors[2].offset_T);
}

// Section 4 of resources/help/spherical-theory.md: shares of clipped channels and of poses that masking them
// leaves without the full rank.
TEST(SphericalPlant, narrowRangesClipTheKnownShares) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    for (const auto& [range_T, clipped_ratio, lost_ratio] :
         {std::array{0.1, 0.431, 0.37}, {0.13, 0.296, 0.067}, {0.16, 0.188, 0.0011}, {0.3, 0.0, 0.0}}) {
        Random random(71);
        constexpr int Poses = 10000;
        int clipped = 0;
        int lost = 0;
        for (int i = 0; i < Poses; ++i) {
            const SphericalReadings readings_T = field.readings_T(rotationOf(drawn(random)), sensing.poses);
            ChannelMask used{};
            for (int k = 0; k < 9; ++k) {
                used[static_cast<std::size_t>(k)] = std::abs(readings_T[k]) < range_T;
                clipped += std::abs(readings_T[k]) >= range_T;
            }
            lost += TensorSystem(sensing, used).smallestSingularValue() < 1e-6;
        }
        // 10000 poses: half a point at 37 %.
        EXPECT_NEAR(clipped / (9.0 * Poses), clipped_ratio, 0.01);
        EXPECT_NEAR(static_cast<double>(lost) / Poses, lost_ratio, 0.015 * std::sqrt(lost_ratio) + 5e-4);
    }
}

} // namespace
} // namespace halbench::models
