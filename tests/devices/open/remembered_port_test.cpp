#include "devices/open/remembered_port.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

DeviceListing port(const std::string& uri, const std::string& serial) {
    DeviceListing listing;
    listing.uri = uri;
    listing.id = serial;
    return listing;
}

TEST(RememberedPort, findsADeviceWhosePortHasAnotherNameNow) {
    const RememberedPort remembered =
        rememberPort("serial:/dev/ttyACM0?baud=9600",
                     {port("serial:/dev/ttyACM1", "B"), port("serial:/dev/ttyACM0", "A")});
    EXPECT_EQ(remembered.serial, "A");
    const std::vector<DeviceListing> elsewhere{port("serial:/dev/ttyACM0", "B"),
                                               port("serial:/dev/ttyACM3", "A")};
    EXPECT_EQ(addressNow(remembered, elsewhere).value(), "serial:/dev/ttyACM3?baud=9600");
}

TEST(RememberedPort, neverNamesAnotherDeviceThatHasTheOldPort) {
    const RememberedPort remembered{"serial:/dev/ttyACM0", "A"};
    const auto now = addressNow(remembered, {port("serial:/dev/ttyACM0", "B")});
    ASSERT_FALSE(now);
    EXPECT_EQ(now.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(now.error().message.find("'A'"), std::string::npos);
}

TEST(RememberedPort, withoutASerialNumberOnlyTheNameCounts) {
    const RememberedPort remembered = rememberPort("serial:/dev/pts/4", {port("serial:/dev/ttyACM0", "A")});
    EXPECT_EQ(remembered.serial, "");
    EXPECT_EQ(addressNow(remembered, {}).value(), "serial:/dev/pts/4");
    EXPECT_EQ(addressNow(rememberPort("tcp:bench:5555", {}), {}).value(), "tcp:bench:5555");
}

TEST(RememberedPort, aUsbNameWithoutSerialNumberGetsTheOneThatAnswered) {
    const RememberedPort remembered =
        rememberPort("usb:1209:0001", {port("hid:1209:0001:C", "C"), port("usb:1209:0001:A", "A")});
    EXPECT_EQ(remembered.serial, "A");
    const std::vector<DeviceListing> both{port("usb:1209:0001:B", "B"), port("usb:1209:0001:A", "A")};
    EXPECT_EQ(addressNow(remembered, both).value(), "usb:1209:0001:A");
    EXPECT_FALSE(addressNow(remembered, {port("usb:1209:0001:B", "B"), port("hid:1209:0001:A", "A")}));
}

TEST(RememberedPort, prefersTheSameNameAndElseAsksWhenTwoPortsHaveTheNumber) {
    const RememberedPort remembered{"serial:/dev/ttyACM0", "A"};
    const std::vector<DeviceListing> two{port("serial:/dev/ttyACM1", "A"), port("serial:/dev/ttyACM0", "A")};
    EXPECT_EQ(addressNow(remembered, two).value(), "serial:/dev/ttyACM0"); // a board with two ports
    const auto moved =
        addressNow(remembered, {port("serial:/dev/ttyACM2", "A"), port("serial:/dev/ttyACM3", "A")});
    ASSERT_FALSE(moved);
    EXPECT_NE(moved.error().message.find("several"), std::string::npos);
}

} // namespace
} // namespace halbench::devices
