#include "devices/acquisition/stream_rate.h"

#include "devices/device_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>

namespace halbench::devices {

namespace {

constexpr double RelativeRounding = 1e-9;
constexpr int UsualBaud = 115200;
constexpr double BitsPerOctet = 10.0; ///< start, eight, stop
constexpr double ValueOctets = 4.0;
constexpr double PacketOctets = 64.0;
constexpr double OctetsBeside = 8.0; ///< of a packet: frame, counter, identification, time stamp, sum
constexpr double Reports_Hz = 1000.0;

/// As the address says, which was checked when the port was opened; else that of the default profile.
double baudOf(const DeviceInfo& info) {
    const Result<DeviceUri> uri = parseDeviceUri(info.uri);
    const std::string text = uri ? uri->option("baud").value_or("") : "";
    int baud = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), baud);
    return read.ec == std::errc() && baud > 0 ? baud : UsualBaud;
}

double linkRate_Hz(const DeviceInfo& info, std::size_t signals) {
    const double octets = ValueOctets * static_cast<double>(signals);
    const double packets = std::ceil(octets / PacketOctets);
    if (info.transport == "serial") {
        return baudOf(info) / BitsPerOctet / (octets + OctetsBeside * packets);
    }
    return info.transport == "hid" ? Reports_Hz / packets : std::numeric_limits<double>::infinity();
}

} // namespace

double wholePart_Hz(double rate_Hz, double most_Hz) {
    if (!(rate_Hz > 0.0) || !(most_Hz > 0.0)) {
        return 0.0;
    }
    return rate_Hz / std::max(1.0, std::ceil(rate_Hz / most_Hz * (1.0 - RelativeRounding)));
}

double greatestRate_Hz(const DeviceInfo& info, const Catalogue& catalogue,
                       const std::vector<std::string>& signals) {
    double common_Hz = std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    for (const std::string& name : signals) {
        if (const SignalSpec* spec = catalogue.findSignal(name)) {
            common_Hz = std::min(common_Hz, spec->maxRate_Hz);
            ++count;
        }
    }
    if (count == 0) {
        return 0.0;
    }
    const double link_Hz = linkRate_Hz(info, count);
    return std::isfinite(common_Hz) ? wholePart_Hz(common_Hz, link_Hz) : link_Hz;
}

Result<void> checkStreamRate(const DeviceInfo& info, const Catalogue& catalogue,
                             const std::vector<std::string>& signals, double rate_Hz) {
    const double greatest_Hz = greatestRate_Hz(info, catalogue, signals);
    if (greatest_Hz <= 0.0 || rate_Hz <= greatest_Hz * (1.0 + RelativeRounding)) {
        return {}; // what has no rate at all is refused by the board's own plan
    }
    return failure(
        ErrorCode::OutOfRange,
        signals.size() == 1
            ? fmt::format("one signal at {:.6g} Hz is not possible: maximum of device and link {:.6g} Hz",
                          rate_Hz, greatest_Hz)
            : fmt::format("{} signals at {:.6g} Hz are not possible: maximum of device and link {:.6g} Hz",
                          signals.size(), rate_Hz, greatest_Hz),
        info.transport == "serial" ? "use a lower rate or fewer signals; for a port that is USB up to the "
                                     "device, give its real speed in the address with ?baud=12000000"
                                   : "use a lower rate or fewer signals");
}

} // namespace halbench::devices
