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
constexpr const char* FirstPair = "0705810200020007050202000200";
constexpr const char* SecondPair = "0705830200020007050402000200";
constexpr std::uint8_t DirectionIn = 0x80;

std::string descriptors(const BulkTraits& traits) {
    const auto littleEndian = [](const std::string& hex) { return hex.substr(2) + hex.substr(0, 2); };
    return fmt::format("1201000200000040{}{}0001010203010902{:02x}00010100803209040000{:02x}{}000000{}{}",
                       littleEndian(traits.vendor), littleEndian(traits.product),
                       traits.hasSecondPair ? 46 : 32, traits.hasSecondPair ? 4 : 2, traits.interfaceClass,
                       FirstPair, traits.hasSecondPair ? SecondPair : "");
}

/// No newline behind `dev`: umockdev 0.17 does not strip it when the device is removed.
std::string description(const std::string& place, int address, const std::string& serial,
                        const BulkTraits& traits) {
    return fmt::format(
        "P: {0}\nN: bus/usb/001/{1:03}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DRIVER=usb\n"
        "E: BUSNUM=001\nE: DEVNUM={1:03}\nE: DEVNAME=/dev/bus/usb/001/{1:03}\nE: MAJOR=189\n"
        "E: MINOR={1}\nA: dev=189:{1}\nA: busnum=1\\n\nA: devnum={1}\\n\nA: speed=480\\n\n"
        "A: bConfigurationValue=1\\n\nA: idVendor={4}\\n\nA: idProduct={5}\\n\n"
        "A: manufacturer=Halbench\\n\nA: product=Test board\\n\nA: serial={2}\\n\nH: descriptors={3}\n\n",
        place, address, serial, descriptors(traits), traits.vendor, traits.product);
}

std::string interfaceDescription(const std::string& place, const BulkTraits& traits) {
    const std::string name = place.substr(place.rfind('/') + 1);
    const std::string driver =
        traits.driver.empty() ? "" : fmt::format("L: driver=../../../../bus/usb/drivers/{}\n", traits.driver);
    return fmt::format(
        "P: {}/{}:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n{}A: bInterfaceClass={}\\n\n"
        "A: bInterfaceSubClass={}\\n\nA: bInterfaceNumber=00\\n\nA: bNumEndpoints=02\\n\n\n",
        place, name, driver, traits.interfaceClass, traits.interfaceClass == "02" ? "02" : "00");
}

usbdevfs_urb& urbOf(UMockdevIoctlData* request) {
    return *reinterpret_cast<usbdevfs_urb*>(request->data);
}

} // namespace

MockBulkBoard::MockBulkBoard(const MockMachine& machine, int address, const std::string& serial,
                             BulkTraits traits)
    : MockNode(machine, fmt::format("/dev/bus/usb/001/{:03}", address)), m_machine(&machine),
      m_traits(std::move(traits)), m_place(fmt::format("/devices/usb1/1-{}", address)),
      m_driver(m_traits.driver) {
    showReady();
    GError* error = nullptr;
    for (const std::string& text :
         {description(m_place, address, serial, m_traits), interfaceDescription(m_place, m_traits)}) {
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
    if (m_isGone || m_traits.submitError != 0) {
        umockdev_ioctl_client_complete(client, -1, m_isGone ? ENODEV : m_traits.submitError);
        return;
    }
    Transfer transfer;
    transfer.block =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(usbdevfs_urb), nullptr);
    usbdevfs_urb& urb = urbOf(transfer.block);
    transfer.octets = umockdev_ioctl_data_resolve(transfer.block, offsetof(usbdevfs_urb, buffer),
                                                  static_cast<gsize>(urb.buffer_length), nullptr);
    noteUse(urb.endpoint);
    if (isHalted(urb.endpoint)) {
        finish(transfer, -EPIPE);
    } else if ((urb.endpoint & DirectionIn) != 0) {
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
            if (m_traits.answersCancel) {
                finish(*found, -ENOENT);
                list->erase(found);
            }
            umockdev_ioctl_client_complete(client, 0, 0);
            showReady();
            return;
        }
    }
    umockdev_ioctl_client_complete(client, -1, EINVAL);
}

void MockBulkBoard::tellDriver(UMockdevIoctlClient* client) {
    if (m_driver.empty()) {
        umockdev_ioctl_client_complete(client, -1, ENODATA);
        return;
    }
    UMockdevIoctlData* const place = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                                 sizeof(usbdevfs_getdriver), nullptr);
    auto& answer = *reinterpret_cast<usbdevfs_getdriver*>(place->data);
    answer.driver[m_driver.copy(answer.driver, sizeof answer.driver - 1)] = '\0';
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(place);
}

/// Detaches the driver from the interface, or lets it have it again.
void MockBulkBoard::changeDriver(UMockdevIoctlClient* client) {
    UMockdevIoctlData* const place = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                                 sizeof(usbdevfs_ioctl), nullptr);
    const auto request = static_cast<unsigned>(reinterpret_cast<usbdevfs_ioctl*>(place->data)->ioctl_code);
    umockdev_ioctl_data_unref(place);
    const bool isDetach = request == USBDEVFS_DISCONNECT;
    if (isDetach && !m_traits.isDetachable) {
        umockdev_ioctl_client_complete(client, -1, EBUSY);
        return;
    }
    m_driver = isDetach ? std::string() : m_traits.driver;
    umockdev_ioctl_client_complete(client, isDetach ? 0 : 1, 0);
}

void MockBulkBoard::clearHalt(UMockdevIoctlClient* client) {
    UMockdevIoctlData* const place =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(unsigned), nullptr);
    const auto end = static_cast<std::uint8_t>(*reinterpret_cast<unsigned*>(place->data));
    umockdev_ioctl_data_unref(place);
    m_halted.erase(std::remove(m_halted.begin(), m_halted.end(), end), m_halted.end());
    umockdev_ioctl_client_complete(client, 0, 0);
}

bool MockBulkBoard::isHalted(std::uint8_t end) const {
    return std::find(m_halted.begin(), m_halted.end(), end) != m_halted.end();
}

void MockBulkBoard::noteUse(std::uint8_t end) {
    if (std::find(m_usedEnds.begin(), m_usedEnds.end(), end) == m_usedEnds.end()) {
        m_usedEnds.push_back(end);
    }
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
    case USBDEVFS_CLAIMINTERFACE: {
        const bool isFree = !m_isClaimed && m_driver.empty();
        umockdev_ioctl_client_complete(client, isFree ? 0 : -1, isFree ? 0 : EBUSY);
        m_isClaimed = m_isClaimed || isFree;
        return true;
    }
    case USBDEVFS_RELEASEINTERFACE:
        m_isClaimed = false;
        umockdev_ioctl_client_complete(client, 0, 0);
        return true;
    case USBDEVFS_CLEAR_HALT:
        clearHalt(client);
        return true;
    case USBDEVFS_GETDRIVER:
        tellDriver(client);
        return true;
    case USBDEVFS_IOCTL:
        changeDriver(client);
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

void MockBulkBoard::halt() {
    const std::lock_guard lock(m_mutex);
    m_halted = {0x81, 0x02};
    for (const Transfer& transfer : m_waiting) {
        finish(transfer, -EPIPE);
    }
    m_waiting.clear();
    showReady();
}

std::string MockBulkBoard::driver() {
    const std::lock_guard lock(m_mutex);
    return m_driver;
}

bool MockBulkBoard::isClaimed() {
    const std::lock_guard lock(m_mutex);
    return m_isClaimed;
}

std::vector<std::uint8_t> MockBulkBoard::usedEnds() {
    const std::lock_guard lock(m_mutex);
    return m_usedEnds;
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
