#include "app/documents/result_header.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

devices::DeviceInfo board(const std::string& id, bool isSimulated = false) {
    devices::DeviceInfo info;
    info.model = "htm";
    info.id = id;
    info.isSimulated = isSimulated;
    return info;
}

TEST(ForeignMotor, ofTheSameDeviceThereIsNothingToSay) {
    EXPECT_FALSE(foreignMotor(board("seven"), board("seven")));
}

TEST(ForeignMotor, anotherIdentityOrModelIsNamed) {
    const auto other = foreignMotor(board("seven"), board("eight"));
    ASSERT_TRUE(other);
    EXPECT_EQ(other->code, "other_device");
    EXPECT_NE(other->message.find("'seven'"), std::string::npos);
    EXPECT_NE(other->message.find("'eight'"), std::string::npos);
    devices::DeviceInfo planar = board("seven");
    planar.model = "planar";
    EXPECT_TRUE(foreignMotor(board("seven"), planar));
    EXPECT_TRUE(foreignMotor(board("seven"), board(""))); // it does not say that it is the same
}

TEST(ForeignMotor, anUnknownOriginIsNotJudged) {
    EXPECT_FALSE(foreignMotor(std::nullopt, board("eight")));
    EXPECT_FALSE(foreignMotor(board(""), board("eight")));
}

TEST(ForeignMotor, overridesMakeAnotherMotorOnlyOfSimulatedOnes) {
    devices::DeviceInfo changed = board("sim", true);
    changed.overrides = {{"c", "0.002"}};
    const auto other = foreignMotor(changed, board("sim", true));
    ASSERT_TRUE(other);
    EXPECT_NE(other->message.find("overrides"), std::string::npos);
    EXPECT_FALSE(foreignMotor(changed, board("sim"))); // a served one has its overrides with its server
}

} // namespace
} // namespace halbench::app
