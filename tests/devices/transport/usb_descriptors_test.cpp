#include "devices/transport/usb_descriptors.h"

#include <gtest/gtest.h>

#include <vector>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

const Octets DeviceDescriptor{18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 1, 0, 0, 1, 1, 2, 3, 1};
const Octets Configuration{9, 2, 0, 0, 1, 1, 0, 0x80, 50};

Octets interface(std::uint8_t number, std::uint8_t alternate, std::uint8_t interfaceClass) {
    return {9, 4, number, alternate, 2, interfaceClass, 0, 0, 0};
}

Octets endpoint(std::uint8_t address, std::uint8_t attributes) {
    return {7, 5, address, attributes, 64, 0, 0};
}

Octets joined(const std::vector<Octets>& parts) {
    Octets all = DeviceDescriptor;
    all.insert(all.end(), Configuration.begin(), Configuration.end());
    for (const Octets& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

TEST(UsbDescriptors, readsTheEndpointsFromTheDevice) {
    const auto pair = bulkPairOf(joined({interface(0, 0, 0xFF), endpoint(0x81, 2), endpoint(0x02, 2)}));
    EXPECT_EQ(pair, (BulkPair{0, 0x81, 0x02}));
}

TEST(UsbDescriptors, takesTheVendorsInterfaceAmongOthers) {
    const Octets composite = joined({interface(0, 0, 0x02), endpoint(0x83, 3), interface(1, 0, 0x0A),
                                     endpoint(0x81, 2), endpoint(0x01, 2), interface(2, 0, 0xFF),
                                     endpoint(0x85, 3), endpoint(0x84, 2), endpoint(0x04, 2)});
    EXPECT_EQ(bulkPairOf(composite), (BulkPair{2, 0x84, 0x04}));
    EXPECT_EQ(bulkPairOf(composite, 2), (BulkPair{2, 0x84, 0x04}));
    EXPECT_FALSE(bulkPairOf(composite, 1)) << "a serial port's data interface is the system's";
}

TEST(UsbDescriptors, aPairHasToBeCompleteAndBulk) {
    EXPECT_FALSE(bulkPairOf(joined({interface(0, 0, 0xFF), endpoint(0x81, 2)})));
    EXPECT_FALSE(bulkPairOf(joined({interface(0, 0, 0xFF), endpoint(0x81, 3), endpoint(0x01, 3)})));
    EXPECT_FALSE(bulkPairOf(joined({interface(0, 1, 0xFF), endpoint(0x81, 2), endpoint(0x01, 2)})))
        << "an alternate setting would have to be switched on first";
}

TEST(UsbDescriptors, damagedOnesEndTheSearch) {
    const Octets good = joined({interface(0, 0, 0xFF), endpoint(0x81, 2), endpoint(0x01, 2)});
    for (std::size_t length = 0; length < good.size(); ++length) {
        EXPECT_FALSE(bulkPairOf(std::span(good).first(length))) << length;
    }
    EXPECT_FALSE(bulkPairOf(Octets(40, 0)));
    EXPECT_FALSE(bulkPairOf(Octets{1, 4, 1, 4}));
}

TEST(UsbDescriptors, onlyAVendorsUsagePageIsABoard) {
    EXPECT_TRUE(isVendorReport(Octets{0x06, 0x00, 0xFF, 0x09, 0x01}));
    EXPECT_FALSE(isVendorReport(Octets{0x05, 0x01, 0x09, 0x06})) << "a keyboard";
    EXPECT_FALSE(isVendorReport(Octets{0x06, 0x00}));
}

} // namespace
} // namespace halbench::devices
