#include "app/procedures/base/axis_zero.h"
#include "app/procedures/move/move_procedure.h"
#include "tests/app/procedures/simulated_motor.h"

#include <algorithm>

namespace halbench::app {
namespace {

std::unique_ptr<devices::Device> opened(const std::string& uri) {
    auto device = devices::openDevice(uri, {});
    EXPECT_TRUE(device) << device.error().message;
    return device ? std::move(*device) : nullptr;
}

MoveConfig stepOf(const std::string& amplitude_mm) {
    MoveConfig config = move("step,amplitude_mm=" + amplitude_mm, 0.3);
    config.axis = "x";
    return config;
}

bool saysHomedHere(const DataQuality& quality) {
    return std::ranges::any_of(quality.findings,
                               [](const Finding& finding) { return finding.code == "homed_here"; });
}

TEST(AxisZero, isTakenOnceWhereTheDeviceStands) {
    const auto device = opened("sim:planar?imperfections=off&x0_mm=30&y0_mm=-30");
    ASSERT_NE(device, nullptr);
    const auto first = awaitZero(*device, {});
    ASSERT_TRUE(first) << first.error().message;
    EXPECT_TRUE(*first);
    EXPECT_FALSE(device->state().isArmed);
    const auto second = awaitZero(*device, {});
    ASSERT_TRUE(second);
    EXPECT_FALSE(*second);
}

TEST(AxisZero, isNothingThatAMotorLacks) {
    const auto device = opened("sim:htm");
    ASSERT_NE(device, nullptr);
    const auto known = awaitZero(*device, {});
    ASSERT_TRUE(known);
    EXPECT_FALSE(*known);
}

// A pitch is 50.8 mm: at 30 mm the readings are those of -20.8 mm, and the cell is a guess that the result
// names.
TEST(AxisZero, isNamedByTheMoveThatGuessedItAndByNoOther) {
    const auto device = opened("sim:planar?imperfections=off&x0_mm=30");
    ASSERT_NE(device, nullptr);
    EXPECT_TRUE(saysHomedHere(moved(*device, stepOf("1")).quality));
    EXPECT_FALSE(saysHomedHere(moved(*device, stepOf("1")).quality));
}

TEST(AxisZero, isNamedByARefusalThatCountsFromIt) {
    const auto device = opened("sim:planar?imperfections=off&x0_mm=30");
    ASSERT_NE(device, nullptr);
    const auto first = runMove(*device, stepOf("-31"), {});
    ASSERT_FALSE(first);
    EXPECT_EQ(first.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(first.error().hint.find(homedHere().message), std::string::npos) << first.error().hint;
    const auto second = runMove(*device, stepOf("-31"), {});
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().hint.find(homedHere().message), std::string::npos) << second.error().hint;
}

} // namespace
} // namespace halbench::app
