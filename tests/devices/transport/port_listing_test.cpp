#include "devices/transport/hid_port.h"
#include "devices/transport/port_listing.h"
#include "devices/transport/usb_port.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

PortListing port(PortKind kind, const std::string& node, const std::string& serial) {
    PortListing listing;
    listing.kind = kind;
    listing.node = node;
    listing.uri = "uri-of-" + node;
    listing.vendor = 0x1209;
    listing.product = 1;
    listing.serial = serial;
    return listing;
}

TEST(PortListing, readsTheNameOfAUsbDevice) {
    const auto name = parseUsbName("1209:0a01:HB:7");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->vendor, 0x1209);
    EXPECT_EQ(name->product, 0x0A01);
    EXPECT_EQ(name->serial, "HB:7");
    EXPECT_EQ(name->text(), "1209:0a01:HB:7");
    EXPECT_EQ(parseUsbName("1209:0a01")->text(), "1209:0a01");
    for (const char* wrong : {"1209", "1209:", ":1", "12090:1", "1209:xyz", "0x1209:1", "1209:1 :s"}) {
        const auto refused = parseUsbName(wrong);
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(refused.error().hint.find("hexadecimal"), std::string::npos);
    }
}

TEST(PortListing, findsOnePortByNameOrSerialNumber) {
    const std::vector<PortListing> ports = {port(PortKind::UsbBulk, "a", "1"),
                                            port(PortKind::UsbBulk, "b", "2"), port(PortKind::Hid, "c", "3")};
    EXPECT_EQ(findPort(ports, PortKind::UsbBulk, {0x1209, 1, "2"})->node, "b");
    EXPECT_EQ(findPort(ports, PortKind::Hid, {0x1209, 1, ""})->node, "c");
    const auto several = findPort(ports, PortKind::UsbBulk, {0x1209, 1, ""});
    ASSERT_FALSE(several);
    EXPECT_NE(several.error().message.find("several"), std::string::npos);
    EXPECT_NE(several.error().hint.find("uri-of-b"), std::string::npos);
}

TEST(PortListing, aMissingOneIsToldApartFromAnotherOne) {
    const std::vector<PortListing> ports = {port(PortKind::Hid, "c", "3")};
    const auto none = findPort({}, PortKind::Hid, {0x1209, 1, ""});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::DeviceLost);
    EXPECT_EQ(none.error().message, "no HID device 1209:0001 is plugged in");
    const auto other = findPort(ports, PortKind::Hid, {0x1209, 1, "4"});
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().message.find("serial number '3'"), std::string::npos);
    const auto kind = findPort(ports, PortKind::UsbBulk, {0x1209, 1, ""});
    ASSERT_FALSE(kind);
    EXPECT_NE(kind.error().message.find("it is a HID device"), std::string::npos);
    EXPECT_NE(kind.error().hint.find("uri-of-c"), std::string::npos);
}

TEST(PortListing, listingOpensNothingAndAlwaysWorks) {
    for (const PortListing& listing : listPorts()) {
        EXPECT_FALSE(listing.node.empty());
        EXPECT_EQ(listing.reason.empty(), listing.hint.empty()) << listing.node;
    }
}

TEST(UsbPort, aDeviceThatIsNotThereIsADeviceLost) {
    OctetInbox inbox;
    UsbPort usb({0xFFFF, 0xFFFE, ""});
    const auto opened = usb.open(inbox);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::DeviceLost);
    EXPECT_FALSE(usb.write(std::vector<std::uint8_t>{1}));
    HidPort hid({0xFFFF, 0xFFFE, ""});
    EXPECT_FALSE(hid.open(inbox));
    EXPECT_FALSE(hid.write(std::vector<std::uint8_t>{1}));
    EXPECT_EQ(hid.description(), "hid:ffff:fffe");
}

TEST(HidPort, reportsCarryTheStreamInPiecesOf63) {
    std::vector<std::uint8_t> stream(130);
    for (std::size_t i = 0; i < stream.size(); ++i) {
        stream[i] = static_cast<std::uint8_t>(i);
    }
    const auto reports = reportsFor(stream);
    ASSERT_EQ(reports.size(), 3U);
    std::vector<std::uint8_t> again;
    for (const HidReport& report : reports) {
        const auto part = octetsOf(report);
        again.insert(again.end(), part.begin(), part.end());
    }
    EXPECT_EQ(again, stream);
    EXPECT_EQ(reports[2][0], 4);
    EXPECT_EQ(reports[2][5], 0) << "filled with zeros";
    HidReport lie{};
    lie[0] = 64;
    EXPECT_TRUE(octetsOf(lie).empty());
    EXPECT_TRUE(octetsOf({}).empty());
}

} // namespace
} // namespace halbench::devices
