#include "devices/firmware/xcp/hb_sxi.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

Octets onTheLine(const Octets& packet, std::uint16_t counter) {
    hb_sxi_sender sender{};
    hb_sxi_send(&sender, packet.data(), static_cast<std::uint16_t>(packet.size()), counter);
    Octets line;
    std::uint8_t octet;
    while (hb_sxi_next(&sender, &octet)) {
        line.push_back(octet);
    }
    return line;
}

std::vector<Octets> decoded(const Octets& line) {
    hb_sxi_receiver receiver;
    hb_sxi_receiver_init(&receiver);
    std::vector<Octets> packets;
    for (const std::uint8_t octet : line) {
        if (const std::uint16_t length = hb_sxi_receive(&receiver, octet)) {
            const std::uint8_t* packet = hb_sxi_packet(&receiver);
            packets.emplace_back(packet, packet + length);
        }
    }
    return packets;
}

TEST(Sxi, writesTheVectorsOfTheProtocolPage) {
    // resources/help/protocol.md 3.3.3
    EXPECT_EQ(onTheLine({0xFF, 0x00}, 0), (Octets{0x9A, 0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}));
    EXPECT_EQ(onTheLine({0xFD}, 1), (Octets{0x9A, 0x01, 0x01, 0xFD, 0x00, 0xFE, 0x01}));
}

TEST(Sxi, readsBackWhatItWrote) {
    std::uint32_t state = 1;
    for (int i = 0; i < 2000; ++i) {
        Octets packet(1 + static_cast<std::size_t>(i) % 255);
        for (std::uint8_t& octet : packet) {
            state = state * 1664525U + 1013904223U;
            octet = static_cast<std::uint8_t>(0x98 + (state >> 29)); // mostly SYNC and ESC
        }
        ASSERT_EQ(decoded(onTheLine(packet, static_cast<std::uint16_t>(i))), std::vector<Octets>{packet});
    }
}

TEST(Sxi, losesAtMostTheDamagedFrame) {
    const Octets packet{0xF4, 4, 0, 0, 0, 0, 1, 0};
    const Octets line = onTheLine(packet, 5);
    for (std::size_t at = 0; at < line.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            Octets damaged = line;
            damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1 << bit));
            damaged.insert(damaged.end(), line.begin(), line.end());
            const std::vector<Octets> packets = decoded(damaged);
            ASSERT_FALSE(packets.empty());
            EXPECT_EQ(packets.back(), packet);
        }
    }
}

TEST(Sxi, ignoresNoiseAndLengthZero) {
    EXPECT_TRUE(decoded({0x01, 0x02, 0x03}).empty());
    EXPECT_TRUE(decoded({0x9A, 0x00, 0x00, 0x00, 0x00}).empty());
    EXPECT_TRUE(decoded({0x9A, 0x02, 0x00, 0x9B, 0x05, 0xFF, 0x00, 0x01, 0x01}).empty()); // bad escape
}

} // namespace
} // namespace halbench::devices::firmware
