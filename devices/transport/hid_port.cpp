#include "devices/transport/hid_port.h"

#include "devices/transport/descriptor.h"
#include "devices/transport/hid_writer.h"
#include "devices/transport/port_access.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <hidapi.h>
#include <sys/file.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <thread>

namespace halbench::devices {

namespace {

/// How late the thread may notice that it shall end.
constexpr int ReadPatience_ms = 100;
constexpr const char* PluggedHint = "check the cable and that the device is on";

} // namespace

std::vector<HidReport> reportsFor(std::span<const std::uint8_t> octets) {
    std::vector<HidReport> reports;
    while (!octets.empty()) {
        const std::size_t count = std::min(octets.size(), HidReportOctets - 1);
        HidReport& report = reports.emplace_back(HidReport{});
        report[0] = static_cast<std::uint8_t>(count);
        std::copy_n(octets.begin(), count, report.begin() + 1);
        octets = octets.subspan(count);
    }
    return reports;
}

std::span<const std::uint8_t> octetsOf(std::span<const std::uint8_t> report) {
    if (report.empty() || report[0] >= report.size()) {
        return {};
    }
    return report.subspan(1, report[0]);
}

/// An open HID device and the thread that reads it.
class HidPort::Reports {
public:
    Reports(std::string description, OctetInbox& inbox)
        : m_description(std::move(description)), m_inbox(&inbox) {}
    ~Reports() {
        m_isEnding = true;
        if (m_thread.joinable()) {
            m_thread.join();
        }
    }
    Reports(const Reports&) = delete;
    Reports& operator=(const Reports&) = delete;

    Result<void> open(const PortListing& port);
    Result<void> write(std::span<const std::uint8_t> octets) { return m_output->write(octets); }

private:
    void run();
    Error unplugged() const;

    std::string m_description;
    OctetInbox* m_inbox;
    Descriptor m_lock; ///< keeps other programs of ours away; the system lets everybody in
    HidHandle m_input; ///< one each way: the library's handle is not for two threads
    std::unique_ptr<HidWriter> m_output;
    std::atomic<bool> m_isEnding{false};
    std::thread m_thread;
};

Error HidPort::Reports::unplugged() const {
    return {ErrorCode::DeviceLost, fmt::format("{}: the device was unplugged or switched off", m_description),
            PluggedHint};
}

Result<void> HidPort::Reports::open(const PortListing& port) {
    if (const std::optional<PortTrouble> trouble = troubleOf(port.node)) {
        return failure(portError(m_description, *trouble));
    }
    m_lock = Descriptor(::open(port.node.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (m_lock.isOpen() && ::flock(m_lock.number(), LOCK_EX | LOCK_NB) != 0) {
        return failure(portError(m_description, busyTrouble(port.node)));
    }
    m_input.reset(hid_open_path(port.node.c_str()));
    HidHandle output(hid_open_path(port.node.c_str()));
    if (!m_lock.isOpen() || !m_input || !output) {
        const int cause = errno;
        return failure(portError(m_description,
                                 cause == EACCES ? permissionTrouble(port.node)
                                                 : PortTrouble{fmt::format("{} cannot be opened: {}",
                                                                           port.node, std::strerror(cause)),
                                                               PluggedHint}));
    }
    m_output = std::make_unique<HidWriter>(std::move(output), m_description);
    m_thread = std::thread([this] { run(); });
    return {};
}

void HidPort::Reports::run() {
    HidReport report{};
    while (!m_isEnding) {
        const int count = hid_read_timeout(m_input.get(), report.data(), report.size(), ReadPatience_ms);
        if (count < 0) {
            m_inbox->fail(unplugged());
            return;
        }
        const auto octets = octetsOf({report.data(), static_cast<std::size_t>(count)});
        if (!octets.empty()) {
            m_inbox->put(octets);
        }
    }
}

HidPort::HidPort(UsbName name) : m_name(std::move(name)) {}

HidPort::~HidPort() = default;

Result<void> HidPort::open(OctetInbox& inbox) {
    close();
    const Result<PortListing> port = findPort(listPorts(), PortKind::Hid, m_name);
    if (!port) {
        return failure(port.error());
    }
    auto reports = std::make_unique<Reports>(description(), inbox);
    Result<void> opened = reports->open(*port);
    if (opened) {
        m_reports = std::move(reports);
    }
    return opened;
}

void HidPort::close() noexcept {
    m_reports.reset();
}

Result<void> HidPort::write(std::span<const std::uint8_t> octets) {
    if (!m_reports) {
        return failure(ErrorCode::DeviceLost, fmt::format("{} is not open", description()), "connect again");
    }
    return m_reports->write(octets);
}

} // namespace halbench::devices
