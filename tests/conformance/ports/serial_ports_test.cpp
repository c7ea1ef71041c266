#include "devices/open/port_address.h"
#include "devices/transport/port_listing.h"
#include "devices/transport/serial_port.h"
#include "tests/conformance/ports/mock_serial.h"
#include "tests/conformance/ports/unprivileged.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace halbench::devices {
namespace {

PortListing onlyPort() {
    const std::vector<PortListing> ports = listPorts();
    EXPECT_EQ(ports.size(), 1U);
    return ports.empty() ? PortListing{} : ports[0];
}

/// The machine's terminals that are its consoles.
void setConsoles(const MockMachine& machine, const std::string& names) {
    GError* error = nullptr;
    const std::string text =
        fmt::format("P: /devices/virtual/tty/console\nE: SUBSYSTEM=tty\nA: active={}\\n\n\n", names);
    EXPECT_TRUE(umockdev_testbed_add_from_string(machine.testbed(), text.c_str(), &error));
}

TEST(SerialPorts, aBoardsOwnIsListedUnderTheNameThatStays) {
    const MockMachine machine;
    const MockSerialPort board(machine, "ttyACM0");
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.kind, PortKind::Serial);
    EXPECT_EQ(listed.node, "/dev/ttyACM0");
    EXPECT_EQ(listed.uri, "serial:/dev/serial/by-id/usb-Halbench_Serial_board_HB-5-if00");
    EXPECT_EQ(listed.name, "Halbench Serial board");
    EXPECT_EQ(listed.serial, "HB-5");
    EXPECT_EQ(listed.vendor, 0x1209);
    EXPECT_EQ(listed.product, 0x0002);
    EXPECT_EQ(listed.reason, "");
}

TEST(SerialPorts, theMachinesOwnIsListedUnlessItIsNotThere) {
    const MockMachine machine;
    const MockSerialPort uart(machine, "ttyS1", "4");
    EXPECT_EQ(onlyPort().uri, "serial:/dev/ttyS1");
    EXPECT_EQ(onlyPort().reason, "");
    const MockMachine empty;
    const MockSerialPort announced(empty, "ttyS1", "0");
    EXPECT_TRUE(listPorts().empty());
}

TEST(SerialPorts, theConsoleIsNotOfferedAsABoard) {
    const MockMachine machine;
    setConsoles(machine, "tty0 ttyS1");
    const MockSerialPort uart(machine, "ttyS1", "4");
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.reason, "it is the console of this machine");
    EXPECT_NE(listed.hint.find("use another port"), std::string::npos);
}

TEST(SerialPorts, anotherTerminalsConsoleDoesNotMatter) {
    const MockMachine machine;
    setConsoles(machine, "tty0 ttyS10");
    const MockSerialPort uart(machine, "ttyS1", "4");
    EXPECT_EQ(onlyPort().reason, "");
}

TEST(SerialPorts, aForbiddenOneSaysHowToAllowIt) {
    const MockMachine machine;
    const MockSerialPort board(machine, "ttyACM0");
    const Unprivileged user(machine, {board.node()});
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.reason, "no permission to use /dev/ttyACM0");
    EXPECT_NE(listed.hint.find("udev"), std::string::npos) << listed.hint;
    SerialPort port({"/dev/ttyACM0", 115200, true, std::nullopt});
    OctetInbox inbox;
    const auto opened = port.open(inbox);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message, "serial:/dev/ttyACM0: no permission to use /dev/ttyACM0");
}

/// What happened to the port once an address had opened it.
struct Opened {
    bool isLowLatency = false;
    std::optional<bool> dtr;
};

Opened openedBy(const std::string& uri) {
    const MockMachine machine;
    MockSerialPort board(machine, "ttyACM0");
    const auto transport = makeSerialTransport(*parseDeviceUri(uri));
    EXPECT_TRUE(transport);
    const auto opened = (*transport)->open();
    EXPECT_TRUE(opened) << opened.error().message;
    (*transport)->close();
    return {board.isLowLatency(), board.dtr()};
}

TEST(SerialPorts, latencyAndDtrAreSetAsTheAddressSays) {
    const Opened plain = openedBy("serial:/dev/ttyACM0");
    EXPECT_TRUE(plain.isLowLatency) << "a driver that collects octets for 16 ms is asked not to";
    const Opened told = openedBy("serial:/dev/ttyACM0?low_latency=off&dtr=off");
    EXPECT_FALSE(told.isLowLatency);
    EXPECT_EQ(told.dtr, std::optional(false));
    EXPECT_EQ(openedBy("serial:/dev/ttyACM0?dtr=on").dtr, std::optional(true));
}

} // namespace
} // namespace halbench::devices
