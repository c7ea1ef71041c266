#include "devices/open/port_address.h"

#include "devices/transport/framed_transport.h"
#include "devices/transport/hid_port.h"
#include "devices/transport/stream_codec.h"
#include "devices/transport/usb_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace halbench::devices {

namespace {

constexpr int MinBaud = 300;
constexpr int MaxBaud = 12'000'000;
/// A board that the opening of its port resets needs up to 2 s (resources/help/protocol.md 3.6).
constexpr double SerialPatience_s = 3.2;
constexpr double UsbPatience_s = 1.8;

struct Option {
    const DeviceUri* uri;
    const std::string* key;
    const std::string* value;
};

tl::unexpected<Error> wrongOption(const Option& option, ErrorCode code, const std::string& hint) {
    return failure(code, fmt::format("device '{}': {}={}", option.uri->text, *option.key, *option.value),
                   hint);
}

/// The place of the value among the words.
template <typename Words>
Result<std::size_t> wordOf(const Option& option, const Words& words) {
    const auto found = std::find(words.begin(), words.end(), *option.value);
    if (found == words.end()) {
        return wrongOption(option, ErrorCode::UnknownName, fmt::format("use {}", fmt::join(words, ", ")));
    }
    return static_cast<std::size_t>(found - words.begin());
}

Result<int> numberOf(const Option& option, int base, int min, int max) {
    int number = 0;
    const std::string& text = *option.value;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number, base);
    const bool isNumber = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    if (!isNumber || number < min || number > max) {
        return wrongOption(option, ErrorCode::OutOfRange,
                           base == 16 ? "give one byte in hexadecimal digits, e.g. 9A"
                                      : fmt::format("give a whole number from {} to {}", min, max));
    }
    return number;
}

constexpr std::array<const char*, 2> Switch = {"off", "on"};
constexpr std::array Headers = {"len_byte", "len_ctr_byte", "len_fill_byte",
                                "len_word", "len_ctr_word", "len_fill_word"};
constexpr std::array Checksums = {"none", "byte", "word"};

/// The port itself; false when the option is not one of its own.
Result<bool> readSetting(const Option& option, SerialSettings& settings) {
    const std::string& key = *option.key;
    if (key == "baud") {
        const Result<int> baud = numberOf(option, 10, MinBaud, MaxBaud);
        settings.baud = baud.value_or(0);
        return baud.map([](int) { return true; });
    }
    if (key != "dtr" && key != "low_latency") {
        return false;
    }
    const Result<std::size_t> isOn = wordOf(option, Switch);
    if (isOn && key == "dtr") {
        settings.isDtrOn = *isOn == 1;
    } else if (isOn) {
        settings.isLowLatency = *isOn == 1;
    }
    return isOn.map([](std::size_t) { return true; });
}

/// How packets lie on the line; false when the option says nothing of it.
Result<bool> readProfile(const Option& option, SxiProfile& profile) {
    const std::string& key = *option.key;
    const auto yes = [](auto) { return true; };
    if (key == "framing") {
        const Result<std::size_t> isOn = wordOf(option, Switch);
        profile.isFramed = isOn.value_or(0) == 1;
        return isOn.map(yes);
    }
    if (key == "header") {
        const Result<std::size_t> header = wordOf(option, Headers);
        profile.header = static_cast<SxiHeader>(header.value_or(0));
        return header.map(yes);
    }
    if (key == "checksum") {
        const Result<std::size_t> checksum = wordOf(option, Checksums);
        profile.checksum = static_cast<SxiChecksum>(checksum.value_or(0));
        return checksum.map(yes);
    }
    if (key == "sync" || key == "escape") {
        const Result<int> octet = numberOf(option, 16, 0, 0xFF);
        (key == "sync" ? profile.sync : profile.escape) = static_cast<std::uint8_t>(octet.value_or(0));
        return octet.map(yes);
    }
    return false;
}

/// What boards in the field use, tried in this order (3.6).
std::vector<SxiProfile> usualProfiles() {
    return {SxiProfile{}, SxiProfile{SxiHeader::LenByte, SxiChecksum::Byte, true},
            SxiProfile{SxiHeader::LenCtrByte, SxiChecksum::Word, false},
            SxiProfile{SxiHeader::LenCtrWord, SxiChecksum::None, false}};
}

} // namespace

Result<SerialAddress> parseSerialAddress(const DeviceUri& uri) {
    SerialAddress address;
    address.settings.device = uri.address;
    SxiProfile profile;
    bool isProfileGiven = false;
    for (const auto& [key, value] : uri.options) {
        const Option option{&uri, &key, &value};
        Result<bool> known = readSetting(option, address.settings);
        if (known && !*known) {
            known = readProfile(option, profile);
            isProfileGiven = isProfileGiven || known.value_or(false);
        }
        if (!known) {
            return failure(known.error());
        }
        if (!*known) {
            return failure(ErrorCode::UnknownName,
                           fmt::format("device '{}': unknown option '{}'", uri.text, key),
                           "known are baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l");
        }
    }
    if (profile.sync == profile.escape) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("device '{}': sync and escape are the same", uri.text),
                       "use two different bytes");
    }
    address.profiles = isProfileGiven ? std::vector{profile} : usualProfiles();
    return address;
}

Result<std::unique_ptr<Transport>> makeSerialTransport(const DeviceUri& uri) {
    const Result<SerialAddress> address = parseSerialAddress(uri);
    if (!address) {
        return failure(address.error());
    }
    FramedTransport::Codecs codecs;
    for (const SxiProfile& profile : address->profiles) {
        codecs.push_back(std::make_unique<SxiCodec>(profile));
    }
    return std::make_unique<FramedTransport>(std::make_unique<SerialPort>(address->settings),
                                             std::move(codecs), SerialPatience_s);
}

Result<void> refuseOptions(const DeviceUri& uri) {
    if (uri.options.empty()) {
        return {};
    }
    return failure(ErrorCode::UnknownName,
                   fmt::format("device '{}': unknown option '{}'", uri.text, uri.options.front().first),
                   fmt::format("{}: addresses accept no option except a2l", uri.scheme));
}

Result<std::unique_ptr<Transport>> makeUsbTransport(const DeviceUri& uri) {
    const Result<UsbName> name = parseUsbName(uri.address);
    if (!name) {
        return failure(name.error());
    }
    if (Result<void> plain = refuseOptions(uri); !plain) {
        return failure(plain.error());
    }
    std::unique_ptr<OctetPort> port;
    if (uri.scheme == "hid") {
        port = std::make_unique<HidPort>(*name);
    } else {
        port = std::make_unique<UsbPort>(*name);
    }
    FramedTransport::Codecs codecs;
    codecs.push_back(std::make_unique<StreamCodec>());
    return std::make_unique<FramedTransport>(std::move(port), std::move(codecs), UsbPatience_s);
}

} // namespace halbench::devices
