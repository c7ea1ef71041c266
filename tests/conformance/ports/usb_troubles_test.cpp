#include "devices/transport/hid_port.h"
#include "devices/transport/usb_port.h"
#include "tests/conformance/ports/mock_usb.h"
#include "tests/conformance/ports/unprivileged.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cerrno>

namespace halbench::devices {
namespace {

const UsbName Name{0x1209, 0x0001, ""};
const Octets Few{1, 2, 3};

/// The error that ends the connection; empty when none comes.
std::string endOf(OctetInbox& inbox) {
    Octets octets;
    for (;;) {
        const Result<bool> taken = inbox.take(octets, 5.0);
        if (!taken) {
            return taken.error().message;
        }
        if (!*taken) {
            return {};
        }
    }
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

PortListing onlyPort() {
    const std::vector<PortListing> ports = listPorts();
    EXPECT_EQ(ports.size(), 1U);
    return ports.empty() ? PortListing{} : ports[0];
}

void expectTraffic(UsbPort& port, OctetInbox& inbox, MockBulkBoard& board) {
    ASSERT_TRUE(port.write(Few));
    EXPECT_EQ(board.taken(Few.size()), Few);
    board.deliver(Few);
    Octets octets;
    EXPECT_TRUE(inbox.take(octets, 5.0).value_or(false));
    EXPECT_EQ(octets, Few);
}

// resources/help/protocol.md 3.4: after a halt both sides of the stream begin anew, which is a new
// connection.
TEST(HaltedBoard, endsTheConnectionInItsOwnWordsAndIsOpenedAgain) {
    const MockMachine machine;
    MockBulkBoard board(machine, 4, "HB-17");
    OctetInbox inbox;
    UsbPort port(Name);
    ASSERT_TRUE(port.open(inbox));
    board.halt();
    EXPECT_EQ(endOf(inbox), "usb:1209:0001: the device halted its endpoint");
    const auto written = port.write(Few);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "usb:1209:0001: the device halted its endpoint")
        << "nobody unplugged it";
    inbox.clear();
    ASSERT_TRUE(port.open(inbox));
    expectTraffic(port, inbox, board);
    port.close(); // before its board goes
}

TEST(HeldBoard, isListedWithItsDriverAndTakenFromItWhileConnected) {
    const MockMachine machine;
    MockBulkBoard board(machine, 4, "HB-17", {"usbtest"});
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.uri, "usb:1209:0001:HB-17");
    EXPECT_EQ(listed.reason, "held by the kernel driver 'usbtest'");
    EXPECT_TRUE(has(listed.hint, "connect to usb:1209:0001:HB-17")) << listed.hint;
    EXPECT_EQ(board.driver(), "usbtest") << "looking takes nothing away";
    OctetInbox inbox;
    UsbPort port(Name);
    const auto opened = port.open(inbox);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(board.driver(), "");
    expectTraffic(port, inbox, board);
    port.close();
    EXPECT_EQ(board.driver(), "usbtest") << "the driver has it again";
    EXPECT_FALSE(board.isClaimed());
}

TEST(HeldBoard, aDriverThatDoesNotLetGoIsNamed) {
    const MockMachine machine;
    BulkTraits traits{"usbtest"};
    traits.isDetachable = false;
    MockBulkBoard board(machine, 4, "HB-17", traits);
    OctetInbox inbox;
    UsbPort port(Name);
    const auto opened = port.open(inbox);
    ASSERT_FALSE(opened);
    EXPECT_TRUE(has(opened.error().message, "the kernel driver 'usbtest' cannot be detached"))
        << opened.error().message;
    EXPECT_EQ(opened.error().hint, "unload the driver: sudo modprobe -r usbtest");
    EXPECT_EQ(board.driver(), "usbtest");
}

TEST(ClaimedBoard, isInUseInTheListAndWhenOpened) {
    const MockMachine machine;
    MockBulkBoard board(machine, 4, "HB-17", {"usbfs"});
    const PortListing listed = onlyPort();
    EXPECT_TRUE(has(listed.reason, "/dev/bus/usb/001/004 is in use by")) << listed.reason;
    OctetInbox inbox;
    UsbPort port(Name);
    const auto opened = port.open(inbox);
    ASSERT_FALSE(opened);
    EXPECT_TRUE(has(opened.error().message, "is in use by")) << opened.error().message;
}

TEST(DriverlessAdapter, isASerialPortWithoutADriverAndNoBoard) {
    const MockMachine machine;
    BulkTraits ftdi;
    ftdi.vendor = "0403";
    ftdi.product = "6001";
    MockBulkBoard board(machine, 4, "A7", ftdi);
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.kind, PortKind::Serial);
    EXPECT_EQ(listed.uri, "") << "nothing of ours can open it";
    EXPECT_EQ(listed.serial, "A7");
    EXPECT_EQ(listed.reason, "its serial port has no driver");
    EXPECT_EQ(listed.hint, "load it: sudo modprobe ftdi_sio");
    OctetInbox inbox;
    UsbPort port({0x0403, 0x6001, ""});
    const auto opened = port.open(inbox);
    ASSERT_FALSE(opened);
    EXPECT_TRUE(has(opened.error().message, "it is a serial port")) << opened.error().message;
}

TEST(DriverlessAdapter, withItsDriverOnlyItsSerialPortIsListed) {
    const MockMachine machine;
    BulkTraits ftdi{"ftdi_sio"};
    ftdi.vendor = "0403";
    MockBulkBoard board(machine, 4, "A7", ftdi);
    EXPECT_TRUE(listPorts().empty()) << "the tty, when there is one, stands for it";
}

TEST(DriverlessBoard, ofTheCommunicationsClassIsTold) {
    const MockMachine machine;
    BulkTraits cdc;
    cdc.interfaceClass = "02";
    MockBulkBoard board(machine, 4, "HB-17", cdc);
    const PortListing listed = onlyPort();
    EXPECT_EQ(listed.name, "Halbench Test board");
    EXPECT_EQ(listed.reason, "its serial port has no driver");
    EXPECT_EQ(listed.hint, "load it: sudo modprobe cdc_acm");
}

TEST(SeveralPairs, theFirstOneIsUsed) {
    const MockMachine machine;
    BulkTraits traits;
    traits.hasSecondPair = true;
    MockBulkBoard board(machine, 4, "HB-17", traits);
    EXPECT_EQ(onlyPort().ends, (BulkPair{0, 0x81, 0x02}));
    OctetInbox inbox;
    UsbPort port(Name);
    ASSERT_TRUE(port.open(inbox));
    expectTraffic(port, inbox, board);
    port.close();
    const std::vector<std::uint8_t> ends = board.usedEnds();
    EXPECT_EQ(ends.size(), 2U);
    EXPECT_EQ(std::count(ends.begin(), ends.end(), 0x81) + std::count(ends.begin(), ends.end(), 0x02), 2);
}

TEST(RefusedTransfers, areToldForWhatTheyAre) {
    const MockMachine machine;
    BulkTraits traits;
    traits.submitError = ENOMEM;
    MockBulkBoard board(machine, 4, "HB-17", traits);
    OctetInbox inbox;
    UsbPort port(Name);
    ASSERT_TRUE(port.open(inbox));
    EXPECT_EQ(endOf(inbox), "usb:1209:0001: the system has no memory left for USB transfers");
    const auto written = port.write(Few);
    ASSERT_FALSE(written);
    EXPECT_TRUE(has(written.error().hint, "usbfs_memory_mb")) << written.error().message;
    port.close();
}

// The library goes through its transfers when the device is closed: none may have been given back by then.
// Freed memory is overwritten meanwhile, so that it does not pass by luck.
TEST(CancelledTransfers, thatNeverComeBackDoNotHoldUpTheEnd) {
    const MockMachine machine;
    BulkTraits traits;
    traits.answersCancel = false;
    ::mallopt(M_PERTURB, 0x5A);
    MockBulkBoard board(machine, 4, "HB-17", traits);
    OctetInbox inbox;
    UsbPort port(Name);
    ASSERT_TRUE(port.open(inbox));
    expectTraffic(port, inbox, board);
    port.close();
    ::mallopt(M_PERTURB, 0);
    EXPECT_FALSE(board.isClaimed());
    EXPECT_TRUE(port.open(inbox)) << "the device is free again";
    port.close();
}

TEST(ForbiddenPort, isListedAndRefusedWithTheRemedy) {
    const MockMachine machine;
    MockBulkBoard bulk(machine, 4, "HB-17");
    MockHidBoard hid(machine, 3, "HB-9");
    const Unprivileged user(machine, {bulk.node(), hid.node()});
    const std::vector<PortListing> ports = listPorts();
    ASSERT_EQ(ports.size(), 2U);
    for (const PortListing& port : ports) {
        EXPECT_EQ(port.reason, "no permission to use " + port.node);
        EXPECT_TRUE(has(port.hint, "udev")) << port.hint;
    }
    OctetInbox inbox;
    UsbPort usbPort(Name);
    const auto usb = usbPort.open(inbox);
    ASSERT_FALSE(usb);
    EXPECT_EQ(usb.error().message, "usb:1209:0001: no permission to use " + bulk.node());
    EXPECT_FALSE(usb.error().hint.empty());
    HidPort hidPort(Name);
    const auto report = hidPort.open(inbox);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().message, "hid:1209:0001: no permission to use " + hid.node());
}

} // namespace
} // namespace halbench::devices
