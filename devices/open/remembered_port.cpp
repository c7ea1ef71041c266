#include "devices/open/remembered_port.h"

#include "devices/device_uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

namespace {

/// "serial:/dev/ttyACM0?baud=9600" -> "serial:/dev/ttyACM0" and "?baud=9600"
std::pair<std::string, std::string> splitOptions(const std::string& uri) {
    const std::size_t mark = std::min(uri.find('?'), uri.size());
    return {uri.substr(0, mark), uri.substr(mark)};
}

/// `usb:VID:PID` names every serial number of it.
bool isNamedBy(const DeviceListing& listing, const std::string& address) {
    const auto isCounted = [&](const char* scheme) { return address.rfind(scheme, 0) == 0; };
    return listing.uri == address ||
           ((isCounted("usb:") || isCounted("hid:")) && listing.uri.rfind(address + ":", 0) == 0);
}

std::string kindOf(const std::string& uri) {
    return uri.substr(0, uri.find(':'));
}

} // namespace

RememberedPort rememberPort(const std::string& uri, const std::vector<DeviceListing>& listed) {
    const std::string address = splitOptions(uri).first;
    const auto found = std::find_if(listed.begin(), listed.end(), [&](const DeviceListing& listing) {
        return !listing.isSimulated && isNamedBy(listing, address);
    });
    return {uri, found == listed.end() ? std::string() : found->id};
}

Result<std::string> addressNow(const RememberedPort& port, const std::vector<DeviceListing>& listed) {
    if (port.serial.empty()) {
        return port.uri;
    }
    const auto [address, options] = splitOptions(port.uri);
    std::vector<std::string> places;
    for (const DeviceListing& listing : listed) {
        if (listing.id == port.serial && kindOf(listing.uri) == kindOf(address)) {
            places.push_back(listing.uri);
        }
    }
    const auto same = std::find_if(places.begin(), places.end(), [&, name = address](const auto& place) {
        return place == name || place.rfind(name + ":", 0) == 0;
    });
    if (same != places.end()) {
        return *same + options;
    }
    if (places.empty()) {
        return failure(ErrorCode::DeviceLost,
                       fmt::format("no device with the serial number '{}' is plugged in", port.serial),
                       "plug it in to any port");
    }
    if (places.size() > 1) {
        return failure(ErrorCode::DeviceLost,
                       fmt::format("several ports have the serial number '{}': {} and {}", port.serial,
                                   places[0], places[1]),
                       "name one of them");
    }
    return places.front() + options;
}

} // namespace halbench::devices
