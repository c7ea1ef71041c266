#include "devices/firmware/htm/hb_htm_internal.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

/// Small generator of its own, the same octets on every machine.
class Noise {
public:
    explicit Noise(std::uint32_t seed) : m_state(seed) {}
    std::uint32_t next() {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 17;
        m_state ^= m_state << 5;
        return m_state;
    }
    std::uint32_t below(std::uint32_t limit) { return next() % limit; }

private:
    std::uint32_t m_state;
};

/// Mostly plausible: a command code, small numbers, addresses near the edges of the spaces.
Octets randomPacket(Noise& noise) {
    static constexpr std::uint32_t Edges[] = {0,       8,       0x7FF8,  0x8000,  0x8010,
                                              0x10000, 0x10004, 0x10080, 0x10100, 0xFFFFFFFF};
    Octets packet(1 + noise.below(40));
    for (std::uint8_t& octet : packet) {
        octet = static_cast<std::uint8_t>(noise.below(4) == 0 ? noise.next() : noise.below(9));
    }
    packet[0] = static_cast<std::uint8_t>(0xC0 + noise.below(64));
    if (packet.size() >= 8 && noise.below(2) == 0) {
        const Octets address = BoardFixture::le32(Edges[noise.below(10)] + noise.below(5) - 2);
        std::copy(address.begin(), address.end(), packet.begin() + 4);
    }
    if (packet[0] == 0xFE && noise.below(20) != 0) {
        packet[0] = 0xFF; // mostly stay connected
        packet.resize(2);
        packet[1] = 0;
    }
    return packet;
}

/// Every parameter of the page the loop runs on, and every live one, is finite and within its limits.
void expectSafeParameters(hb_htm& board) {
    for (std::uint16_t i = 0; i < hb_htm_actuator.parameter_count; ++i) {
        hb_parameter p;
        hb_parameter_read(&hb_htm_actuator.parameters[i], &p);
        if (p.space == HB_BLOCK) {
            continue;
        }
        const auto* base =
            p.space == HB_LIVE
                ? reinterpret_cast<const std::uint8_t*>(&board.live)
                : reinterpret_cast<const std::uint8_t*>(&board.pages[board.board.xcp.active_page]);
        ASSERT_TRUE(hb_value_is_finite(p.entry.type, base + p.entry.offset))
            << hb_htm_actuator.parameters[i].entry.words;
        const float value = hb_value_as_float(p.entry.type, base + p.entry.offset);
        ASSERT_GE(value, p.entry.lower) << hb_htm_actuator.parameters[i].entry.words;
        ASSERT_LE(value, p.entry.upper) << hb_htm_actuator.parameters[i].entry.words;
    }
}

TEST(HostileMaster, neitherCrashesTheBoardNorMakesItUnsafe) {
    BoardFixture f;
    Noise noise(20260701);
    f.tick();
    f.connect();
    for (int i = 0; i < 60000; ++i) {
        f.send(randomPacket(noise));
        if (noise.below(3) == 0) {
            f.angle_rad += 0.02;
            f.tick();
            ASSERT_NO_FATAL_FAILURE(expectSafeParameters(f.board()));
            for (const float current : f.outputs.phase_current_A) {
                ASSERT_LE(std::abs(current), 4.001F);
            }
        }
        if (noise.below(50) == 0) {
            f.received();
        }
        if (noise.below(200) == 0) {
            f.reset();
        }
    }
    f.received();
    f.connect();
    EXPECT_EQ(f.command({0xFD}).size(), 6U);
}

TEST(HostileMaster, cannotKeepTheStopFromBeingObeyed) {
    BoardFixture f;
    Noise noise(7);
    f.tick();
    f.connect();
    for (int i = 0; i < 500; ++i) {
        for (int k = 0; k < 20; ++k) {
            f.send(randomPacket(noise));
        }
        f.send({0xF1, 0x45});
        f.tick();
        ASSERT_TRUE(f.isOutputZero());
        f.received();
        f.connect();
        f.reset();
        f.arm();
    }
}

TEST(HostileMaster, getsAnAnswerAlthoughNobodyDrainsTheSamples) {
    // The queue is full of samples for seconds; commands still find their room.
    BoardFixture f;
    f.connect();
    f.command({0xD6});
    f.command({0xD5, 0, 1, 0});
    f.command({0xD4, 0, 0, 0, 1});
    f.command({0xD3, 0, 0, 0, 0, 1});
    f.command({0xE2, 0, 0, 0, 0, 0});
    f.command({0xE1, 0xFF, 4, 0, 0, 0, 0, 0});
    f.command({0xE0, 0x10, 0, 0, 0, 0, 1, 0});
    f.command({0xDE, 2, 0, 0});
    f.command({0xDD, 1});
    f.tick(10000);
    EXPECT_EQ(f.command({0xFD}), (Octets{0xFF, 0x40, 0, 0, 0, 0}));
}

} // namespace
} // namespace halbench::devices::firmware
