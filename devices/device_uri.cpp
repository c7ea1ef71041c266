#include "devices/device_uri.h"

#include <QtCore/QByteArray>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace halbench::devices {

namespace {

/// Longer addresses are a mistake, not a device.
constexpr std::size_t MaxLength = 4096;

constexpr std::array Schemes = {"sim", "serial", "usb", "hid", "tcp", "udp", "replay"};

tl::unexpected<Error> wrongAt(const std::string& text, std::size_t place, const std::string& what,
                              const std::string& hint) {
    return failure(ErrorCode::InvalidInput,
                   fmt::format("device address '{}': {} at character {}", text, what, place + 1), hint);
}

bool isKeyCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

Result<void> checkCharacters(const std::string& text) {
    if (text.size() > MaxLength) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the device address has {} characters", text.size()),
                       fmt::format("at most {} are allowed", MaxLength));
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto octet = static_cast<unsigned char>(text[i]);
        if (octet < 0x20 || octet == 0x7F) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("the device address has a control character at character {}", i + 1),
                           "write it like sim:htm?seed=7");
        }
    }
    return {};
}

Result<void> readScheme(DeviceUri& uri, std::size_t& place) {
    const std::size_t colon = uri.text.find(':');
    if (colon == std::string::npos || colon == 0) {
        return wrongAt(uri.text, colon == 0 ? 0 : uri.text.size(), "a scheme and ':' are missing",
                       "write it like sim:htm, tcp:HOST:PORT or replay:FILE");
    }
    uri.scheme = uri.text.substr(0, colon);
    if (std::find(Schemes.begin(), Schemes.end(), uri.scheme) == Schemes.end()) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("device address '{}': unknown scheme '{}'", uri.text, uri.scheme),
                       fmt::format("known are {}", fmt::join(Schemes, ", ")));
    }
    place = colon + 1;
    return {};
}

Result<void> readOption(DeviceUri& uri, std::size_t begin, std::size_t end) {
    const std::size_t equals = uri.text.find('=', begin);
    const std::size_t keyEnd = std::min(equals, end);
    for (std::size_t i = begin; i < keyEnd; ++i) {
        if (!isKeyCharacter(uri.text[i])) {
            return wrongAt(uri.text, i, "a key has letters, digits and '_' only",
                           "write options as KEY=VALUE");
        }
    }
    if (keyEnd == begin) {
        return wrongAt(uri.text, begin, "a key is missing", "write options as KEY=VALUE, joined by '&'");
    }
    if (equals == std::string::npos || equals >= end) {
        return wrongAt(uri.text, end, "'=' is missing", "write options as KEY=VALUE, joined by '&'");
    }
    if (equals + 1 == end) {
        return wrongAt(uri.text, end, "a value is missing", "write options as KEY=VALUE, joined by '&'");
    }
    std::string key = uri.text.substr(begin, equals - begin);
    if (uri.option(key)) {
        return wrongAt(uri.text, begin, fmt::format("'{}' is given twice", key), "give each key only once");
    }
    uri.options.emplace_back(std::move(key), uri.text.substr(equals + 1, end - equals - 1));
    return {};
}

Result<void> readOptions(DeviceUri& uri, std::size_t begin) {
    for (;;) {
        const std::size_t separator = uri.text.find('&', begin);
        const std::size_t end = std::min(separator, uri.text.size());
        if (Result<void> option = readOption(uri, begin, end); !option) {
            return option;
        }
        if (separator == std::string::npos) {
            return {};
        }
        begin = separator + 1;
    }
}

} // namespace

std::optional<std::string> DeviceUri::option(const std::string& key) const {
    for (const auto& [name, value] : options) {
        if (name == key) {
            return value;
        }
    }
    return std::nullopt;
}

std::optional<std::string> DeviceUri::takeOption(const std::string& key) {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&key](const auto& option) { return option.first == key; });
    if (found == options.end()) {
        return std::nullopt;
    }
    std::string value = std::move(found->second);
    options.erase(found);
    return value;
}

Result<DeviceUri> parseDeviceUri(const std::string& text) {
    DeviceUri uri;
    uri.text = text;
    std::size_t place = 0;
    if (Result<void> characters = checkCharacters(text); !characters) {
        return failure(characters.error());
    }
    if (Result<void> scheme = readScheme(uri, place); !scheme) {
        return failure(scheme.error());
    }
    // A file may have a question mark in its name; a replay has no options.
    const std::size_t question = uri.scheme == "replay" ? std::string::npos : text.find('?', place);
    uri.address = text.substr(place, std::min(question, text.size()) - place);
    if (uri.address.empty()) {
        return wrongAt(text, place, "the address is missing", "write it like sim:htm or tcp:HOST:PORT");
    }
    if (question != std::string::npos) {
        if (Result<void> options = readOptions(uri, question + 1); !options) {
            return failure(options.error());
        }
    }
    return uri;
}

std::string fileOfOption(const std::string& value) {
    return QByteArray::fromPercentEncoding(QByteArray::fromStdString(value)).toStdString();
}

Result<std::string> withDescription(const std::string& address, const std::string& path) {
    Result<DeviceUri> uri = parseDeviceUri(address);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme == "sim" || uri->scheme == "replay") {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("device '{}' has a built-in description and does not use a file", address),
                       "give the port of the device first, e.g. tcp:HOST:PORT");
    }
    (void)uri->takeOption("a2l");
    std::string file;
    for (const char letter : path) {
        file += letter == '&' ? "%26" : letter == '%' ? "%25" : std::string(1, letter);
    }
    uri->options.emplace_back("a2l", file);
    std::string text = uri->scheme + ":" + uri->address;
    for (std::size_t i = 0; i < uri->options.size(); ++i) {
        text += fmt::format("{}{}={}", i == 0 ? '?' : '&', uri->options[i].first, uri->options[i].second);
    }
    return text;
}

} // namespace halbench::devices
