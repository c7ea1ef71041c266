#include "devices/profile.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

constexpr const char* Small = R"({ "schema": "halbench.profile/1", "model": "x",
    "signal_roles": { "position": "angle" }, "parameter_roles": { "gain.kp": "p" }, "procedures": ["tune"],
    "constants": { "I_max": 4 }, "default_signals": ["angle", "missing"], "defaults": { "p": 2.5 } })";

TEST(Profile, givesRolesDefaultsAndConstantsToACatalogue) {
    const auto profile = parseProfile(Small, "small.json");
    ASSERT_TRUE(profile) << profile.error().message;
    Catalogue catalogue;
    catalogue.signals.resize(1);
    catalogue.signals[0].name = "angle";
    catalogue.parameters.resize(1);
    catalogue.parameters[0].name = "p";
    applyProfile(*profile, catalogue);
    EXPECT_EQ(catalogue.signalForRole("position"), "angle");
    EXPECT_EQ(catalogue.parameterForRole("gain.kp"), "p");
    EXPECT_EQ(catalogue.parameters[0].defaultValue, 2.5);
    EXPECT_EQ(catalogue.defaultSignals, std::vector<std::string>{"angle"})
        << "what the board lacks is left out";
    EXPECT_EQ(catalogue.knownConstants.at("I_max"), 4.0);
}

TEST(Profile, refusesEveryMistakeWithItsPlace) {
    const std::vector<std::pair<const char*, const char*>> mistakes = {
        {"{", "byte"},
        {"[]", "object"},
        {R"({"schema": "halbench.profile/2", "model": "x"})", "schema"},
        {R"({"schema": "halbench.profile/1"})", "model"},
        {R"({"schema": "halbench.profile/1", "model": "x", "signals": {}})", "signals"},
        {R"({"schema": "halbench.profile/1", "model": "x", "defaults": {"p": "2"}})", "defaults.p"},
        {R"({"schema": "halbench.profile/1", "model": "x", "procedures": {}})", "procedures"},
        {R"({"schema": "halbench.profile/1", "model": "x", "signal_roles": {"a": 1}})", "signal_roles.a"},
    };
    for (const auto& [text, place] : mistakes) {
        const auto profile = parseProfile(text, "x.json");
        ASSERT_FALSE(profile) << text;
        EXPECT_EQ(profile.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(profile.error().message.find("x.json"), std::string::npos);
        EXPECT_NE(profile.error().message.find(place), std::string::npos) << profile.error().message;
    }
}

TEST(Profile, shippedOneIsFoundByItsModel) {
    const auto profile = findProfile("htm");
    ASSERT_TRUE(profile) << profile.error().message;
    ASSERT_TRUE(*profile);
    EXPECT_EQ((*profile)->model, "htm");
    const auto none = findProfile("no_such_model");
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

} // namespace
} // namespace halbench::devices
