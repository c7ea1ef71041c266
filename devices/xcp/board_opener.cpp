#include "devices/xcp/board_opener.h"

#include "devices/xcp/description_cache.h"
#include "devices/xcp/page_transaction.h"
#include "devices/xcp/value_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace halbench::devices::xcp {

namespace {

constexpr double MinTimeout_s = 0.1;
constexpr double MaxTimeout_s = 0.5;
constexpr std::size_t MaxModelName = 32;

/// A board's name is also a file name of a profile: only plain words are looked up.
bool isModelName(const std::string& name) {
    return !name.empty() && name.size() <= MaxModelName && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

/// Boards fill a text of fixed length with zeros or spaces.
std::string withoutFill(const std::string& text) {
    const std::size_t end = text.find_last_not_of(std::string_view("\0 ", 2));
    return text.substr(0, end == std::string::npos ? 0 : end + 1);
}

/// A line that carries something, only not this protocol, is not a silent one.
Error withWhatWasHeard(Error error, const Transport& transport, bool isLost) {
    const TransportStatistics heard = transport.statistics();
    const bool isBoard = isLost && heard.packetsReceived > 0; // it spoke, and went
    if (error.code == ErrorCode::DeviceLost && heard.octetsReceived > 0 && !isBoard) {
        return {ErrorCode::Protocol,
                fmt::format("{} sends data ({} bytes), but not in this protocol", transport.description(),
                            heard.octetsReceived),
                "check device and address; on a serial line also baud rate and framing"};
    }
    return error;
}

/// The board's mistake, not the user's. One that ends in the middle is told apart from nonsense.
Error descriptionError(const std::string& text, const Error& error) {
    const std::size_t end = text.rfind("PROJECT"); // a whole one ends with "/end PROJECT"
    const bool isWhole = end != std::string::npos && text.find_last_of('/') + 5 == end;
    if (isWhole || text.find("/begin") == std::string::npos) {
        return {ErrorCode::Protocol, error.message, error.hint};
    }
    return {ErrorCode::Protocol, fmt::format("the device's description ends after {} bytes", text.size()),
            "connect again; if the error remains, update the firmware"};
}

} // namespace

Result<void> BoardOpener::open(BoardDescription& board, std::optional<DaqAbility>& ability) {
    for (const auto step : {&BoardOpener::connect, &BoardOpener::readIdentity}) {
        if (Result<void> done = (this->*step)(); !done) {
            return done;
        }
    }
    Result<A2lDescription> description = readDescription();
    if (!description) {
        return failure(description.error());
    }
    Result<std::optional<DaqAbility>> told = m_master->daqAbility();
    if (!told) {
        return failure(told.error());
    }
    ability = *std::move(told);
    board = BoardDescription(*std::move(description), ability);
    if (Result<void> found = findModelProfile(); !found) {
        return found;
    }
    if (Result<void> read = readDefaults(board); !read) {
        return read;
    }
    if (m_options->profile) {
        applyProfile(*m_options->profile, board.catalogue());
    }
    return {};
}

Result<void> BoardOpener::connect() {
    if (Result<void> opened = m_link->transport().open(); !opened) {
        return opened;
    }
    const Transport& transport = m_link->transport();
    if (Result<void> connected = m_master->connect(transport.connectPatience_s()); !connected) {
        return failure(withWhatWasHeard(connected.error(), transport, m_link->lost().has_value()));
    }
    return {};
}

Result<void> BoardOpener::readIdentity() {
    const Result<StatusResponse> status = m_master->status();
    if (!status) {
        return failure(status.error());
    }
    if ((status->protection & 0x01) != 0) {
        m_options->onMessage("the board's parameters are locked");
    }
    DeviceInfo& identity = m_options->identity;
    struct Field {
        IdType type;
        std::string* text;
    };
    identity.firmware.clear();
    for (const Field field : {Field{IdType::Name, &identity.model}, Field{IdType::Text, &identity.id},
                              Field{IdType::Epk, &identity.firmware}}) {
        if (!field.text->empty()) {
            continue;
        }
        Result<std::string> text = m_master->identity(field.type);
        if (!text) {
            return failure(text.error());
        }
        *field.text = *std::move(text);
    }
    identity.firmware = withoutFill(identity.firmware);
    if (identity.transport.empty()) {
        identity.transport = m_link->transport().description();
    }
    return {};
}

/// What the user gave, else the board's own text, or a copy of it that an earlier connection kept under the
/// same name and EPK (3.7).
Result<A2lDescription> BoardOpener::givenOrUploaded() {
    if (m_options->description.empty()) {
        return cachedOrUploaded();
    }
    return parseA2l(m_options->description);
}

Result<A2lDescription> BoardOpener::cachedOrUploaded() {
    const DescriptionCache cache(m_options->cacheFolder);
    DescriptionKey key{m_options->identity.model, m_options->identity.firmware, 0};
    bool isCached = false;
    const Result<std::string> text = m_master->description([&](std::size_t octets) {
        key.octets = octets;
        std::optional<std::string> known = cache.find(key);
        isCached = known.has_value();
        return known;
    });
    if (!text) {
        return failure(text.error());
    }
    Result<A2lDescription> description = parseA2l(*text);
    if (!description) {
        return failure(descriptionError(*text, description.error()));
    }
    if (!m_options->cacheFolder.empty()) {
        m_options->onMessage(isCached
                                 ? fmt::format("description of '{}' taken from the cache", key.name)
                                 : fmt::format("description read from the device, {} bytes", text->size()));
    }
    if (!isCached) {
        if (const std::optional<std::string> before = cache.epkBefore(key)) {
            m_options->onMessage(
                fmt::format("the firmware of '{}' changed from '{}' to '{}'; the description was read again",
                            key.name, *before, key.epk));
        }
        if (const Result<bool> kept = cache.store(key, *text); !kept) {
            m_options->onMessage("the description was not cached: " + kept.error().message);
        }
    }
    return description;
}

/// A board that does not tell its EPK may keep it where its description says.
Result<void> BoardOpener::findFirmware(const A2lDescription& description) {
    if (!m_options->identity.firmware.empty() || description.epk.empty() || !description.epkAddress) {
        return {};
    }
    const Result<Packet> octets = m_master->read({*description.epkAddress, 0}, description.epk.size());
    if (!octets && octets.error().code != ErrorCode::DeviceRefused) {
        return failure(octets.error());
    }
    if (!octets) {
        m_options->onMessage(
            "the device reports neither its firmware nor the identification in its description: it is "
            "unknown whether they match");
        return {};
    }
    for (const std::uint8_t octet : *octets) {
        const bool isPrintable = octet >= 0x20 && octet < 0x7F;
        m_options->identity.firmware += isPrintable ? static_cast<char>(octet) : '?';
    }
    return readLongerFirmware(*description.epkAddress);
}

/// The board's text may go on behind what the description has of it: "1.2.3_beta" is not "1.2.3". A text ends
/// with a zero or a fill; what else lies there is not part of a name.
Result<void> BoardOpener::readLongerFirmware(std::uint32_t address) {
    constexpr std::size_t Longest = 64;
    std::string& firmware = m_options->identity.firmware;
    const auto goesOn = [](std::uint8_t octet) {
        return std::isalnum(octet) != 0 ||
               std::string_view("_-+.").find(static_cast<char>(octet)) != std::string::npos;
    };
    while (firmware.size() < Longest) {
        const auto next = static_cast<std::uint32_t>(address + firmware.size());
        const Result<Packet> octet = m_master->read({next, 0}, 1);
        if (!octet && octet.error().code != ErrorCode::DeviceRefused) {
            return failure(octet.error());
        }
        if (!octet || octet->empty() || !goesOn(octet->front())) {
            return {};
        }
        firmware += static_cast<char>(octet->front());
    }
    return {};
}

/// Names lead to addresses: those of another firmware may lead anywhere, so that nothing is written by them.
Result<void> BoardOpener::compareFirmware(const A2lDescription& description) {
    if (Result<void> found = findFirmware(description); !found) {
        return found;
    }
    const std::string& firmware = m_options->identity.firmware;
    const std::string described = withoutFill(description.epk);
    if (!described.empty() && !firmware.empty() && described != firmware) {
        m_options->identity.otherFirmware = described;
        m_options->onMessage(
            fmt::format("firmware '{}' does not match the description of '{}': writing is blocked; use "
                        "the description of this firmware, or update the firmware completely",
                        firmware, described));
    }
    return {};
}

Result<A2lDescription> BoardOpener::readDescription() {
    Result<A2lDescription> description = givenOrUploaded();
    if (!description) {
        return description;
    }
    if (Result<void> compared = compareFirmware(*description); !compared) {
        return failure(compared.error());
    }
    for (const std::string& warning : description->warnings) {
        m_options->onMessage(warning);
    }
    if (description->answerTimeout_s) {
        m_link->setAnswerTimeout(std::clamp(*description->answerTimeout_s, MinTimeout_s, MaxTimeout_s));
    }
    if (m_options->identity.firmware.empty()) {
        m_options->identity.firmware = description->epk;
    }
    return description;
}

Result<void> BoardOpener::findModelProfile() {
    if (m_options->profile || !isModelName(m_options->identity.model)) {
        return {};
    }
    Result<std::optional<Profile>> profile = findProfile(m_options->identity.model);
    if (!profile) {
        return failure(profile.error());
    }
    m_options->profile = *std::move(profile);
    return {};
}

/// Reads and writes go to the page that the control loop runs on. What lies on a page that takes no writes
/// can only be read; a board that does not tell its page is taken at its description's word.
Result<void> BoardOpener::choosePages(BoardDescription& board) {
    for (const A2lSegment& segment : board.a2l().segments) {
        if (segment.hasTwoWritablePages()) {
            if (Result<void> done = readRunningPage(*m_master, segment); !done) {
                return done;
            }
            continue;
        }
        if (segment.pages.empty()) {
            continue;
        }
        const Result<std::uint8_t> running = m_master->page(PageAccess::ControlLoop, segment.number);
        if (!running && running.error().code != ErrorCode::DeviceRefused) {
            return failure(running.error());
        }
        const Result<void> chosen =
            running ? m_master->setPage(PageAccess::Master, segment.number, *running) : Result<void>();
        if (!chosen && chosen.error().code != ErrorCode::DeviceRefused) {
            return chosen;
        }
        const auto canTake = [&](const A2lPage& page) {
            return page.isWritable && (!running || page.number == *running);
        };
        if (std::none_of(segment.pages.begin(), segment.pages.end(), canTake)) {
            board.makeReadOnly(segment);
            m_options->onMessage(fmt::format(
                "the parameters of '{}' are read-only: the active page of the device cannot be written",
                segment.name));
        }
    }
    return {};
}

/// Without a profile a parameter's default is the value the board had when it was opened.
Result<void> BoardOpener::readDefaults(BoardDescription& board) {
    if (Result<void> chosen = choosePages(board); !chosen) {
        return chosen;
    }
    std::vector<std::string> names;
    for (const ParameterSpec& spec : board.catalogue().parameters) {
        names.push_back(spec.name);
    }
    const Result<std::vector<double>> values = ValueReader(*m_master, board).readParameters(names);
    if (!values && values.error().code == ErrorCode::DeviceRefused) {
        return readWhatCanBeRead(board, names);
    }
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        board.catalogue().parameters[i].defaultValue = (*values)[i];
    }
    return {};
}

/// A description may name what the board keeps to itself: the rest is of use all the same.
Result<void> BoardOpener::readWhatCanBeRead(BoardDescription& board, const std::vector<std::string>& names) {
    std::vector<ParameterSpec> readable;
    for (const std::string& name : names) {
        const Result<std::vector<double>> value =
            ValueReader(*m_master, board).readParameters(std::span(&name, 1));
        if (!value && value.error().code != ErrorCode::DeviceRefused) {
            return failure(value.error());
        }
        if (!value) {
            m_options->onMessage(fmt::format("parameter '{}' was skipped: {}", name, value.error().message));
            continue;
        }
        readable.push_back(*board.catalogue().findParameter(name));
        readable.back().defaultValue = value->front();
    }
    board.catalogue().parameters = std::move(readable);
    return {};
}

} // namespace halbench::devices::xcp
