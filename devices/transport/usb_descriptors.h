#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace halbench::devices {

/// Where octets go in and out of a USB device.
struct BulkPair {
    int interface = 0;
    std::uint8_t in = 0; ///< endpoint addresses, as the device says: they differ between devices
    std::uint8_t out = 0;
    bool operator==(const BulkPair&) const = default;
};

/// The vendor-specific interface with a bulk endpoint each way, among the descriptors of the device (its own
/// first, then those of its configurations, as the system gives them). `interface` -1: the first. Nothing
/// when there is none.
std::optional<BulkPair> bulkPairOf(std::span<const std::uint8_t> descriptors, int interface = -1);

/// True when a HID report descriptor begins with a vendor's usage page (FF00 and above).
bool isVendorReport(std::span<const std::uint8_t> descriptor);

} // namespace halbench::devices
