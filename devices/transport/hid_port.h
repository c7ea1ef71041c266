#pragma once

#include "devices/transport/octet_port.h"
#include "devices/transport/port_listing.h"

#include <array>
#include <memory>
#include <vector>

namespace halbench::devices {

constexpr std::size_t HidReportOctets = 64;
using HidReport = std::array<std::uint8_t, HidReportOctets>;

/// A stream in reports of `N | N octets | zeros` (resources/help/protocol.md 3.4), as many as it needs.
std::vector<HidReport> reportsFor(std::span<const std::uint8_t> octets);
/// What a report carries; empty when it is not whole or lies about its length.
std::span<const std::uint8_t> octetsOf(std::span<const std::uint8_t> report);

/// A HID device with a vendor's usage page: no driver to install, at most 63 octets a millisecond. Thread:
/// one, the connection's.
class HidPort : public OctetPort {
public:
    explicit HidPort(UsbName name);
    ~HidPort() override;
    HidPort(const HidPort&) = delete;
    HidPort& operator=(const HidPort&) = delete;

    Result<void> open(OctetInbox& inbox) override;
    void close() noexcept override;
    Result<void> write(std::span<const std::uint8_t> octets) override;
    std::string description() const override { return "hid:" + m_name.text(); }

private:
    class Reports;

    UsbName m_name;
    std::unique_ptr<Reports> m_reports;
};

} // namespace halbench::devices
