#include "app/analyses/analysis_settings.h"
#include "app/analyses/registry/analyses.h"

#include <gmock/gmock.h>

#include <fstream>

namespace halbench::app {
namespace {

Result<AnalysisTexts> settingsOf(const char* name, const std::string& text) {
    const std::string path = testing::TempDir() + "analysis_settings.toml";
    std::ofstream(path) << text;
    return readAnalysisSettings(*findAnalysis(name), path);
}

} // namespace

TEST(AnalysisSettingsTest, aFileHoldsTheKeysOfTheStep) {
    const auto texts =
        settingsOf("place", "objective = \"error\"\ndistance_mm = 20\ntheta_deg = \"20:90\"\n");
    ASSERT_TRUE(texts) << texts.error().message;
    const auto values = parseAnalysisValues(*findAnalysis("place"), texts->values, texts->flags);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->text("objective"), "error");
    EXPECT_EQ(values->text("theta_deg"), "20:90");
    EXPECT_EQ(values->number("distance_mm"), 20.0);
    const auto flag = settingsOf("estimators", "known_strength = true");
    ASSERT_TRUE(flag);
    EXPECT_TRUE(flag->flags.at("known_strength"));
}

TEST(AnalysisSettingsTest, aMistakeIsNamedWithItsLine) {
    struct Mistake {
        const char* text;
        const char* message;
    };
    for (const Mistake& mistake :
         {Mistake{"step_deg = 5\nstp = 1", "analysis_settings.toml:2:1: unknown key 'stp'"},
          Mistake{"\nstep_deg = \"5\"", ":2:1: 'step_deg' is a text, not a number"},
          Mistake{"objective = \"best\"", ":1:1: --objective: 'best' is not known"},
          Mistake{"step_deg = 0.5", ":1:1: --step-deg = 0.5 is out of range"},
          Mistake{"step_deg = nan", ":1:1: --step-deg"}, Mistake{"step_deg =", ":1:"}}) {
        const auto texts = settingsOf("place", mistake.text);
        ASSERT_FALSE(texts) << mistake.text;
        EXPECT_EQ(texts.error().code, ErrorCode::InvalidInput) << mistake.text;
        EXPECT_THAT(texts.error().message, testing::HasSubstr(mistake.message));
    }
    EXPECT_EQ(readAnalysisSettings(*findAnalysis("place"), "/nowhere.toml").error().code,
              ErrorCode::FileSystem);
}

} // namespace halbench::app
