#include "devices/transport/usb_descriptors.h"

namespace halbench::devices {

namespace {

// USB 2.0 specification, chapter 9.6.
constexpr std::uint8_t InterfaceDescriptor = 4;
constexpr std::uint8_t EndpointDescriptor = 5;
constexpr std::uint8_t VendorClass = 0xFF;
constexpr std::uint8_t TransferTypeMask = 0x03;
constexpr std::uint8_t Bulk = 0x02;
constexpr std::uint8_t DirectionIn = 0x80;
// HID 1.11, 6.2.2.7: a global item "usage page" with two octets.
constexpr std::uint8_t UsagePage16 = 0x06;

} // namespace

std::optional<BulkPair> bulkPairOf(std::span<const std::uint8_t> descriptors, int interface) {
    BulkPair pair;
    bool isWanted = false;
    while (descriptors.size() >= 2) {
        const std::size_t length = descriptors[0];
        if (length < 2 || length > descriptors.size()) {
            break;
        }
        const std::uint8_t type = descriptors[1];
        if (type == InterfaceDescriptor && length >= 9) {
            const bool isFirstSetting = descriptors[3] == 0;
            pair = {descriptors[2], 0, 0};
            isWanted = isFirstSetting && descriptors[5] == VendorClass &&
                       (interface < 0 || interface == pair.interface);
        } else if (type == EndpointDescriptor && length >= 7 && isWanted &&
                   (descriptors[3] & TransferTypeMask) == Bulk) {
            std::uint8_t& end = (descriptors[2] & DirectionIn) != 0 ? pair.in : pair.out;
            end = end == 0 ? descriptors[2] : end;
            if (pair.in != 0 && pair.out != 0) {
                return pair;
            }
        }
        descriptors = descriptors.subspan(length);
    }
    return std::nullopt;
}

bool isVendorReport(std::span<const std::uint8_t> descriptor) {
    return descriptor.size() >= 3 && descriptor[0] == UsagePage16 && descriptor[2] == 0xFF;
}

} // namespace halbench::devices
