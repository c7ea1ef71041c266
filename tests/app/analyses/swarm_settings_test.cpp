#include "app/analyses/spherical/swarm_settings.h"
#include "tests/app/analyses/recorded_poses.h"

#include <gmock/gmock.h>

namespace halbench::app {
namespace {

// spherical-theory.md section 5.4.
TEST(SwarmSettings, defaultsAreThoseOfTheTheory) {
    const JsonValue settings = swarmJson(swarmSettings({}));
    const std::pair<const char*, double> expected[] = {{"threshold_T", 0.01},
                                                       {"particles", 30},
                                                       {"iterations", 100},
                                                       {"first_inertia", 0.9},
                                                       {"last_inertia", 0.4},
                                                       {"c1", 2},
                                                       {"c2", 2},
                                                       {"swarm_stop_T2", 1e-3},
                                                       {"velocity_clamp_ratio", 0.4},
                                                       {"projection_steps", 200},
                                                       {"k", -0.5},
                                                       {"projection_stop_T2", 1e-20},
                                                       {"cut_ratio", 1e-4},
                                                       {"step_limit_rad", 0.5}};
    for (const auto& [name, value] : expected) {
        EXPECT_EQ(number(settings, {name}), value) << name;
    }
    EXPECT_EQ(settings.find("trigger")->text(), "signed");
    EXPECT_EQ(settings.find("rule")->text(), "largest");
    EXPECT_EQ(settings.members().size(), swarmSettingKeys().size());
}

TEST(SwarmSettings, everySettingReachesTheSearch) {
    std::map<std::string, std::string> texts;
    for (const AnalysisKey& key : swarmSettingKeys()) {
        // Another value than the default, within the bounds.
        const double value = key.type == AnalysisKeyType::Integer ? 7 : 0.25 * key.min + 0.125 * key.max;
        texts[std::string(key.name)] = key.name == "trigger" ? "absolute"
                                       : key.name == "rule"  ? "all"
                                                             : std::to_string(value);
    }
    const auto values = parseAnalysisValues(*findAnalysis("swarm"), texts, {});
    ASSERT_TRUE(values) << values.error().message;
    const models::SwarmConfig set = swarmSettings(*values);
    EXPECT_TRUE(models::checkSwarmConfig(set));
    const JsonValue usual = swarmJson({});
    const JsonValue settings = swarmJson(set);
    for (const JsonMember& member : settings.members()) {
        const JsonValue& other = *usual.find(member.key);
        const bool isSame = member.value.isNumber() ? member.value.number() == other.number()
                                                    : member.value.text() == other.text();
        EXPECT_FALSE(isSame) << member.key;
    }
}

TEST(SwarmSettings, valuesOutOfBoundsNameTheirOption) {
    const std::pair<const char*, const char*> wrong[] = {{"particles", "0"},
                                                         {"particles", "129"},
                                                         {"particles", "2.5"},
                                                         {"iterations", "0"},
                                                         {"inertia_first", "-1"},
                                                         {"inertia_last", "3"},
                                                         {"c1", "-0.1"},
                                                         {"c2", "11"},
                                                         {"velocity_clamp", "0"},
                                                         {"swarm_stop_T2", "-1"},
                                                         {"projection_steps", "-1"},
                                                         {"step_limit_rad", "0"},
                                                         {"projection_stop_T2", "nan"},
                                                         {"k", "0.1"},
                                                         {"k", "-1.1"},
                                                         {"cut", "1"},
                                                         {"threshold_mT", "-1"},
                                                         {"trigger", "never"},
                                                         {"rule", "none"}};
    for (const char* analysis : {"orient", "estimators", "swarm"}) {
        for (const auto& [key, value] : wrong) {
            const auto values = parseAnalysisValues(*findAnalysis(analysis), {{key, value}}, {});
            ASSERT_FALSE(values) << key << " " << value;
            EXPECT_THAT(values.error().message, testing::HasSubstr(optionOf(AnalysisKey{key}))) << key;
            EXPECT_FALSE(values.error().hint.empty()) << key;
        }
    }
}

TEST(SwarmSettings, areRefusedWhereNoSwarmRuns) {
    const devices::RecordedFile file = recordedPoses(20, Noise_T);
    const auto refined = run("orient", {{"particles", "10"}}, {}, &file);
    ASSERT_FALSE(refined);
    EXPECT_EQ(refined.error().code, ErrorCode::Usage);
    EXPECT_THAT(refined.error().message, testing::HasSubstr("--particles"));
    EXPECT_THAT(refined.error().hint, testing::HasSubstr("--estimator swarm"));
    EXPECT_EQ(run("estimators", {{"only", "tensor"}, {"rule", "all"}}).error().code, ErrorCode::Usage);
}

// Section 5.4: success of 20 000 poses, tolerance 3 points; 3000 poses scatter by 0.9.
TEST(SwarmSettings, changeTheSuccessOfTheSearchAsKnown) {
    const auto success = [](std::map<std::string, std::string> settings) {
        settings.insert({{"only", "swarm"}, {"device", "paper"}, {"count", "3000"}});
        const auto result = run("estimators", settings);
        EXPECT_TRUE(result) << result.error().message;
        return number(result->body.find("estimators")->items().front(), {"success_ratio"});
    };
    EXPECT_NEAR(success({}), 0.899, 0.03);
    EXPECT_NEAR(success({{"trigger", "absolute"}}), 0.645, 0.03);
    EXPECT_NEAR(success({{"trigger", "absolute"}, {"rule", "first"}}), 0.593, 0.03);
    EXPECT_NEAR(success({{"rule", "all"}}), 0.966, 0.03);
    EXPECT_LT(success({{"projection_steps", "0"}}), 0.05); // the swarm alone ends at 0.03 T: degrees
}

TEST(SwarmSettings, oneStartLevelTakesThePlaceOfTheSeven) {
    const auto result = run("swarm", {{"device", "paper"}, {"swarm_stop_T2", "2e-3"}, {"particles", "1"}});
    ASSERT_TRUE(result) << result.error().message;
    const auto& levels = result->body.find("by_start_level")->items();
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_EQ(number(levels.front(), {"start_level_T2"}), 2e-3);
    EXPECT_EQ(number(result->body, {"search", "particles"}), 1.0);
    EXPECT_EQ(result->table->values.size(), 25u * result->table->columns.size());
}

} // namespace
} // namespace halbench::app
