#include "devices/transport/usb_pipe.h"

#include "devices/transport/port_access.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

namespace {

constexpr std::size_t RequestsInFlight = 8;
/// 8 kB hold 3 ms of the fastest stream; the device ends a request earlier by a short packet.
constexpr std::size_t RequestOctets = 8192;
constexpr unsigned SendTimeout_ms = 500;
constexpr timeval EventPatience{0, 100000};
/// Cancelled requests come back at once; one that does not is not waited for without end.
constexpr int MaxEndingRounds = 20;
constexpr const char* PluggedHint = "check the cable and that the board is on";

std::optional<BulkPair> bulkPairOf(const libusb_interface_descriptor& setting) {
    BulkPair pair{setting.bInterfaceNumber, 0, 0};
    for (int i = 0; i < setting.bNumEndpoints; ++i) {
        const libusb_endpoint_descriptor& end = setting.endpoint[i];
        if ((end.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_BULK) {
            ((end.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0 ? pair.in : pair.out) = end.bEndpointAddress;
        }
    }
    const bool isPair = setting.bInterfaceClass == LIBUSB_CLASS_VENDOR_SPEC && pair.in != 0 && pair.out != 0;
    return isPair ? std::optional(pair) : std::nullopt;
}

} // namespace

UsbPort::Pipe::~Pipe() {
    m_isEnding = true;
    if (m_thread.joinable()) {
        libusb_interrupt_event_handler(m_context);
        m_thread.join();
    }
    for (Request& request : m_requests) {
        libusb_free_transfer(request.transfer);
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

Result<void> UsbPort::Pipe::claim(const PortListing& port) {
    libusb_config_descriptor* config = nullptr;
    std::optional<BulkPair> ends;
    if (libusb_get_active_config_descriptor(libusb_get_device(m_handle), &config) == 0) {
        for (int i = 0; i < config->bNumInterfaces && !ends; ++i) {
            ends = config->interface[i].num_altsetting > 0 ? bulkPairOf(config->interface[i].altsetting[0])
                                                           : std::nullopt;
        }
        libusb_free_config_descriptor(config);
    }
    if (!ends) {
        return failure(
            ErrorCode::DeviceLost,
            fmt::format("{} has no pair of bulk endpoints: it is no board of this kind", m_description),
            "see 'halbench devices' for what can be connected");
    }
    m_ends = *ends;
    if (libusb_kernel_driver_active(m_handle, m_ends.interface) == 1) {
        m_hasDetached = libusb_detach_kernel_driver(m_handle, m_ends.interface) == 0;
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
        m_inbox->fail(unplugged());
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
    int endingRounds = 0;
    while (!m_isEnding || (isAnyWaiting() && endingRounds < MaxEndingRounds)) {
        if (m_isEnding && endingRounds++ == 0) {
            cancelAll();
        }
        timeval patience = EventPatience;
        libusb_handle_events_timeout_completed(m_context, &patience, nullptr);
        restartAfterHalt();
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
        m_isHalted = true;
        break;
    case LIBUSB_TRANSFER_CANCELLED:
        break;
    case LIBUSB_TRANSFER_ERROR: // half of the time an unplugged device shows so, else as NO_DEVICE
    case LIBUSB_TRANSFER_NO_DEVICE:
    case LIBUSB_TRANSFER_OVERFLOW:
        m_inbox->fail(unplugged());
        break;
    }
}

/// A halted endpoint forgets what it had: the other side of the stream has to begin anew (3.4).
void UsbPort::Pipe::restartAfterHalt() {
    if (!m_isHalted || m_isEnding) {
        return;
    }
    m_isHalted = false;
    m_inbox->fail({ErrorCode::DeviceLost, fmt::format("{}: the board halted its endpoint", m_description),
                   "connect again"});
}

Result<void> UsbPort::Pipe::write(std::span<const std::uint8_t> octets) {
    std::vector<std::uint8_t> copy(octets.begin(), octets.end()); // the library wants to be able to write
    int sent = 0;
    const int code = libusb_bulk_transfer(m_handle, m_ends.out, copy.data(), static_cast<int>(copy.size()),
                                          &sent, SendTimeout_ms);
    if (code == 0 && static_cast<std::size_t>(sent) == octets.size()) {
        return {};
    }
    if (code == LIBUSB_ERROR_TIMEOUT) {
        return failure(ErrorCode::DeviceLost,
                       fmt::format("{}: the board takes no more commands", m_description), PluggedHint);
    }
    return failure(unplugged());
}

} // namespace halbench::devices
