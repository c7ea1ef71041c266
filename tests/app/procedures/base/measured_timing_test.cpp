#include "app/procedures/base/measured_timing.h"

#include <gtest/gtest.h>

#include <array>

namespace halbench::app {
namespace {

devices::Catalogue board() {
    devices::Catalogue catalogue;
    catalogue.knownConstants = {{"T_s", 0.01}};
    ParameterSpec delay;
    delay.name = "computing.delay";
    delay.role = "delay.samples";
    catalogue.parameters.push_back(delay);
    return catalogue;
}

TEST(MeasuredTiming, isWhatTheDeviceSaysOfItself) {
    const std::array<ParameterValue, 2> values = {ParameterValue{"gain.kp", 2.0},
                                                  ParameterValue{"computing.delay", 1.0}};
    EXPECT_EQ(timingOf(board(), values), (MeasuredTiming{0.01, 1}));
    EXPECT_EQ(timingOf(board(), {}), (MeasuredTiming{0.01, std::nullopt}));
    EXPECT_EQ(timingOf(devices::Catalogue{}, values), MeasuredTiming{}); // no role, no constant
}

TEST(MeasuredTiming, takesTheOtherWhereItIsNotKnown) {
    EXPECT_EQ(timingOr({}, {0.002, 2}), (control::LoopTiming{0.002, 2}));
    EXPECT_EQ(timingOr({std::nullopt, 1}, {0.002, 2}), (control::LoopTiming{0.002, 1}));
    EXPECT_EQ(timingOr({0.01, 0}, {0.002, 2}), (control::LoopTiming{0.01, 0}));
}

TEST(MeasuredTiming, aContradictionIsRefusedWithBoth) {
    EXPECT_TRUE(checkTimingOfModel({}, {0.01, 2}));
    EXPECT_TRUE(checkTimingOfModel({0.01F, 1}, {0.01, 1})); // single precision on the board
    EXPECT_TRUE(checkTimingOfModel({0.01, std::nullopt}, {0.01, 1}));
    for (const MeasuredTiming& other :
         {MeasuredTiming{0.01, 1}, MeasuredTiming{0.005, 0}, MeasuredTiming{std::nullopt, 2}}) {
        const auto same = checkTimingOfModel(other, {0.01, 0});
        ASSERT_FALSE(same);
        EXPECT_EQ(same.error().code, ErrorCode::Refused);
        EXPECT_NE(same.error().message.find("this device has 0.01 s and 0"), std::string::npos)
            << same.error().message;
        EXPECT_FALSE(same.error().hint.empty());
    }
}

} // namespace
} // namespace halbench::app
