#include "devices/transport/sxi_codec.h"
#include "tests/devices/firmware/board_fixture.h"
#include "tests/devices/firmware/sxi_unframed.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

/// What a tool without framing speaks (resources/help/protocol.md 3.6, the third of the profiles tried).
const SxiProfile Plain{SxiHeader::LenCtrByte, SxiChecksum::Word, false};

Octets fromTheBoard(const Octets& packet, std::uint16_t counter) {
    hb_sxi_sender sender{};
    plain_sxi_send(&sender, packet.data(), static_cast<std::uint16_t>(packet.size()), counter);
    Octets line;
    for (std::uint8_t octet = 0; plain_sxi_next(&sender, &octet) != 0;) {
        line.push_back(octet);
    }
    return line;
}

class UnframedSxi : public testing::Test {
protected:
    UnframedSxi() { plain_sxi_receiver_init(&m_receiver); }

    std::vector<Octets> found(const Octets& line) {
        std::vector<Octets> packets;
        for (const std::uint8_t octet : line) {
            if (const std::uint16_t length = plain_sxi_receive(&m_receiver, octet)) {
                const std::uint8_t* packet = plain_sxi_packet(&m_receiver);
                packets.emplace_back(packet, packet + length);
            }
        }
        return packets;
    }

    Octets fromTheMaster(const std::vector<Octets>& packets) {
        Octets line;
        for (const Octets& packet : packets) {
            m_master.append(line, m_counter++, packet);
        }
        return line;
    }

    hb_sxi_receiver m_receiver{};
    SxiCodec m_master{Plain};
    std::uint16_t m_counter = 0;
};

const std::vector<Octets> Packets{{0xFF, 0x00}, {0x9A}, {0x9B, 0x9A, 0x9B}, Octets(200, 0x9A), {0xFD}};

TEST_F(UnframedSxi, writesTheVectorsWithoutSyncAndEscapes) {
    EXPECT_EQ(fromTheBoard({0xFF, 0x00}, 0), (Octets{0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}));
    EXPECT_EQ(fromTheBoard({0x9A}, 1), (Octets{0x01, 0x01, 0x9A, 0x00, 0x9B, 0x01}));
}

TEST_F(UnframedSxi, boardAndMasterUnderstandEachOther) {
    EXPECT_EQ(found(fromTheMaster(Packets)), Packets);
    for (const Octets& packet : Packets) {
        m_master.feed(fromTheBoard(packet, 7));
        const auto frame = m_master.next();
        ASSERT_TRUE(frame && *frame);
        EXPECT_EQ(Octets((*frame)->packet.begin(), (*frame)->packet.end()), packet);
    }
}

TEST_F(UnframedSxi, damageIsIgnoredUntilThePauseBehindIt) {
    Octets damaged = fromTheMaster({{0xF4, 4, 0, 0, 0, 0, 1, 0}});
    damaged[4] ^= 0x10;
    EXPECT_TRUE(found(damaged).empty()) << "a damaged command is never obeyed";
    EXPECT_TRUE(found(fromTheMaster({{0xFD}})).empty()) << "nobody knows where it begins";
    plain_sxi_receiver_init(&m_receiver); // the line was silent
    EXPECT_EQ(found(fromTheMaster({{0xFD}})), std::vector<Octets>{Octets{0xFD}});
    EXPECT_TRUE(found({0x00, 0x01, 0xFD}).empty()) << "no length";
}

} // namespace
} // namespace halbench::devices::firmware
