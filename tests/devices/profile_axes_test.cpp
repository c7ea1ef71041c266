#include "devices/profile.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {
namespace {

constexpr const char* Axis = R"({"id": "z", "title": "Height", "position_unit": "m", "effort_unit": "N",
    "roles": {"position": "position.z", "speed": "speed.z", "reference": "reference.z", "effort": "effort.z",
              "true_position": "truth.z", "position_window": "window.z", "speed_window": "window.v"},
    "generator": "reference.z", "turns_forever": false, "window_margin": 0.001, "settle_s": 2,
    "reference_tolerance": 1e-7, "end_tolerance": 1e-5})";

std::string profileWith(const std::string& axes) {
    return R"({"schema": "halbench.profile/1", "model": "m", "signal_roles": {"position.z": "z", "speed.z": "v",
        "reference.z": "r", "effort.z": "f", "truth.z": "t"},
        "parameter_roles": {"window.z": "w", "window.v": "wv"}, "axes": )" +
           axes + "}";
}

std::string changed(const std::string& from, const std::string& to) {
    std::string axis = Axis;
    axis.replace(axis.find(from), from.size(), to);
    return axis;
}

TEST(ProfileAxes, areRead) {
    const auto profile = parseProfile(profileWith("[" + std::string(Axis) + "]"), "x.json");
    ASSERT_TRUE(profile) << profile.error().message;
    ASSERT_EQ(profile->axes.size(), 1U);
    const AxisSpec& axis = profile->axes.front();
    EXPECT_EQ(axis.id, "z");
    EXPECT_EQ(axis.title, "Height");
    EXPECT_EQ(axis.positionUnit, "m");
    EXPECT_EQ(axis.effortUnit, "N");
    EXPECT_EQ(axis.roles.effort, "effort.z");
    EXPECT_EQ(axis.roles.speedWindow, "window.v");
    EXPECT_EQ(axis.generator, "reference.z");
    EXPECT_FALSE(axis.turnsForever);
    EXPECT_EQ(axis.windowMargin, 0.001);
    EXPECT_EQ(axis.settle_s, 2.0);
    EXPECT_EQ(axis.referenceTolerance, 1e-7);
    EXPECT_EQ(axis.endTolerance, 1e-5);
}

TEST(ProfileAxes, aBoardMayTellTheCommandOfAnAxis) {
    const auto without = parseProfile(profileWith("[" + std::string(Axis) + "]"), "x.json");
    ASSERT_TRUE(without);
    EXPECT_EQ(without->axes.front().roles.command, "");
    const std::string telling =
        changed(R"("effort": "effort.z")", R"("effort": "effort.z", "command": "truth.z")");
    const auto with = parseProfile(profileWith("[" + telling + "]"), "x.json");
    ASSERT_TRUE(with) << with.error().message;
    EXPECT_EQ(with->axes.front().roles.command, "truth.z");
    const std::string unknown = changed(R"("effort": "effort.z")", R"("effort": "effort.z", "command": "c")");
    const auto refused = parseProfile(profileWith("[" + unknown + "]"), "x.json");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("axes.0.roles.command"), std::string::npos);
}

TEST(ProfileAxes, mistakesAreNamedWithTheirPlace) {
    const std::vector<std::pair<std::string, std::string>> mistakes = {
        {"3", "\"axes\""},
        {"[3]", "\"axes.0\""},
        {"[" + changed(R"("id": "z")", R"("id": "")") + "]", "\"axes.0.id\""},
        {"[" + changed(R"("position_unit": "m")", R"("position_unit": "mm")") + "]", "axes.0.position_unit"},
        {"[" + changed(R"("effort_unit": "N")", R"("effort_unit": "pound")") + "]", "axes.0.effort_unit"},
        {"[" + changed(R"("settle_s": 2)", R"("settle_s": -2)") + "]", "axes.0.settle_s"},
        {"[" + changed(R"("settle_s": 2)", R"("colour": 2)") + "]", "axes.0.colour"},
        {"[" + changed(R"("turns_forever": false)", R"("turns_forever": 0)") + "]", "axes.0.turns_forever"},
        {"[" + changed(R"("speed": "speed.z")", R"("speed": "nothing")") + "]", "axes.0.roles.speed"},
        {"[" + changed(R"("speed": "speed.z")", R"("velocity": "speed.z")") + "]", "axes.0.roles.velocity"},
        {"[" + std::string(Axis) + "," + Axis + "]", "axes.1.id"}};
    for (const auto& [axes, place] : mistakes) {
        const auto profile = parseProfile(profileWith(axes), "x.json");
        ASSERT_FALSE(profile) << axes;
        EXPECT_EQ(profile.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(profile.error().message.find(place), std::string::npos) << profile.error().message;
    }
}

TEST(ProfileAxes, boardThatLacksThePositionHasNoSuchAxis) {
    const auto profile = parseProfile(profileWith("[" + std::string(Axis) + "]"), "x.json");
    ASSERT_TRUE(profile);
    Catalogue without;
    applyProfile(*profile, without);
    EXPECT_TRUE(without.axes.empty());
    Catalogue with;
    with.signals.resize(1);
    with.signals[0].name = "z";
    applyProfile(*profile, with);
    ASSERT_NE(with.findAxis("z"), nullptr);
    EXPECT_EQ(with.findAxis("x"), nullptr);
}

TEST(ProfileAxes, shippedDevicesHaveTheirs) {
    const std::vector<std::pair<const char*, std::vector<std::string>>> devices = {
        {"htm", {"angle"}}, {"planar", {"x", "y", "phi"}}, {"spherical", {}}};
    for (const auto& [model, ids] : devices) {
        const auto profile = findProfile(model);
        ASSERT_TRUE(profile && *profile) << model;
        std::vector<std::string> found;
        for (const AxisSpec& axis : (*profile)->axes) {
            found.push_back(axis.id);
        }
        EXPECT_EQ(found, ids) << model;
    }
    // The motor's axis is what a board without a profile is taken for.
    const AxisSpec motor = (*findProfile("htm"))->axes.front();
    EXPECT_EQ(motor.windowMargin, AxisSpec{}.windowMargin);
    EXPECT_EQ(motor.endTolerance, AxisSpec{}.endTolerance);
    EXPECT_EQ(motor.roles.effort, AxisSpec{}.roles.effort);
}

} // namespace
} // namespace halbench::devices
