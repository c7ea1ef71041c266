#include "devices/open/device_watcher.h"
#include "devices/open/open_device.h"
#include "devices/simulated/registry/simulated_models.h"
#include "devices/transport/hid_port.h"
#include "devices/transport/message_stream.h"
#include "devices/transport/usb_port.h"
#include "tests/conformance/ports/mock_usb.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace halbench::devices {
namespace {

const UsbName Name{0x1209, 0x0001, ""};

Octets counting(std::size_t count) {
    Octets octets(count);
    for (std::size_t i = 0; i < count; ++i) {
        octets[i] = static_cast<std::uint8_t>(i);
    }
    return octets;
}

Octets received(OctetInbox& inbox, std::size_t count) {
    Octets all;
    Octets part;
    while (all.size() < count && inbox.take(part, 2.0).value_or(false)) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

const PortListing* find(const std::vector<PortListing>& ports, PortKind kind) {
    for (const PortListing& port : ports) {
        if (port.kind == kind) {
            return &port;
        }
    }
    return nullptr;
}

TEST(UsbBulk, isListedWithItsNamesAndOpenedByThem) {
    const MockMachine machine;
    MockBulkBoard board(machine, 4, "HB-17");
    const std::vector<PortListing> ports = listPorts();
    const PortListing* listed = find(ports, PortKind::UsbBulk);
    ASSERT_NE(listed, nullptr);
    EXPECT_EQ(listed->uri, "usb:1209:0001:HB-17");
    EXPECT_EQ(listed->name, "Halbench Test board");
    EXPECT_EQ(listed->node, "/dev/bus/usb/001/004");
    EXPECT_EQ(listed->reason, "");
    OctetInbox inbox;
    UsbPort port(*parseUsbName(listed->uri.substr(4)));
    const auto opened = port.open(inbox);
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_TRUE(port.write(counting(1000)));
    EXPECT_EQ(board.taken(1000), counting(1000));
    board.deliver(counting(3000));
    board.deliver({1, 2});
    Octets expected = counting(3000);
    expected.insert(expected.end(), {1, 2});
    EXPECT_EQ(received(inbox, expected.size()), expected);
}

TEST(UsbBulk, wrongSerialNumberAndSeveralBoardsAreToldApart) {
    const MockMachine machine;
    MockBulkBoard one(machine, 4, "HB-17");
    OctetInbox inbox;
    UsbPort other({0x1209, 0x0001, "HB-18"});
    const auto wrong = other.open(inbox);
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.find("HB-17"), std::string::npos);
    MockBulkBoard two(machine, 5, "HB-18");
    EXPECT_TRUE(other.open(inbox));
    UsbPort any(Name);
    const auto several = any.open(inbox);
    ASSERT_FALSE(several);
    EXPECT_NE(several.error().message.find("several"), std::string::npos);
    other.close(); // before its board goes
}

TEST(Hid, isListedAndCarriesReportsBothWays) {
    const MockMachine machine;
    MockHidBoard board(machine, 3, "HB-9");
    const std::vector<PortListing> ports = listPorts();
    const PortListing* listed = find(ports, PortKind::Hid);
    ASSERT_NE(listed, nullptr);
    EXPECT_EQ(listed->uri, "hid:1209:0001:HB-9");
    EXPECT_EQ(listed->name, "Halbench HID board");
    OctetInbox inbox;
    HidPort port(Name);
    const auto opened = port.open(inbox);
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_TRUE(port.write(counting(100)));
    const std::vector<Octets> reports = board.taken(2);
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[0].size(), 65U) << "report number and 64 octets";
    EXPECT_EQ(reports[0][1], 63);
    EXPECT_EQ(reports[1][1], 37);
    for (const HidReport& report : reportsFor(counting(200))) {
        board.deliver({report.begin(), report.end()});
    }
    EXPECT_EQ(received(inbox, 200), counting(200));
}

/// By events of the system; the slow look around only helps a machine that is too busy between event and
/// removal.
TEST(HotPlug, theWatcherTellsOfABoardThatComesAndGoes) {
    const MockMachine machine;
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<DeviceListing> known;
    const auto waitFor = [&](std::size_t boards) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, std::chrono::seconds(60),
                                [&] { return known.size() == simulatedModels().size() + boards; });
    };
    const DeviceWatcher watcher(
        [&](const std::vector<DeviceListing>& list) {
            const std::lock_guard lock(mutex);
            known = list;
            changed.notify_all();
        },
        listDevices, 2.0);
    ASSERT_TRUE(waitFor(0));
    for (int address = 4; address < 7; ++address) {
        MockBulkBoard board(machine, address, "HB-17");
        ASSERT_TRUE(waitFor(1)) << "plugged in as " << address;
        board.unplug(MockBulkBoard::Departure::NoDevice);
        ASSERT_TRUE(waitFor(0)) << "unplugged from " << address;
    }
}

TEST(EmptyMachine, hasNoPortsAndSaysSo) {
    const MockMachine machine;
    EXPECT_TRUE(listPorts().empty());
    const auto device = openDevice("usb:1209:0001", {});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(device.error().hint.find("halbench devices"), std::string::npos);
}

} // namespace
} // namespace halbench::devices
