#include "app/cli/frequency_options.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

namespace halbench::app {

TEST(FrequencyOptions, whatIsNotGivenKeepsItsDefault) {
    const Result<FrequencyConfig> config = frequencyConfigFrom({});
    ASSERT_TRUE(config);
    EXPECT_EQ(config->excitation, Excitation::Multisine);
    EXPECT_EQ(config->periods, 8);
    EXPECT_FALSE(config->amplitude_rad);
    EXPECT_EQ(config->leastCoherence, 0.9);
}

TEST(FrequencyOptions, readsEveryOption) {
    IdentifyOptions options;
    options.frequency.excitation = "stepped-sine";
    options.frequency.from = "1";
    options.frequency.to = "20";
    options.base = "-6";
    options.frequency.amplitude = "0.5";
    options.frequency.periods = "16";
    options.frequency.coherence = "0.8";
    const Result<FrequencyConfig> config = frequencyConfigFrom(options);
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->excitation, Excitation::SteppedSine);
    EXPECT_EQ(config->from_Hz, 1.0);
    EXPECT_EQ(config->to_Hz, 20.0);
    EXPECT_EQ(config->base_rad_s, -6.0);
    EXPECT_NEAR(*config->amplitude_rad, 0.5 * Pi / 180.0, 1e-15);
    EXPECT_EQ(config->periods, 16);
    EXPECT_EQ(config->leastCoherence, 0.8);
}

TEST(FrequencyOptions, refusesWhatIsNoNumberOrName) {
    IdentifyOptions options;
    options.frequency.periods = "8.5";
    EXPECT_EQ(frequencyConfigFrom(options).error().code, ErrorCode::Usage);
    options = {};
    options.base = "fast";
    EXPECT_EQ(frequencyConfigFrom(options).error().code, ErrorCode::Usage);
    options = {};
    options.frequency.excitation = "noise";
    EXPECT_EQ(frequencyConfigFrom(options).error().code, ErrorCode::Usage);
}

TEST(FrequencyOptions, belongToFrequencyAlone) {
    IdentifyOptions options;
    EXPECT_TRUE(checkFrequencyOptions(options));
    options.frequency.to = "20";
    EXPECT_EQ(checkFrequencyOptions(options).error().code, ErrorCode::Usage);
    options.isFrequency = true;
    EXPECT_TRUE(checkFrequencyOptions(options));
    options.sweep.given = {"J=5.5e-4"};
    const Result<void> mixed = checkFrequencyOptions(options);
    ASSERT_FALSE(mixed);
    EXPECT_NE(mixed.error().message.find("--given"), std::string::npos);
}

TEST(FrequencyOptions, thoseOfSeveralAxesAreRead) {
    IdentifyOptions options;
    options.axis = "y";
    options.frequency.from = "2";
    options.frequency.to = "120";
    options.frequency.effortRatio = "0.1";
    options.frequency.periods = "64";
    options.frequency.excitation = "multisine";
    const Result<AxesFrequencyConfig> config = axesFrequencyConfigFrom(options);
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->axis, "y");
    EXPECT_EQ(config->from_Hz, 2.0);
    EXPECT_EQ(config->to_Hz, 120.0);
    EXPECT_EQ(config->effort_ratio, 0.1);
    EXPECT_EQ(config->periods, 64);
    EXPECT_EQ(config->leastCoherence, 0.9);
}

TEST(FrequencyOptions, severalAxesRefuseThoseOfAMotor) {
    for (std::string FrequencyOptions::*text :
         {&FrequencyOptions::amplitude, &FrequencyOptions::calibrationFile, &FrequencyOptions::excitation}) {
        IdentifyOptions options;
        options.frequency.*text = "chirp";
        const auto refused = axesFrequencyConfigFrom(options);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::Usage);
    }
    IdentifyOptions turning;
    turning.base = "5";
    EXPECT_EQ(axesFrequencyConfigFrom(turning).error().code, ErrorCode::Usage);
    IdentifyOptions options;
    options.frequency.periods = "7.5";
    EXPECT_EQ(axesFrequencyConfigFrom(options).error().code, ErrorCode::Usage);
}

} // namespace halbench::app
