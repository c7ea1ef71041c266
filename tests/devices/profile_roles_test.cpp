#include "devices/profile.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

const std::string Small = R"({"schema": "halbench.profile/1", "model": "m", "title": "A motor",
    "signal_roles": {"position": "angle"}, "parameter_roles": {"gain.kp": "p"}, "procedures": ["move"],
    "constants": {"I_max": 4}, "default_signals": ["angle", "absent"], "defaults": {"p": 0.5, "absent": 1}})";

Catalogue catalogueOfTwo() {
    Catalogue catalogue;
    catalogue.signals.resize(2);
    catalogue.signals[0].name = "speed";
    catalogue.signals[1].name = "angle";
    catalogue.parameters.resize(1);
    catalogue.parameters[0].name = "p";
    return catalogue;
}

std::string complaintAbout(const std::string& json) {
    const Result<Profile> profile = parseProfile(json, "x.json");
    EXPECT_FALSE(profile.has_value());
    if (profile) {
        return {};
    }
    EXPECT_EQ(profile.error().code, ErrorCode::InvalidInput);
    EXPECT_FALSE(profile.error().hint.empty());
    return profile.error().message;
}

TEST(Profile, readsEveryKey) {
    const Result<Profile> profile = parseProfile(Small, "x.json");
    ASSERT_TRUE(profile.has_value());
    EXPECT_EQ(profile->model, "m");
    EXPECT_EQ(profile->title, "A motor");
    EXPECT_EQ(profile->signalRoles.at("position"), "angle");
    EXPECT_EQ(profile->parameterRoles.at("gain.kp"), "p");
    EXPECT_EQ(profile->procedures, std::vector<std::string>{"move"});
    EXPECT_EQ(profile->constants.at("I_max"), 4.0);
    EXPECT_EQ(profile->defaults.at("p"), 0.5);
}

TEST(Profile, namesFileAndKeyOfAMistake) {
    EXPECT_EQ(complaintAbout("{").rfind("x.json: byte ", 0), 0U);
    EXPECT_NE(complaintAbout("[]").find("one JSON object"), std::string::npos);
    EXPECT_NE(complaintAbout(R"({"schema": "other/1", "model": "m"})").find("\"schema\""), std::string::npos);
    EXPECT_NE(complaintAbout(R"({"schema": "halbench.profile/1"})").find("\"model\""), std::string::npos);
    const std::string start = R"({"schema": "halbench.profile/1", "model": "m", )";
    EXPECT_NE(complaintAbout(start + R"("colour": 1})").find("\"colour\""), std::string::npos);
    EXPECT_NE(complaintAbout(start + R"("title": 1})").find("\"title\""), std::string::npos);
    EXPECT_NE(complaintAbout(start + R"("signal_roles": {"a": 1}})").find("signal_roles.a"),
              std::string::npos);
    EXPECT_NE(complaintAbout(start + R"("constants": {"a": "b"}})").find("constants.a"), std::string::npos);
    EXPECT_NE(complaintAbout(start + R"("procedures": "move"})").find("\"procedures\""), std::string::npos);
    EXPECT_NE(complaintAbout(start + R"("default_signals": [1]})").find("\"default_signals\""),
              std::string::npos);
}

TEST(Profile, givesRolesAndDefaultsToWhatTheBoardHas) {
    Catalogue catalogue = catalogueOfTwo();
    applyProfile(*parseProfile(Small, "x.json"), catalogue);
    EXPECT_EQ(catalogue.signalForRole("position"), "angle");
    EXPECT_EQ(catalogue.parameterForRole("gain.kp"), "p");
    EXPECT_EQ(catalogue.findParameter("p")->defaultValue, 0.5);
    EXPECT_EQ(catalogue.defaultSignals,
              std::vector<std::string>{"angle"}); // what the board lacks is left out
    EXPECT_EQ(catalogue.knownConstants.at("I_max"), 4.0);
}

TEST(Profile, shippedProfileOfTheMotorIsFoundAndAnUnknownModelHasNone) {
    const auto motor = findProfile("htm");
    ASSERT_TRUE(motor.has_value() && motor->has_value());
    EXPECT_EQ((*motor)->model, "htm");
    EXPECT_EQ((*motor)->constants.at("I_max"), 4.0); // resources/help/htm-theory.md 2
    for (const char* unknown : {"", "none", "../help/index"}) {
        const auto profile = findProfile(unknown);
        ASSERT_TRUE(profile.has_value());
        EXPECT_FALSE(profile->has_value()) << unknown;
    }
}

TEST(Catalogue, findsByNameAndByRole) {
    Catalogue catalogue = catalogueOfTwo();
    catalogue.signals[1].role = "position";
    EXPECT_EQ(catalogue.findSignal("angle"), &catalogue.signals[1]);
    EXPECT_EQ(catalogue.findSignal("p"), nullptr);
    EXPECT_EQ(catalogue.findParameter("angle"), nullptr);
    EXPECT_EQ(catalogue.signalForRole("position"), "angle");
    EXPECT_EQ(catalogue.signalForRole("speed"), "");
    EXPECT_EQ(catalogue.parameterForRole("gain.kp"), "");
}

} // namespace
} // namespace halbench::devices
