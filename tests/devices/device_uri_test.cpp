#include "devices/device_uri.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(DeviceUri, hasSchemeAddressAndOptionsInTheOrderWritten) {
    const auto uri = parseDeviceUri("sim:htm?seed=7&c=2e-3&imperfections=off");
    ASSERT_TRUE(uri);
    EXPECT_EQ(uri->scheme, "sim");
    EXPECT_EQ(uri->address, "htm");
    ASSERT_EQ(uri->options.size(), 3U);
    EXPECT_EQ(uri->options[1], (std::pair<std::string, std::string>("c", "2e-3")));
    EXPECT_EQ(uri->option("seed"), "7");
    EXPECT_FALSE(uri->option("J"));
}

TEST(DeviceUri, knowsEveryScheme) {
    for (const char* text :
         {"sim:htm", "serial:/dev/ttyACM0?baud=115200", "usb:1209:0001:42", "hid:1209:0001", "tcp:[::1]:5555",
          "udp:localhost:5555", "replay:/tmp/a?b=c.csv"}) {
        EXPECT_TRUE(parseDeviceUri(text)) << text;
    }
    EXPECT_EQ(parseDeviceUri("replay:/tmp/a?b=c.csv")->address, "/tmp/a?b=c.csv")
        << "a file may have any name";
}

struct Wrong {
    const char* text;
    const char* place; ///< what the message must hold
};

class WrongDeviceUri : public testing::TestWithParam<Wrong> {};

TEST_P(WrongDeviceUri, isRefusedWithThePlace) {
    const auto uri = parseDeviceUri(GetParam().text);
    ASSERT_FALSE(uri);
    EXPECT_EQ(uri.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(uri.error().message.find(GetParam().place), std::string::npos) << uri.error().message;
    EXPECT_FALSE(uri.error().hint.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, WrongDeviceUri,
    testing::Values(Wrong{"", "character 1"}, Wrong{"htm", "character 4"}, Wrong{":htm", "character 1"},
                    Wrong{"sim:", "character 5"}, Wrong{"sim:?seed=1", "character 5"},
                    Wrong{"sim:htm?", "character 9"}, Wrong{"sim:htm?seed", "character 13"},
                    Wrong{"sim:htm?seed=", "character 14"}, Wrong{"sim:htm?=7", "character 9"},
                    Wrong{"sim:htm?se ed=7", "character 11"}, Wrong{"sim:htm?seed=7&", "character 16"},
                    Wrong{"sim:htm?seed=7&&c=1", "character 16"},
                    Wrong{"sim:htm?seed=7&seed=8", "character 16"}, Wrong{"sim:ht\nm", "character 7"}));

TEST(DeviceUri, unknownSchemeNamesTheKnownOnes) {
    const auto uri = parseDeviceUri("ftp:htm");
    ASSERT_FALSE(uri);
    EXPECT_EQ(uri.error().code, ErrorCode::UnknownName);
    EXPECT_NE(uri.error().hint.find("sim"), std::string::npos);
}

TEST(OpenDevice, refusesWhatIsNotBuiltWithAClearWord) {
    for (const char* text : {"serial:/dev/no-port?speed=9600", "usb:1209:0001?baud=1", "hid:1209:0001?x=1",
                             "udp:127.0.0.1:1?baud=1", "sim:unknown", "tcp:127.0.0.1:1?baud=1"}) {
        const auto device = openDevice(text, {});
        ASSERT_FALSE(device) << text;
        EXPECT_EQ(device.error().code, ErrorCode::UnknownName) << text;
        EXPECT_FALSE(device.error().hint.empty());
    }
    EXPECT_EQ(openDevice("replay:/nowhere/x.csv", {}).error().code, ErrorCode::FileSystem);
    EXPECT_EQ(openDevice("tcp:nonsense", {}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(openDevice("tcp:127.0.0.1:1?a2l=/nowhere/x.a2l", {}).error().code, ErrorCode::FileSystem);
}

TEST(DeviceUri, aDescriptionFileOfAnyNameGoesIntoTheAddressAndComesOut) {
    const std::string path = "/tmp/maker's & 100% = board?.a2l";
    const auto address = withDescription("serial:/dev/ttyUSB0?baud=9600&a2l=old.a2l", path);
    ASSERT_TRUE(address) << address.error().message;
    EXPECT_EQ(address->rfind("serial:/dev/ttyUSB0?baud=9600&a2l=", 0), 0U) << *address;
    auto uri = parseDeviceUri(*address);
    ASSERT_TRUE(uri) << uri.error().message;
    EXPECT_EQ(fileOfOption(uri->takeOption("a2l").value_or("")), path);
    EXPECT_FALSE(uri->takeOption("a2l"));
    EXPECT_EQ(uri->option("baud"), "9600");
    for (const char* self : {"sim:htm", "replay:run.csv", "nothing"}) {
        EXPECT_FALSE(withDescription(self, path)) << self;
    }
}

} // namespace
} // namespace halbench::devices
