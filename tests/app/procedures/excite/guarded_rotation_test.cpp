#include "app/procedures/excite/guarded_rotation.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

SampleBlock speeds(std::vector<double> values) {
    SampleBlock block;
    block.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"speed", "rad/s"}}, 0.01});
    block.time_s.resize(values.size());
    block.values = std::move(values);
    return block;
}

Result<void> judged(const TurnLimits& limits, std::vector<double> values, bool isOn = true) {
    TurnWatch watch(limits);
    if (isOn) {
        watch.begin();
    }
    watch.take(speeds(std::move(values)));
    return watch.check();
}

const TurnLimits Forward{6.0, 10.0, "go faster"};
const TurnLimits Backward{-6.0, 10.0, "go faster"};

TEST(TurnWatch, letsPassWhatWasForeseenInBothDirections) {
    EXPECT_TRUE(judged(Forward, {6.0, 0.7, 14.9}));
    EXPECT_TRUE(judged(Backward, {-6.0, -0.7, -14.9}));
    EXPECT_TRUE(judged(Forward, {}));
}

TEST(TurnWatch, endsNearStandstillAndWhenItTurnsBack) {
    for (const auto& [limits, speed] : {std::pair(Forward, 0.5), std::pair(Forward, -6.0),
                                        std::pair(Backward, -0.5), std::pair(Backward, 6.0)}) {
        const auto result = judged(limits, {limits.turn_rad_s, speed});
        ASSERT_FALSE(result) << speed;
        EXPECT_EQ(result.error().code, ErrorCode::Refused);
        EXPECT_NE(result.error().message.find("the speed fell"), std::string::npos) << result.error().message;
        EXPECT_EQ(result.error().hint, "go faster");
    }
}

TEST(TurnWatch, endsWhenItIsFasterThanOneAndAHalfTimesWhatWasForeseen) {
    for (const auto& [limits, speed] : {std::pair(Forward, 15.1), std::pair(Backward, -15.1)}) {
        const auto result = judged(limits, {speed});
        ASSERT_FALSE(result) << speed;
        EXPECT_NE(result.error().message.find("15.1"), std::string::npos) << result.error().message;
    }
    EXPECT_TRUE(judged({6.0, 0.0, ""}, {100.0})) << "nothing is foreseen: the board's window holds";
}

TEST(TurnWatch, doesNotJudgeTheRunUp) {
    EXPECT_TRUE(judged(Forward, {0.0, 0.1}, false));
}

} // namespace
} // namespace halbench::app
