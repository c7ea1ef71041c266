#include "devices/transport/codec_framing.h"

#include <gtest/gtest.h>

#include <vector>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

const SxiProfile Plain{SxiHeader::LenCtrByte, SxiChecksum::Word, false};

std::vector<Octets> found(CodecFraming& framing, const Octets& line) {
    std::vector<Octets> packets;
    for (const std::uint8_t octet : line) {
        const auto packet = framing.receive(octet);
        if (!packet.empty()) {
            packets.emplace_back(packet.begin(), packet.end());
        }
    }
    return packets;
}

// resources/help/protocol.md 3.3.3, less SYNC
TEST(CodecFraming, readsAndWritesTheVectorsWithoutFraming) {
    CodecFraming framing(Plain);
    EXPECT_EQ(found(framing, {0x02, 0x00, 0xFF, 0x00, 0x01, 0x01, 0x01, 0x01, 0xFD, 0x00, 0xFE, 0x01}),
              (std::vector<Octets>{{0xFF, 0x00}, {0xFD}}));
    Octets line;
    framing.append(line, 0, Octets{0xFF, 0x00});
    EXPECT_EQ(line, (Octets{0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}));
    framing.append(line, 1, Octets(256, 0x01));
    framing.append(line, 1, Octets{});
    EXPECT_EQ(line.size(), 6U) << "no LEN can say that";
}

TEST(CodecFraming, whatASilenceCutsOffIsForgotten) {
    CodecFraming framing(Plain);
    EXPECT_TRUE(found(framing, {0xC8, 0x00, 0xF4}).empty()) << "200 octets are announced";
    framing.noteSilence();
    EXPECT_EQ(found(framing, {0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}), (std::vector<Octets>{{0xFF, 0x00}}));
}

} // namespace
} // namespace halbench::devices
