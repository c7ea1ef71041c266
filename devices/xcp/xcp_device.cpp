#include "devices/xcp/xcp_device.h"

#include "devices/interruption.h"
#include "devices/xcp/board_opener.h"
#include "devices/xcp/xcp_device_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

constexpr double Rounding_s = 1e-9;
/// Longest uninterrupted wait: how late a signal (Ctrl-C) may be noticed.
constexpr double MaxPump_s = 0.05;

XcpDeviceOptions withMessages(XcpDeviceOptions options) {
    if (!options.onMessage) {
        options.onMessage = [](const std::string&) {};
    }
    return options;
}

} // namespace

XcpDevice::XcpDevice(std::unique_ptr<Transport> transport, XcpDeviceOptions options)
    : m_options(withMessages(std::move(options))), m_link(std::move(transport)), m_master(m_link),
      m_clock(*this), m_values(m_master, m_board),
      m_writer(m_master, m_link, m_board,
               {&m_options.identity, m_options.useVendorBrackets, m_options.onMessage}),
      m_safety(m_master, m_link, m_board, m_writer, {m_options.watchdog_s, m_options.onMessage}),
      m_stream(m_master, m_link, m_board, m_options.onMessage) {
    m_link.setOrders(m_options.orders);
    installHandlers();
}

XcpDevice::~XcpDevice() {
    // A board left armed by a program that ends is stopped; whatever else was changed is the caller's to
    // restore.
    m_safety.leave();
    stopStream();
    m_master.disconnect();
    m_link.transport().close();
}

void XcpDevice::installHandlers() {
    LinkHandlers handlers;
    handlers.onData = [this](Octets packet) { m_stream.feed(packet); };
    handlers.onEvent = [this](std::uint8_t code, Octets) { onEvent(code); };
    handlers.onText = m_options.onMessage;
    m_link.setHandlers(std::move(handlers));
}

void XcpDevice::onEvent(std::uint8_t code) {
    if (code == static_cast<std::uint8_t>(Event::User)) {
        m_safety.noteChange();
    }
    if (code == static_cast<std::uint8_t>(Event::DaqOverload)) {
        m_options.onMessage("the board could not send all samples in time");
    }
}

Result<void> XcpDevice::open() {
    m_opened_s = now_s();
    if (Result<void> opened = BoardOpener(m_master, m_link, m_options).open(m_board, m_ability); !opened) {
        return opened;
    }
    if (m_options.measuresClock && m_ability) {
        m_clocks.begin(*m_ability);
    }
    if (Result<void> known = m_safety.refreshState(); !known) {
        return known;
    }
    m_link.noteOpened();
    m_isOpen = true;
    return {};
}

DeviceState XcpDevice::state() const {
    DeviceState state = m_safety.state();
    state.isConnected = m_isOpen && !m_link.lost();
    return state;
}

Result<void> XcpDevice::startStream(const StreamRequest& request, BlockSink sink) {
    stopStream();
    if (!m_ability) {
        return failure(ErrorCode::DeviceRefused, "this device cannot stream signals",
                       "read single values instead");
    }
    return m_stream.start(*m_ability, request, std::move(sink));
}

void XcpDevice::stopStream() noexcept {
    if (!m_stream.isRunning()) {
        return;
    }
    m_stream.stop();
    if (m_options.measuresClock) {
        reportLink();
    }
}

Result<void> XcpDevice::waitFor(double duration_s) {
    const double end_s = now_s() + std::max(duration_s, 0.0);
    Result<void> result;
    do {
        result = checkWhileWaiting();
        const double left_s = end_s - now_s();
        if (!result || left_s <= Rounding_s) {
            break;
        }
        const Result<bool> pumped =
            m_link.pumpOnce(std::min({left_s, m_safety.nextStatus_s() - now_s(), MaxPump_s}));
        if (!pumped) {
            result = failure(pumped.error());
        } else if (m_stream.isBlockDue()) {
            m_stream.deliverBlocks();
        }
    } while (result);
    if (!result && m_link.lost()) {
        m_stream.finish();
    }
    m_stream.deliverBlocks();
    return result;
}

Result<void> XcpDevice::checkWhileWaiting() {
    if (m_options.interruptSignal != nullptr) {
        const int signal = m_options.interruptSignal->load();
        if (signal != 0) {
            return failure(codeOfSignal(signal), "ended by " + signalName(signal), "");
        }
    }
    if (m_link.lost()) {
        return failure(*m_link.lost());
    }
    if (m_safety.isStatusDue(now_s())) {
        if (Result<void> fed = m_safety.feedWatchdog(); !fed) {
            return fed;
        }
    }
    if (Result<void> runs = m_safety.checkStop(); !runs) {
        return runs;
    }
    if (m_stream.isRunning() && m_clocks.isDue(now_s())) {
        if (Result<void> compared = m_clocks.compare(m_master, m_link); !compared) {
            return compared;
        }
    }
    return m_stream.checkHeartbeat();
}

void XcpDevice::reportLink() const {
    const LinkStatistics link = statistics();
    std::string text =
        fmt::format("link: {} packets, {} lost, {} damaged, {} commands repeated, round trip "
                    "{:.2f} ms, at worst {:.2f} ms",
                    link.packetsReceived, link.packetsLost, link.packetsDamaged, link.commandsRepeated,
                    1e3 * link.roundTripMedian_s, 1e3 * link.roundTripWorst_s);
    if (link.clockDrift) {
        text += fmt::format(", the device clock is fast by {:.1f} +- {:.1f} ppm", link.clockDrift->drift_ppm,
                            link.clockDrift->uncertainty_ppm);
    }
    m_options.onMessage(text);
}

LinkStatistics XcpDevice::statistics() const {
    const TransportStatistics wire = m_link.transport().statistics();
    LinkStatistics statistics;
    statistics.packetsReceived = wire.packetsReceived;
    statistics.packetsSent = wire.packetsSent;
    statistics.packetsLost = wire.packetsLost;
    statistics.packetsLate = wire.packetsLate;
    // A sample that is not whole because a packet was lost was not damaged.
    statistics.packetsDamaged =
        wire.packetsDamaged + m_stream.dropped() - std::min(m_stream.incomplete(), wire.packetsLost);
    statistics.commandsRepeated = m_link.repeatedCommands();
    statistics.roundTripMedian_s = m_link.roundTripMedian_s();
    statistics.roundTripWorst_s = m_link.roundTripWorst_s();
    statistics.clockDrift = m_clocks.drift();
    return statistics;
}

Result<Recording> XcpDevice::readCapture() {
    return m_capture.read(*this, m_board, m_master);
}

} // namespace halbench::devices::xcp
