#include "tests/conformance/ports/mock_usb.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/hidraw.h>
#include <linux/input.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace halbench::devices {

namespace {

/// Usage page FF00, one input and one output report of 64 octets.
const Octets ReportDescriptor{0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75,
                              0x08, 0x95, 0x40, 0x09, 0x02, 0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0};

std::string hexOf(const Octets& octets) {
    std::string text;
    for (const std::uint8_t octet : octets) {
        text += fmt::format("{:02x}", octet);
    }
    return text;
}

std::vector<std::string> description(const std::string& usb, int number, const std::string& serial) {
    const std::string name = usb.substr(usb.rfind('/') + 1);
    const std::string interface = fmt::format("{}/{}:1.0", usb, name);
    const std::string hid = fmt::format("{}/0003:1209:0001.{:04}", interface, number);
    return {fmt::format("P: {0}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: busnum=1\\n\nA: devnum={1}\\n\n"
                        "A: idVendor=1209\\n\nA: idProduct=0001\\n\nA: manufacturer=Halbench\\n\n"
                        "A: product=HID board\\n\nA: serial={2}\\n\n\n",
                        usb, 100 + number, serial),
            fmt::format("P: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nE: DRIVER=usbhid\n"
                        "A: bInterfaceClass=03\\n\nA: bInterfaceNumber=00\\n\n\n",
                        interface),
            fmt::format(
                "P: {}\nE: SUBSYSTEM=hid\nE: HID_ID=0003:00001209:00000001\nE: HID_NAME=Halbench HID board\n"
                "E: HID_UNIQ={}\nH: report_descriptor={}\n"
                "\n",
                hid, serial, hexOf(ReportDescriptor)),
            fmt::format("P: {0}/hidraw/hidraw{1}\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw{1}\n"
                        "E: MAJOR=240\nE: MINOR={1}\nA: dev=240:{1}\n\n",
                        hid, number)};
}

} // namespace

MockHidBoard::MockHidBoard(const MockMachine& machine, int number, const std::string& serial)
    : MockNode(machine, fmt::format("/dev/hidraw{}", number)), m_machine(&machine) {
    GError* error = nullptr;
    for (const std::string& text : description(fmt::format("/devices/usb2/2-{}", number), number, serial)) {
        m_places.push_back("/sys" + text.substr(3, text.find('\n') - 3));
        EXPECT_TRUE(umockdev_testbed_add_from_string(machine.testbed(), text.c_str(), &error))
            << (error != nullptr ? error->message : "");
    }
}

MockHidBoard::~MockHidBoard() {
    unplug();
}

bool MockHidBoard::onIoctl(UMockdevIoctlClient* client) {
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData* const arg = umockdev_ioctl_client_get_arg(client);
    const auto answer = [&](const void* data, std::size_t size) {
        UMockdevIoctlData* const place = umockdev_ioctl_data_resolve(arg, 0, size, nullptr);
        std::memcpy(place->data, data, size);
        umockdev_ioctl_client_complete(client, 0, 0);
        umockdev_ioctl_data_unref(place);
    };
    const int size = static_cast<int>(ReportDescriptor.size());
    if (request == HIDIOCGRDESCSIZE) {
        answer(&size, sizeof size);
    } else if (request == HIDIOCGRDESC) {
        hidraw_report_descriptor descriptor{};
        descriptor.size = static_cast<__u32>(size);
        std::copy(ReportDescriptor.begin(), ReportDescriptor.end(), descriptor.value);
        answer(&descriptor, sizeof descriptor);
    } else if (request == HIDIOCGRAWINFO) {
        const hidraw_devinfo info{BUS_USB, 0x1209, 0x0001};
        answer(&info, sizeof info);
    } else {
        umockdev_ioctl_client_complete(client, -1, ENOTTY);
    }
    return true;
}

bool MockHidBoard::onRead(UMockdevIoctlClient* client) {
    const std::lock_guard lock(m_mutex);
    if (m_isGone || m_toHost.empty()) {
        umockdev_ioctl_client_complete(client, -1, m_isGone ? EIO : EAGAIN);
        return true;
    }
    UMockdevIoctlData* const place = umockdev_ioctl_client_get_arg(client);
    Octets& report = m_toHost.front();
    const std::size_t count = std::min(report.size(), static_cast<std::size_t>(place->data_len));
    std::copy_n(report.begin(), count, place->data);
    m_toHost.pop_front();
    std::uint8_t token = 0;
    (void)!::read(slave().number(), &token, 1); // one queued report less for poll()
    umockdev_ioctl_client_complete(client, static_cast<glong>(count), 0);
    return true;
}

bool MockHidBoard::onWrite(UMockdevIoctlClient* client) {
    const std::lock_guard lock(m_mutex);
    if (m_isGone) {
        umockdev_ioctl_client_complete(client, -1, EIO);
        return true;
    }
    if (m_isStalled) {
        m_held.push_back(static_cast<UMockdevIoctlClient*>(g_object_ref(client)));
        return true;
    }
    UMockdevIoctlData* const place = umockdev_ioctl_client_get_arg(client);
    m_fromHost.emplace_back(place->data, place->data + place->data_len);
    m_changed.notify_all();
    umockdev_ioctl_client_complete(client, place->data_len, 0);
    return true;
}

void MockHidBoard::deliver(const Octets& report) {
    const std::lock_guard lock(m_mutex);
    if (m_isGone) {
        return;
    }
    // A terminal that is full of them takes no more: the report is lost, as in a device that nobody reads.
    const std::uint8_t token = 1;
    if (::write(master().number(), &token, 1) == 1) {
        m_toHost.push_back(report);
    }
}

std::vector<Octets> MockHidBoard::taken(std::size_t count) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, std::chrono::seconds(2), [&] { return m_fromHost.size() >= count; });
    return std::exchange(m_fromHost, {});
}

std::vector<Octets> MockHidBoard::takenWithin(double time_s) {
    std::unique_lock lock(m_mutex);
    m_changed.wait_for(lock, std::chrono::duration<double>(time_s), [&] { return !m_fromHost.empty(); });
    return std::exchange(m_fromHost, {});
}

void MockHidBoard::release(int error) {
    for (UMockdevIoctlClient* const client : std::exchange(m_held, {})) {
        umockdev_ioctl_client_complete(client, -1, error);
        g_object_unref(client);
    }
}

void MockHidBoard::setStalled(bool isStalled) {
    const std::lock_guard lock(m_mutex);
    m_isStalled = isStalled;
    if (!isStalled) {
        release(ETIMEDOUT);
    }
}

void MockHidBoard::unplug() {
    {
        const std::lock_guard lock(m_mutex);
        if (m_isGone) {
            return;
        }
        release(EIO);
        m_isGone = true;
        hangUp();
    }
    for (auto place = m_places.rbegin(); place != m_places.rend(); ++place) {
        umockdev_testbed_uevent(m_machine->testbed(), place->c_str(), "remove");
        umockdev_testbed_remove_device(m_machine->testbed(), place->c_str());
    }
}

} // namespace halbench::devices
