#include "tests/conformance/ports/mock_serial.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

#include <cstring>

namespace halbench::devices {

namespace {

std::vector<std::string> usbDescription(const std::string& name) {
    const std::string usb = "/devices/usb3/3-1";
    return {fmt::format("P: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: busnum=3\\n\nA: devnum=7\\n\n"
                        "A: idVendor=1209\\n\nA: idProduct=0002\\n\nA: manufacturer=Halbench\\n\n"
                        "A: product=Serial board\\n\nA: serial=HB-5\\n\n\n",
                        usb),
            fmt::format(
                "P: {}/3-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nL: driver=../../../../bus/usb/"
                "drivers/cdc_acm\nA: bInterfaceClass=02\\n\nA: bInterfaceSubClass=02\\n\n"
                "A: bInterfaceNumber=00\\n\n\n",
                usb),
            fmt::format("P: {0}/3-1:1.0/tty/{1}\n"
                        "E: SUBSYSTEM=tty\nE: DEVNAME=/dev/{1}\nE: MAJOR=166\nE: MINOR=0\n"
                        "E: DEVLINKS=/dev/serial/by-path/pci-0-usb-0:1 "
                        "/dev/serial/by-id/usb-Halbench_Serial_board_HB-5-if00\nA: dev=166:0\n\n",
                        usb, name)};
}

std::vector<std::string> uartDescription(const std::string& name, const std::string& type) {
    const std::string uart = "/devices/platform/serial8250";
    return {fmt::format("P: {}\nE: SUBSYSTEM=platform\n\n", uart),
            fmt::format("P: {0}/tty/{1}\nE: SUBSYSTEM=tty\nE: DEVNAME=/dev/{1}\nE: MAJOR=4\nE: MINOR=64\n"
                        "A: dev=4:64\nA: type={2}\\n\n\n",
                        uart, name, type)};
}

} // namespace

MockSerialPort::MockSerialPort(const MockMachine& machine, const std::string& name, const std::string& type)
    : MockNode(machine, "/dev/" + name), m_machine(&machine) {
    GError* error = nullptr;
    for (const std::string& text : type.empty() ? usbDescription(name) : uartDescription(name, type)) {
        m_places.push_back("/sys" + text.substr(3, text.find('\n') - 3));
        EXPECT_TRUE(umockdev_testbed_add_from_string(machine.testbed(), text.c_str(), &error))
            << (error != nullptr ? error->message : "");
    }
}

MockSerialPort::~MockSerialPort() {
    for (auto place = m_places.rbegin(); place != m_places.rend(); ++place) {
        umockdev_testbed_remove_device(m_machine->testbed(), place->c_str());
    }
}

/// To the pseudo terminal itself.
bool MockSerialPort::pass(UMockdevIoctlClient* client) {
    gint cause = 0;
    const gint result = umockdev_ioctl_client_execute(client, &cause, nullptr);
    umockdev_ioctl_client_complete(client, result, cause);
    return true;
}

bool MockSerialPort::onIoctl(UMockdevIoctlClient* client) {
    const std::lock_guard lock(m_mutex);
    const gulong request = umockdev_ioctl_client_get_request(client);
    const auto argument = [&](std::size_t size) {
        return umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
    };
    UMockdevIoctlData* place = nullptr;
    if (request == TIOCGSERIAL || request == TIOCSSERIAL) {
        place = argument(sizeof(serial_struct));
        auto& settings = *reinterpret_cast<serial_struct*>(place->data);
        (request == TIOCGSERIAL ? settings.flags : m_flags) =
            request == TIOCGSERIAL ? m_flags : settings.flags;
    } else if (request == TIOCMBIS || request == TIOCMBIC) {
        place = argument(sizeof(int));
        if ((*reinterpret_cast<int*>(place->data) & TIOCM_DTR) != 0) {
            m_dtr = request == TIOCMBIS;
        }
    } else {
        return pass(client);
    }
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(place);
    return true;
}

bool MockSerialPort::isLowLatency() {
    const std::lock_guard lock(m_mutex);
    return (m_flags & ASYNC_LOW_LATENCY) != 0;
}

std::optional<bool> MockSerialPort::dtr() {
    const std::lock_guard lock(m_mutex);
    return m_dtr;
}

} // namespace halbench::devices
