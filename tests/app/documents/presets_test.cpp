#include "app/actuators/htm/known_motor.h"
#include "app/documents/presets.h"
#include "app/tuning/loop_conditions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

double valueOf(const Preset& preset, const std::string& name) {
    const auto found = std::find_if(preset.values.begin(), preset.values.end(),
                                    [&](const ParameterValue& value) { return value.name == name; });
    EXPECT_NE(found, preset.values.end()) << name;
    return found == preset.values.end() ? 0.0 : found->value;
}

// resources/help/htm-theory.md 8.1 to 8.4, and 10.12 for A/deg.
TEST(Presets, holdTheGainsOfTheTheoryPage) {
    constexpr double PerDegree = 57.29577951308232;
    const Preset published = findPreset("htm", "published").value();
    EXPECT_EQ(valueOf(published, "gain.kp"), 10.0);
    EXPECT_EQ(valueOf(published, "gain.ki"), 0.1);
    const Preset designed = findPreset("htm", "designed").value();
    EXPECT_NEAR(valueOf(designed, "gain.kp"), 8.684, 5e-4); // 6.4, as many digits as printed
    EXPECT_NEAR(valueOf(designed, "gain.ki"), 3.776, 5e-4); // 6.5
    const Preset microStep = findPreset("htm", "micro-step").value();
    EXPECT_NEAR(valueOf(microStep, "gain.kp"), 5.0 * PerDegree, 1e-4);
    EXPECT_NEAR(valueOf(microStep, "gain.ki"), 0.05 * PerDegree, 1e-6);
    const Preset inDegrees = findPreset("htm", "published-in-degrees").value();
    EXPECT_NEAR(valueOf(inDegrees, "gain.kp"), 572.958, 1e-3);
    const Preset recommended = findPreset("htm", "recommended").value();
    EXPECT_EQ(valueOf(recommended, "gain.kp"), 40.0);
    EXPECT_EQ(valueOf(recommended, "gain.ki"), 60.0);
    EXPECT_EQ(valueOf(recommended, "gain.kd"), 1.4);
    EXPECT_NEAR(valueOf(recommended, "feedforward.inertia"), 5.5e-4 / 1.43e-2, 1e-8);
    EXPECT_NEAR(valueOf(recommended, "feedforward.viscous"), 1.23e-3 / 1.43e-2, 1e-8);
    EXPECT_NEAR(valueOf(recommended, "feedforward.coulomb"), 0.9 * 2.05e-2 / 1.43e-2, 1e-8);
}

TEST(Presets, namesBeginWithThePublishedOneAndAreSorted) {
    EXPECT_EQ(presetNames(), (std::vector<std::string>{"published", "designed", "micro-step",
                                                       "published-in-degrees", "recommended"}));
}

TEST(Presets, allThatExperimentsMayNameAreShippedWithTheirSource) {
    for (const std::string& name : presetNames()) {
        const Result<Preset> preset = findPreset("htm", name);
        ASSERT_TRUE(preset.has_value()) << name;
        EXPECT_EQ(preset->name, name);
        EXPECT_FALSE(preset->title.empty());
        EXPECT_FALSE(preset->source.empty());
    }
}

TEST(Presets, unknownAndDamagedOnesAreRefused) {
    EXPECT_EQ(findPreset("htm", "none").error().code, ErrorCode::UnknownName);
    EXPECT_EQ(findPreset("none", "published").error().code, ErrorCode::UnknownName);
    for (const char* text : {"{", "{}", R"({"schema": "halbench.preset/2"})",
                             R"({"schema": "halbench.preset/1", "model": "m", "name": "n", "title": "t",
                                 "source": "s", "parameters": {"gain.kp": "ten"}})"}) {
        const Result<Preset> preset = parsePreset(text, "p.json");
        ASSERT_FALSE(preset.has_value()) << text;
        EXPECT_EQ(preset.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(preset.error().message.find("p.json"), std::string::npos);
    }
}

TEST(LoopConditions, ofTheMotorAreThoseOfTheTheoryPage) {
    const Result<LoopConditions> conditions = loopConditionsOf("htm");
    ASSERT_TRUE(conditions.has_value());
    EXPECT_EQ(conditions->timing.period_s, 0.01);
    EXPECT_EQ(conditions->timing.delay_samples, 0);
    EXPECT_TRUE(loopConditionsOf("none").has_value()); // defaults
}

TEST(LoopConditions, ofAModelAreThoseItWasMeasuredWith) {
    ModelFile model;
    model.device.emplace().model = "htm";
    EXPECT_EQ(loopConditionsOf(model)->timing, (control::LoopTiming{0.01, 0})); // an older file
    model.estimate.timing = {std::nullopt, 1};
    EXPECT_EQ(loopConditionsOf(model)->timing, (control::LoopTiming{0.01, 1}));
    model.estimate.timing = {0.002, 2};
    EXPECT_EQ(loopConditionsOf(model)->timing, (control::LoopTiming{0.002, 2}));
    EXPECT_EQ(loopConditionsOf(model)->currentLimit_A, loopConditionsOf("htm")->currentLimit_A);
}

TEST(KnownMotor, isPredictedForThePublishedModelOnly) {
    devices::DeviceInfo device;
    EXPECT_FALSE(knownMotor(device).has_value());
    device.model = "htm";
    const auto motor = knownMotor(device);
    ASSERT_TRUE(motor.has_value());
    EXPECT_EQ(motor->torqueConstant_Nm_per_A, 1.43e-2);
    device.uri = "sim:htm?phi=0.02";
    device.isSimulated = true;
    device.overrides = {{"phi", "0.02"}};
    EXPECT_EQ(knownMotor(device)->torqueConstant_Nm_per_A, 0.02);
}

} // namespace
} // namespace halbench::app
