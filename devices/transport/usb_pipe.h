#pragma once

#include "devices/transport/usb_descriptors.h"
#include "devices/transport/usb_port.h"

#include <libusb.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace halbench::devices {

/// An open USB device and the thread that takes what it sends.
class UsbPort::Pipe {
public:
    Pipe(std::string description, OctetInbox& inbox)
        : m_description(std::move(description)), m_inbox(&inbox) {}
    ~Pipe();
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    Result<void> open(const PortListing& port);
    Result<void> write(std::span<const std::uint8_t> octets);

private:
    /// One request for octets; lives from open() to the end.
    struct Request {
        Pipe* pipe = nullptr;
        libusb_transfer* transfer = nullptr;
        std::vector<std::uint8_t> octets;
        bool isWaiting = false;
    };

    Result<void> openHandle(const PortListing& port);
    Result<void> claim(const PortListing& port);
    Result<void> takeFromDriver(const PortListing& port);
    Result<void> startRequests();
    void run();
    void submit(Request& request);
    void cancelAll();
    bool isAnyWaiting() const;
    void onCompleted(Request& request);
    Error failed(const char* what, int code) const;
    Error unplugged() const;
    Error halted() const;
    Error refused(int code) const;

    std::string m_description;
    OctetInbox* m_inbox;
    libusb_context* m_context = nullptr;
    libusb_device_handle* m_handle = nullptr;
    BulkPair m_ends;
    bool m_isClaimed = false;
    bool m_hasDetached = false;
    std::vector<Request> m_requests; ///< of the thread once it runs
    std::atomic<bool> m_isEnding{false};
    std::thread m_thread;
};

} // namespace halbench::devices
