#include "devices/xcp/xcp_device.h"

#include "devices/xcp/xcp_device_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace halbench::devices {

Result<std::unique_ptr<Device>> openXcpDevice(std::unique_ptr<Transport> transport,
                                              XcpDeviceOptions options) {
    auto device = std::make_unique<xcp::XcpDevice>(std::move(transport), std::move(options));
    if (const Result<void> opened = device->open(); !opened) {
        return failure(opened.error());
    }
    return std::unique_ptr<Device>(std::move(device));
}

} // namespace halbench::devices

namespace halbench::devices::xcp {

namespace {

/// GET_DAQ_CLOCK tells 32 bits; a clock with fewer in its time stamps turns over earlier.
constexpr std::size_t ClockOctets = 4;
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

XcpDevice::XcpDevice(std::unique_ptr<Transport> transport, XcpDeviceOptions options)
    : m_options(std::move(options)), m_link(std::move(transport)), m_master(m_link), m_clock(*this) {
    m_link.setOrders(m_options.orders);
    installHandlers();
}

XcpDevice::~XcpDevice() {
    // A board left armed by a program that ends is stopped; whatever else was changed is the caller's to
    // restore.
    if (m_expectsArmed && !m_link.lost()) {
        (void)disarm();
    }
    if (m_formerWatchdog_ms && (!refreshState() || !m_state.isArmed)) {
        (void)restoreWatchdog(); // of a board that was stopped, or never armed
    }
    stopStream();
    m_master.disconnect();
    m_link.transport().close();
}

void XcpDevice::installHandlers() {
    LinkHandlers handlers;
    handlers.onData = [this](Octets packet) {
        if (m_stream) {
            feedStream(packet);
        }
    };
    handlers.onEvent = [this](std::uint8_t code, Octets) { onEvent(code); };
    handlers.onText = [this](const std::string& text) { message(text); };
    m_link.setHandlers(std::move(handlers));
}

void XcpDevice::message(const std::string& text) const {
    if (m_options.onMessage) {
        m_options.onMessage(text);
    }
}

Result<void> XcpDevice::open() {
    if (Result<void> opened = m_link.transport().open(); !opened) {
        return opened;
    }
    m_opened_s = now_s();
    const Transport& transport = m_link.transport();
    if (Result<void> connected = m_master.connect(transport.connectPatience_s()); !connected) {
        return failure(withWhatWasHeard(connected.error(), transport, m_link.lost().has_value()));
    }
    using Step = Result<void> (XcpDevice::*)();
    for (const Step step : {&XcpDevice::readIdentity, &XcpDevice::readDescription, &XcpDevice::readDefaults,
                            &XcpDevice::refreshState}) {
        if (Result<void> done = (this->*step)(); !done) {
            return done;
        }
    }
    m_link.noteOpened();
    m_state.isConnected = true;
    return {};
}

Result<void> XcpDevice::readIdentity() {
    const Result<StatusResponse> status = m_master.status();
    if (!status) {
        return failure(status.error());
    }
    if ((status->protection & 0x01) != 0) {
        message("the board's parameters are locked");
    }
    DeviceInfo& identity = m_options.identity;
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
        Result<std::string> text = m_master.identity(field.type);
        if (!text) {
            return failure(text.error());
        }
        *field.text = *std::move(text);
    }
    identity.firmware = withoutFill(identity.firmware);
    if (identity.transport.empty()) {
        identity.transport = m_link.transport().description();
    }
    return {};
}

/// What the user gave, else the board's own text, or a copy of it that an earlier connection kept under the
/// same name and EPK (3.7).
Result<A2lDescription> XcpDevice::givenOrUploaded() {
    if (m_options.description.empty()) {
        return cachedOrUploaded();
    }
    return parseA2l(m_options.description);
}

Result<A2lDescription> XcpDevice::cachedOrUploaded() {
    const DescriptionCache cache(m_options.cacheFolder);
    DescriptionKey key{m_options.identity.model, m_options.identity.firmware, 0};
    bool isCached = false;
    const Result<std::string> text = m_master.description([&](std::size_t octets) {
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
    if (!m_options.cacheFolder.empty()) {
        message(isCached ? fmt::format("description of '{}' taken from the cache", key.name)
                         : fmt::format("description read from the device, {} bytes", text->size()));
    }
    if (!isCached) {
        if (const std::optional<std::string> before = cache.epkBefore(key)) {
            message(
                fmt::format("the firmware of '{}' changed from '{}' to '{}'; the description was read again",
                            key.name, *before, key.epk));
        }
        if (const Result<bool> kept = cache.store(key, *text); !kept) {
            message("the description was not cached: " + kept.error().message);
        }
    }
    return description;
}

/// A board that does not tell its EPK may keep it where its description says.
Result<void> XcpDevice::findFirmware(const A2lDescription& description) {
    if (!m_options.identity.firmware.empty() || description.epk.empty() || !description.epkAddress) {
        return {};
    }
    const Result<Packet> octets = m_master.read({*description.epkAddress, 0}, description.epk.size());
    if (!octets && octets.error().code != ErrorCode::DeviceRefused) {
        return failure(octets.error());
    }
    if (!octets) {
        message("the device reports neither its firmware nor the identification in its description: it is "
                "unknown whether they match");
        return {};
    }
    for (const std::uint8_t octet : *octets) {
        const bool isPrintable = octet >= 0x20 && octet < 0x7F;
        m_options.identity.firmware += isPrintable ? static_cast<char>(octet) : '?';
    }
    return readLongerFirmware(*description.epkAddress);
}

/// The board's text may go on behind what the description has of it: "1.2.3_beta" is not "1.2.3". A text ends
/// with a zero or a fill; what else lies there is not part of a name.
Result<void> XcpDevice::readLongerFirmware(std::uint32_t address) {
    constexpr std::size_t Longest = 64;
    std::string& firmware = m_options.identity.firmware;
    const auto goesOn = [](std::uint8_t octet) {
        return std::isalnum(octet) != 0 ||
               std::string_view("_-+.").find(static_cast<char>(octet)) != std::string::npos;
    };
    while (firmware.size() < Longest) {
        const auto next = static_cast<std::uint32_t>(address + firmware.size());
        const Result<Packet> octet = m_master.read({next, 0}, 1);
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
Result<void> XcpDevice::compareFirmware(const A2lDescription& description) {
    if (Result<void> found = findFirmware(description); !found) {
        return found;
    }
    const std::string& firmware = m_options.identity.firmware;
    const std::string described = withoutFill(description.epk);
    if (!described.empty() && !firmware.empty() && described != firmware) {
        m_options.identity.otherFirmware = described;
        message(fmt::format("firmware '{}' does not match the description of '{}': writing is blocked; use "
                            "the description of this firmware, or update the firmware completely",
                            firmware, described));
    }
    return {};
}

Result<void> XcpDevice::readDescription() {
    Result<A2lDescription> description = givenOrUploaded();
    if (!description) {
        return failure(description.error());
    }
    if (Result<void> compared = compareFirmware(*description); !compared) {
        return compared;
    }
    for (const std::string& warning : description->warnings) {
        message(warning);
    }
    if (description->answerTimeout_s) {
        m_link.setAnswerTimeout(std::clamp(*description->answerTimeout_s, MinTimeout_s, MaxTimeout_s));
    }
    DeviceInfo& identity = m_options.identity;
    if (identity.firmware.empty()) {
        identity.firmware = description->epk;
    }
    Result<std::optional<DaqAbility>> ability = m_master.daqAbility();
    if (!ability) {
        return failure(ability.error());
    }
    m_ability = *std::move(ability);
    if (m_options.measuresClock && m_ability && m_ability->format.timestampSize == ClockOctets) {
        m_boardClock.emplace(ClockOctets, m_ability->tick_s);
    }
    m_board = BoardDescription(*std::move(description), m_ability);
    if (!m_options.profile && isModelName(identity.model)) {
        Result<std::optional<Profile>> profile = findProfile(identity.model);
        if (!profile) {
            return failure(profile.error());
        }
        m_options.profile = *std::move(profile);
    }
    return {};
}

/// Reads and writes go to the page that the control loop runs on. What lies on a page that takes no writes
/// can only be read; a board that does not tell its page is taken at its description's word.
Result<void> XcpDevice::choosePages() {
    for (const A2lSegment& segment : m_board.a2l().segments) {
        if (segment.hasTwoWritablePages()) {
            if (Result<void> done = readRunningPage(m_master, segment); !done) {
                return done;
            }
            continue;
        }
        if (segment.pages.empty()) {
            continue;
        }
        const Result<std::uint8_t> running = m_master.page(PageAccess::ControlLoop, segment.number);
        if (!running && running.error().code != ErrorCode::DeviceRefused) {
            return failure(running.error());
        }
        const Result<void> chosen =
            running ? m_master.setPage(PageAccess::Master, segment.number, *running) : Result<void>();
        if (!chosen && chosen.error().code != ErrorCode::DeviceRefused) {
            return chosen;
        }
        const auto canTake = [&](const A2lPage& page) {
            return page.isWritable && (!running || page.number == *running);
        };
        if (std::none_of(segment.pages.begin(), segment.pages.end(), canTake)) {
            m_board.makeReadOnly(segment);
            message(fmt::format(
                "the parameters of '{}' are read-only: the active page of the device cannot be written",
                segment.name));
        }
    }
    return {};
}

/// Without a profile a parameter's default is the value the board had when it was opened.
Result<void> XcpDevice::readDefaults() {
    if (Result<void> chosen = choosePages(); !chosen) {
        return chosen;
    }
    std::vector<std::string> names;
    for (const ParameterSpec& spec : m_board.catalogue().parameters) {
        names.push_back(spec.name);
    }
    const Result<std::vector<double>> values = readParameters(names);
    if (!values && values.error().code == ErrorCode::DeviceRefused) {
        return readWhatCanBeRead(names);
    }
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_board.catalogue().parameters[i].defaultValue = (*values)[i];
    }
    useProfile();
    return {};
}

/// A description may name what the board keeps to itself: the rest is of use all the same.
Result<void> XcpDevice::readWhatCanBeRead(const std::vector<std::string>& names) {
    std::vector<ParameterSpec> readable;
    for (const std::string& name : names) {
        const Result<std::vector<double>> value = readParameters(std::span(&name, 1));
        if (!value && value.error().code != ErrorCode::DeviceRefused) {
            return failure(value.error());
        }
        if (!value) {
            message(fmt::format("parameter '{}' was skipped: {}", name, value.error().message));
            continue;
        }
        readable.push_back(*m_board.catalogue().findParameter(name));
        readable.back().defaultValue = value->front();
    }
    m_board.catalogue().parameters = std::move(readable);
    useProfile();
    return {};
}

void XcpDevice::useProfile() {
    if (m_options.profile) {
        applyProfile(*m_options.profile, m_board.catalogue());
    }
}

LinkStatistics XcpDevice::statistics() const {
    const TransportStatistics wire = m_link.transport().statistics();
    LinkStatistics statistics;
    statistics.packetsReceived = wire.packetsReceived;
    statistics.packetsSent = wire.packetsSent;
    statistics.packetsLost = wire.packetsLost;
    statistics.packetsLate = wire.packetsLate;
    // A sample that is not whole because a packet was lost was not damaged.
    const std::uint64_t dropped = m_droppedSamples + (m_stream ? m_stream->dropped() : 0);
    const std::uint64_t incomplete = m_incompleteSamples + (m_stream ? m_stream->incomplete() : 0);
    statistics.packetsDamaged = wire.packetsDamaged + dropped - std::min(incomplete, wire.packetsLost);
    statistics.commandsRepeated = m_link.repeatedCommands();
    statistics.roundTripMedian_s = m_link.roundTripMedian_s();
    statistics.roundTripWorst_s = m_link.roundTripWorst_s();
    statistics.clockDrift = m_clockFit.drift();
    return statistics;
}

Result<Recording> XcpDevice::readCapture() {
    return m_capture.read(*this, m_board, m_master);
}

} // namespace halbench::devices::xcp
