#include "devices/open/port_address.h"
#include "devices/transport/message_stream.h"
#include "tests/conformance/ports/mock_usb.h"

#include <gtest/gtest.h>

#include <thread>

namespace halbench::devices {
namespace {

/// What 32 signals at 20 kHz are on the line: 133 octets a sample, in transfers of 4 kB and more, through the
/// real libusb. Three seconds of it, as fast as the emulated bus goes.
TEST(UsbBulk, carriesTheStreamOfAFastBoardWithoutLoss) {
    constexpr std::size_t Samples = 60000;
    constexpr std::size_t Transfer = 4096;
    constexpr std::size_t SampleOctets = 133;
    const MockMachine machine;
    MockBulkBoard mock(machine, 4, "HB-17");
    auto transport = makeUsbTransport(*parseDeviceUri("usb:1209:0001:HB-17"));
    ASSERT_TRUE(transport);
    ASSERT_TRUE((*transport)->open());
    std::thread board([&] {
        Octets pending;
        Octets sample(SampleOctets);
        for (std::size_t n = 0; n < Samples; ++n) {
            sample[1] = static_cast<std::uint8_t>(n);
            sample[SampleOctets - 1] = static_cast<std::uint8_t>(n >> 8);
            appendMessage(pending, static_cast<std::uint16_t>(n), sample);
            if (pending.size() >= Transfer || n + 1 == Samples) {
                mock.deliver(pending);
                pending.clear();
            }
        }
    });
    Octets packet;
    std::size_t wrong = 0;
    std::size_t received = 0;
    for (; received < Samples; ++received) {
        const auto taken = (*transport)->receive(packet, 5.0);
        if (!taken || !*taken) {
            break;
        }
        const bool isRight = packet.size() == SampleOctets &&
                             packet[1] == static_cast<std::uint8_t>(received) &&
                             packet[SampleOctets - 1] == static_cast<std::uint8_t>(received >> 8);
        wrong += isRight ? 0 : 1;
    }
    board.join();
    EXPECT_EQ(received, Samples);
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ((*transport)->statistics().packetsLost, 0U);
    (*transport)->close();
}

} // namespace
} // namespace halbench::devices
