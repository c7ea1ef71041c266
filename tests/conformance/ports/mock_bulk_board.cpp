#include "tests/conformance/ports/mock_usb.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace halbench::devices {

namespace {

/// Endpoints as a real controller gave them: 0x81 in, 0x02 out.
constexpr const char* Descriptors = "12010002000000400912010000010102030109022000010100803209040000"
                                    "02ff00000007058102000200070502020002 00";
constexpr std::uint8_t DirectionIn = 0x80;

std::string hexWithoutSpaces(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

/// No newline behind `dev`: umockdev 0.17 does not strip it when the device is removed.
std::string description(const std::string& place, int address, const std::string& serial) {
    return fmt::format(
        "P: {0}\nN: bus/usb/001/{1:03}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DRIVER=usb\n"
        "E: BUSNUM=001\nE: DEVNUM={1:03}\nE: DEVNAME=/dev/bus/usb/001/{1:03}\nE: MAJOR=189\n"
        "E: MINOR={1}\nA: dev=189:{1}\nA: busnum=1\\n\nA: devnum={1}\\n\nA: speed=480\\n\n"
        "A: bConfigurationValue=1\\n\nA: idVendor=1209\\n\nA: idProduct=0001\\n\n"
        "A: manufacturer=Halbench\\n\nA: product=Test board\\n\nA: serial={2}\\n\nH: descriptors={3}\n\n",
        place, address, serial, hexWithoutSpaces(Descriptors));
}

std::string interfaceDescription(const std::string& place) {
    const std::string name = place.substr(place.rfind('/') + 1);
    return fmt::format("P: {}/{}:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceClass=ff\\n\n"
                       "A: bInterfaceSubClass=00\\n\nA: bInterfaceNumber=00\\n\nA: bNumEndpoints=02\\n\n\n",
                       place, name);
}

usbdevfs_urb& urbOf(UMockdevIoctlData* request) {
    return *reinterpret_cast<usbdevfs_urb*>(request->data);
}

} // namespace

MockBulkBoard::MockBulkBoard(const MockMachine& machine, int address, const std::string& serial)
    : MockNode(machine, fmt::format("/dev/bus/usb/001/{:03}", address)), m_machine(&machine),
      m_place(fmt::format("/devices/usb1/1-{}", address)) {
    showReady();
    GError* error = nullptr;
    for (const std::string& text : {description(m_place, address, serial), interfaceDescription(m_place)}) {
        EXPECT_TRUE(umockdev_testbed_add_from_string(machine.testbed(), text.c_str(), &error))
            << (error != nullptr ? error->message : "");
    }
}

MockBulkBoard::~MockBulkBoard() {
    unplug(Departure::NoDevice);
    for (auto* list : {&m_waiting, &m_stuck, &m_done}) {
        for (const Transfer& transfer : *list) {
            umockdev_ioctl_data_unref(transfer.octets);
            umockdev_ioctl_data_unref(transfer.block);
        }
    }
}

/// usbfs shows finished requests as "writable".
void MockBulkBoard::showReady() {
    ::tcflow(slave().number(), m_done.empty() ? TCOOFF : TCOON);
}

void MockBulkBoard::finish(const Transfer& transfer, int status) {
    urbOf(transfer.block).status = status;
    m_done.push_back(transfer);
}

void MockBulkBoard::fillWaiting() {
    while (!m_waiting.empty() && !m_toHost.empty()) {
        const Transfer transfer = m_waiting.front();
        m_waiting.pop_front();
        Octets& octets = m_toHost.front();
        usbdevfs_urb& urb = urbOf(transfer.block);
        const auto count = std::min(octets.size(), static_cast<std::size_t>(urb.buffer_length));
        umockdev_ioctl_data_update(transfer.octets, 0, octets.data(), static_cast<gint>(count));
        urb.actual_length = static_cast<int>(count);
        octets.erase(octets.begin(), octets.begin() + static_cast<std::ptrdiff_t>(count));
        if (octets.empty()) {
            m_toHost.pop_front();
        }
        finish(transfer, 0);
    }
    showReady();
}

void MockBulkBoard::submit(UMockdevIoctlClient* client) {
    if (m_isGone) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return;
    }
    Transfer transfer;
    transfer.block =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(usbdevfs_urb), nullptr);
    usbdevfs_urb& urb = urbOf(transfer.block);
    transfer.octets = umockdev_ioctl_data_resolve(transfer.block, offsetof(usbdevfs_urb, buffer),
                                                  static_cast<gsize>(urb.buffer_length), nullptr);
    if ((urb.endpoint & DirectionIn) != 0) {
        m_waiting.push_back(transfer);
    } else if (m_isStalled) {
        m_stuck.push_back(transfer);
    } else {
        m_fromHost.insert(m_fromHost.end(), transfer.octets->data, transfer.octets->data + urb.buffer_length);
        urb.actual_length = urb.buffer_length;
        finish(transfer, 0);
        m_changed.notify_all();
    }
    umockdev_ioctl_client_complete(client, 0, 0);
    fillWaiting();
}

void MockBulkBoard::reap(UMockdevIoctlClient* client) {
    if (m_done.empty()) {
        umockdev_ioctl_client_complete(client, -1, m_isGone ? ENODEV : EAGAIN);
        return;
    }
    const Transfer transfer = m_done.front();
    m_done.pop_front();
    UMockdevIoctlData* const place =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(void*), nullptr);
    umockdev_ioctl_data_set_ptr(place, 0, transfer.block);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(place);
    umockdev_ioctl_data_unref(transfer.octets);
    umockdev_ioctl_data_unref(transfer.block);
    showReady();
}

void MockBulkBoard::discard(UMockdevIoctlClient* client) {
    const auto address = *reinterpret_cast<gulong*>(umockdev_ioctl_client_get_arg(client)->data);
    for (auto* list : {&m_waiting, &m_stuck}) {
        const auto found = std::find_if(list->begin(), list->end(), [&](const Transfer& transfer) {
            return transfer.block->client_addr == address;
        });
        if (found != list->end()) {
            finish(*found, -ENOENT);
            list->erase(found);
            umockdev_ioctl_client_complete(client, 0, 0);
            showReady();
            return;
        }
    }
    umockdev_ioctl_client_complete(client, -1, EINVAL);
}

bool MockBulkBoard::onIoctl(UMockdevIoctlClient* client) {
    const std::lock_guard lock(m_mutex);
    switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_GET_CAPABILITIES: {
        const std::uint32_t abilities =
            USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT | USBDEVFS_CAP_ZERO_PACKET;
        UMockdevIoctlData* const place =
            umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof abilities, nullptr);
        std::memcpy(place->data, &abilities, sizeof abilities);
        umockdev_ioctl_client_complete(client, 0, 0);
        umockdev_ioctl_data_unref(place);
        return true;
    }
    case USBDEVFS_CLAIMINTERFACE:
        umockdev_ioctl_client_complete(client, m_isClaimed ? -1 : 0, m_isClaimed ? EBUSY : 0);
        m_isClaimed = true;
        return true;
    case USBDEVFS_RELEASEINTERFACE:
        m_isClaimed = false;
        umockdev_ioctl_client_complete(client, 0, 0);
        return true;
    case USBDEVFS_CLEAR_HALT:
        umockdev_ioctl_client_complete(client, 0, 0);
        return true;
    case USBDEVFS_GETDRIVER: // no kernel driver holds the interface
        umockdev_ioctl_client_complete(client, -1, ENODATA);
        return true;
    case USBDEVFS_SUBMITURB:
        submit(client);
        return true;
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
        reap(client);
        return true;
    case USBDEVFS_DISCARDURB:
        discard(client);
        return true;
    default:
        umockdev_ioctl_client_complete(client, -1, ENOTTY);
        return true;
    }
}

void MockBulkBoard::deliver(const Octets& octets) {
    const std::lock_guard lock(m_mutex);
    m_toHost.push_back(octets);
    fillWaiting();
}

Octets MockBulkBoard::taken(std::size_t count) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, std::chrono::seconds(2), [&] { return m_fromHost.size() >= count; });
    return std::exchange(m_fromHost, {});
}

Octets MockBulkBoard::takenWithin(double time_s) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, std::chrono::duration<double>(time_s), [&] { return !m_fromHost.empty(); });
    return std::exchange(m_fromHost, {});
}

void MockBulkBoard::setStalled(bool isStalled) {
    const std::lock_guard lock(m_mutex);
    m_isStalled = isStalled;
}

void MockBulkBoard::unplug(Departure departure) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_isGone) {
            return;
        }
        m_isGone = true;
        for (auto* list : {&m_waiting, &m_stuck}) {
            for (const Transfer& transfer : *list) {
                finish(transfer, departure == Departure::NoDevice ? -ENODEV : -EPROTO);
            }
            list->clear();
        }
        showReady();
        hangUp();
    }
    const std::string place = "/sys" + m_place;
    const std::string interface = place + "/" + m_place.substr(m_place.rfind('/') + 1) + ":1.0";
    umockdev_testbed_uevent(m_machine->testbed(), place.c_str(), "remove");
    umockdev_testbed_remove_device(m_machine->testbed(), interface.c_str());
    umockdev_testbed_remove_device(m_machine->testbed(), place.c_str());
}

} // namespace halbench::devices
