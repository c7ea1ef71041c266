#include "devices/transport/usb_pipe.h"

#include "devices/transport/port_access.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace halbench::devices {

namespace {

constexpr std::size_t RequestsInFlight = 8;
/// 8 kB hold 3 ms of the fastest stream; the device ends a request earlier by a short packet.
constexpr std::size_t RequestOctets = 8192;
constexpr unsigned SendTimeout_ms = 500;
constexpr timeval EventPatience{0, 100000};
/// Cancelled requests come back at once; one that does not is not waited for without end.
constexpr std::chrono::seconds EndingPatience{2};
constexpr const char* PluggedHint = "check the cable and that the device is on";

} // namespace

UsbPort::Pipe::~Pipe() {
    m_isEnding = true;
    if (m_thread.joinable()) {
        libusb_interrupt_event_handler(m_context);
        m_thread.join();
    }
    if (m_isClaimed) {
        libusb_release_interface(m_handle, m_ends.interface);
    }
    if (m_hasDetached) {
        libusb_attach_kernel_driver(m_handle, m_ends.interface);
    }
    if (m_handle != nullptr) {
        libusb_close(m_handle);
    }
    // Only now: a request that did not come back was the library's until the handle was closed, which takes
    // it from the system's list and the library's.
    for (Request& request : m_requests) {
        libusb_free_transfer(request.transfer);
    }
    if (m_context != nullptr) {
        libusb_exit(m_context);
    }
}

Error UsbPort::Pipe::failed(const char* what, int code) const {
    return {ErrorCode::DeviceLost, fmt::format("{}: {}: {}", m_description, what, libusb_strerror(code)),
            PluggedHint};
}

Error UsbPort::Pipe::unplugged() const {
    return {ErrorCode::DeviceLost, fmt::format("{}: the device was unplugged or switched off", m_description),
            PluggedHint};
}

/// A halted endpoint forgets what it had: the other side of the stream has to begin anew, which opening it
/// again does (resources/help/protocol.md 3.4).
Error UsbPort::Pipe::halted() const {
    return {ErrorCode::DeviceLost, fmt::format("{}: the device halted its endpoint", m_description),
            "connect again"};
}

/// Why the system did not take a request.
Error UsbPort::Pipe::refused(int code) const {
    switch (code) {
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_IO: // as an unplugged device shows itself half of the time
        return unplugged();
    case LIBUSB_ERROR_PIPE:
        return halted();
    case LIBUSB_ERROR_TIMEOUT:
        return {ErrorCode::DeviceLost, fmt::format("{}: the device accepts no more commands", m_description),
                PluggedHint};
    case LIBUSB_ERROR_NO_MEM:
        return {ErrorCode::DeviceLost,
                fmt::format("{}: the system has no memory left for USB transfers", m_description),
                "close other programs that use USB, or raise /sys/module/usbcore/parameters/usbfs_memory_mb"};
    default:
        return failed("the transfer failed", code);
    }
}

Result<void> UsbPort::Pipe::open(const PortListing& port) {
    if (const int code = libusb_init(&m_context); code != 0) {
        m_context = nullptr;
        return failure(failed("USB cannot be used", code));
    }
    using Step = Result<void> (Pipe::*)(const PortListing&);
    for (const Step step : {&Pipe::openHandle, &Pipe::claim}) {
        if (Result<void> done = (this->*step)(port); !done) {
            return done;
        }
    }
    return startRequests();
}

Result<void> UsbPort::Pipe::openHandle(const PortListing& port) {
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(m_context, &list);
    int code = LIBUSB_ERROR_NO_DEVICE;
    for (ssize_t i = 0; i < count && m_handle == nullptr; ++i) { // one device may be listed twice
        if (libusb_get_bus_number(list[i]) == port.bus &&
            libusb_get_device_address(list[i]) == port.address) {
            code = libusb_open(list[i], &m_handle);
        }
    }
    if (count >= 0) {
        libusb_free_device_list(list, 1);
    }
    if (m_handle != nullptr) {
        return {};
    }
    return failure(code == LIBUSB_ERROR_ACCESS ? portError(m_description, permissionTrouble(port.node))
                                               : failed("cannot be opened", code));
}

/// The driver gets the interface back when the connection ends.
Result<void> UsbPort::Pipe::takeFromDriver(const PortListing& port) {
    if (libusb_kernel_driver_active(m_handle, m_ends.interface) != 1) {
        return {};
    }
    const int code = libusb_detach_kernel_driver(m_handle, m_ends.interface);
    if (code != 0 && code != LIBUSB_ERROR_NOT_FOUND) { // let go of meanwhile
        return failure(ErrorCode::DeviceLost,
                       fmt::format("{}: the kernel driver '{}' cannot be detached: {}", m_description,
                                   port.driver, libusb_strerror(code)),
                       fmt::format("unload the driver: sudo modprobe -r {}", port.driver));
    }
    m_hasDetached = code == 0;
    return {};
}

Result<void> UsbPort::Pipe::claim(const PortListing& port) {
    m_ends = port.ends;
    if (Result<void> taken = takeFromDriver(port); !taken) {
        return taken;
    }
    const int code = libusb_claim_interface(m_handle, m_ends.interface);
    if (code == LIBUSB_ERROR_BUSY) {
        return failure(portError(m_description, busyTrouble(port.node)));
    }
    if (code != 0) {
        return failure(failed("cannot be claimed", code));
    }
    m_isClaimed = true;
    // What an earlier program left behind: both ends begin anew (3.4).
    (void)libusb_clear_halt(m_handle, m_ends.in);
    (void)libusb_clear_halt(m_handle, m_ends.out);
    return {};
}

Result<void> UsbPort::Pipe::startRequests() {
    m_requests.resize(RequestsInFlight);
    for (Request& request : m_requests) {
        request.pipe = this;
        request.octets.resize(RequestOctets);
        request.transfer = libusb_alloc_transfer(0);
        libusb_fill_bulk_transfer(
            request.transfer, m_handle, m_ends.in, request.octets.data(),
            static_cast<int>(request.octets.size()),
            [](libusb_transfer* transfer) {
                auto* done = static_cast<Request*>(transfer->user_data);
                done->pipe->onCompleted(*done);
            },
            &request, 0);
    }
    m_thread = std::thread([this] { run(); });
    return {};
}

void UsbPort::Pipe::submit(Request& request) {
    if (m_isEnding) {
        return;
    }
    const int code = libusb_submit_transfer(request.transfer);
    request.isWaiting = code == 0;
    if (code != 0) {
        m_inbox->fail(refused(code));
    }
}

bool UsbPort::Pipe::isAnyWaiting() const {
    return std::any_of(m_requests.begin(), m_requests.end(),
                       [](const Request& request) { return request.isWaiting; });
}

void UsbPort::Pipe::cancelAll() {
    for (Request& request : m_requests) {
        if (request.isWaiting) {
            (void)libusb_cancel_transfer(request.transfer);
        }
    }
}

/// All requests are made, answered and taken back in this thread.
void UsbPort::Pipe::run() {
    for (Request& request : m_requests) {
        submit(request);
    }
    std::optional<std::chrono::steady_clock::time_point> end;
    while (!m_isEnding || (isAnyWaiting() && (!end || std::chrono::steady_clock::now() < *end))) {
        if (m_isEnding && !end) {
            end = std::chrono::steady_clock::now() + EndingPatience;
            cancelAll();
        }
        timeval patience = EventPatience;
        libusb_handle_events_timeout_completed(m_context, &patience, nullptr);
    }
}

void UsbPort::Pipe::onCompleted(Request& request) {
    request.isWaiting = false;
    const auto length = static_cast<std::size_t>(std::max(request.transfer->actual_length, 0));
    if (length > 0) {
        m_inbox->put({request.octets.data(), length});
    }
    switch (request.transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
    case LIBUSB_TRANSFER_TIMED_OUT:
        submit(request);
        break;
    case LIBUSB_TRANSFER_STALL:
        m_inbox->fail(halted());
        break;
    case LIBUSB_TRANSFER_CANCELLED:
        break;
    case LIBUSB_TRANSFER_ERROR: // half of the time an unplugged device shows so, else as NO_DEVICE
    case LIBUSB_TRANSFER_NO_DEVICE:
        m_inbox->fail(unplugged());
        break;
    case LIBUSB_TRANSFER_OVERFLOW:
        m_inbox->fail(failed("the device sent more than requested", LIBUSB_ERROR_OVERFLOW));
        break;
    }
}

Result<void> UsbPort::Pipe::write(std::span<const std::uint8_t> octets) {
    std::vector<std::uint8_t> copy(octets.begin(), octets.end()); // the library wants to be able to write
    int sent = 0;
    const int code = libusb_bulk_transfer(m_handle, m_ends.out, copy.data(), static_cast<int>(copy.size()),
                                          &sent, SendTimeout_ms);
    if (code == 0 && static_cast<std::size_t>(sent) == octets.size()) {
        return {};
    }
    return failure(refused(code == 0 ? LIBUSB_ERROR_TIMEOUT : code));
}

} // namespace halbench::devices
