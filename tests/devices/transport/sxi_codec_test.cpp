#include "control/base/random.h"
#include "devices/transport/sxi_codec.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

std::vector<SxiProfile> allProfiles() {
    std::vector<SxiProfile> profiles;
    for (int header = 0; header < 6; ++header) {
        for (int checksum = 0; checksum < 3; ++checksum) {
            for (const bool isFramed : {true, false}) {
                profiles.push_back(
                    {static_cast<SxiHeader>(header), static_cast<SxiChecksum>(checksum), isFramed});
            }
        }
    }
    return profiles;
}

Octets encoded(const SxiProfile& profile, std::uint16_t counter, const Octets& packet) {
    Octets line;
    SxiCodec(profile).append(line, counter, packet);
    return line;
}

std::vector<Octets> decoded(SxiCodec& codec) {
    std::vector<Octets> packets;
    for (;;) {
        const auto frame = codec.next();
        EXPECT_TRUE(frame);
        if (!frame || !*frame) {
            return packets;
        }
        packets.emplace_back((*frame)->packet.begin(), (*frame)->packet.end());
    }
}

/// Packets with the octets that need escaping, of odd and even length.
std::vector<Octets> somePackets() {
    return {{0xFF, 0x00},     {0x9A},          {0x9B, 0x9A, 0x9B}, {0xF0, 0x02, 0x9A, 0x9B},
            Octets(61, 0x9A), Octets(64, 0x00)};
}

// The vectors of resources/help/protocol.md 3.3.3.
TEST(SxiCodec, writesTheVectorsOfTheDefaultProfile) {
    EXPECT_EQ(encoded({}, 0, {0xFF, 0x00}), (Octets{0x9A, 0x02, 0x00, 0xFF, 0x00, 0x01, 0x01}));
    EXPECT_EQ(encoded({}, 1, {0xFD}), (Octets{0x9A, 0x01, 0x01, 0xFD, 0x00, 0xFE, 0x01}));
    const SxiProfile byteSum{SxiHeader::LenByte, SxiChecksum::Byte, true};
    EXPECT_EQ(encoded(byteSum, 0, {0xFF, 0x00}), (Octets{0x9A, 0x02, 0xFF, 0x00, 0x01}));
    EXPECT_EQ(encoded(byteSum, 0, {0xF0, 0x02, 0x9A, 0x9B}),
              (Octets{0x9A, 0x04, 0xF0, 0x02, 0x9B, 0x01, 0x9B, 0x00, 0x2B}));
}

TEST(SxiCodec, everyVariantSurvivesEverySplit) {
    for (const SxiProfile& profile : allProfiles()) {
        SCOPED_TRACE(describe(profile));
        Octets line;
        std::uint16_t counter = 0x9A;
        for (const Octets& packet : somePackets()) {
            SxiCodec(profile).append(line, counter++, packet);
        }
        for (std::size_t split = 0; split <= line.size(); ++split) {
            SxiCodec codec(profile);
            std::vector<Octets> packets;
            for (const auto part : {std::span(line).first(split), std::span(line).subspan(split)}) {
                codec.feed(part);
                for (Octets& packet : decoded(codec)) {
                    packets.push_back(std::move(packet));
                }
            }
            ASSERT_EQ(packets, somePackets()) << "split at " << split;
            ASSERT_EQ(codec.damaged(), 0U);
        }
    }
}

TEST(SxiCodec, tellsTheCounterWhereThereIsOne) {
    for (const SxiProfile& profile : allProfiles()) {
        SxiCodec codec(profile);
        codec.feed(encoded(profile, 0x1234, {0xFF}));
        const auto frame = codec.next();
        ASSERT_TRUE(frame && *frame);
        if (codec.counterMask() == 0) {
            EXPECT_FALSE((*frame)->counter);
        } else {
            EXPECT_EQ((*frame)->counter, 0x1234 & codec.counterMask());
        }
    }
}

// Gate of resources/help/protocol.md: one damaged octet costs at most one frame, whichever it is. A frame may
// not be taken for another one either: framing and the word checksum find every single octet.
TEST(SxiCodec, oneDamagedOctetCostsAtMostOneFrame) {
    const Octets first{0xFF, 0x10, 0x20};
    const Octets second{0xFE, 0x9A, 0x31, 0x07};
    const Octets third{0xFD, 0x01};
    const Octets line = [&] {
        Octets octets;
        SxiCodec codec({});
        codec.append(octets, 1, first);
        codec.append(octets, 2, second);
        codec.append(octets, 3, third);
        return octets;
    }();
    for (std::size_t place = 0; place < line.size(); ++place) {
        for (unsigned value = 0; value < 256; ++value) {
            Octets damaged = line;
            damaged[place] = static_cast<std::uint8_t>(value);
            SxiCodec codec({});
            codec.feed(damaged);
            const std::vector<Octets> packets = decoded(codec);
            const auto whole = std::count_if(packets.begin(), packets.end(), [&](const Octets& packet) {
                return packet == first || packet == second || packet == third;
            });
            ASSERT_GE(whole, 2) << "octet " << place << " became " << value;
            ASSERT_EQ(static_cast<std::size_t>(whole), packets.size()) << "a wrong packet was believed";
        }
    }
}

TEST(SxiCodec, lostAndRepeatedOctetsCostAtMostOneFrame) {
    Octets line;
    SxiCodec writer({});
    for (std::uint16_t i = 0; i < 4; ++i) {
        writer.append(line, i, Octets{0xFF, static_cast<std::uint8_t>(i), 0x55});
    }
    for (std::size_t place = 0; place < line.size(); ++place) {
        for (const bool isLost : {true, false}) {
            Octets damaged = line;
            const auto at = damaged.begin() + static_cast<std::ptrdiff_t>(place);
            isLost ? damaged.erase(at) : damaged.insert(at, *at);
            SxiCodec codec({});
            codec.feed(damaged);
            EXPECT_GE(decoded(codec).size(), 3U) << (isLost ? "lost " : "repeated ") << place;
        }
    }
}

TEST(SxiCodec, anUnframedLineIsFoundAgainByItsChecksumOrBySilence) {
    const SxiProfile checked{SxiHeader::LenCtrByte, SxiChecksum::Word, false};
    SxiCodec codec(checked);
    Octets line{0x77, 0x00, 0x13};
    const Octets good = encoded(checked, 9, {0xFF, 0x01});
    line.insert(line.end(), good.begin(), good.end());
    line.resize(line.size() + 200, 0); // LEN 0x77 has to be complete before its sum can be wrong
    codec.feed(line);
    EXPECT_EQ(decoded(codec), std::vector<Octets>{(Octets{0xFF, 0x01})});
    SxiCodec silent({SxiHeader::LenWord, SxiChecksum::None, false});
    silent.feed(Octets{0x05, 0x00, 0xFF});
    EXPECT_TRUE(decoded(silent).empty());
    silent.noteSilence();
    EXPECT_EQ(silent.damaged(), 1U);
    silent.feed(Octets{0x01, 0x00, 0xFF});
    EXPECT_EQ(decoded(silent).size(), 1U);
}

// Gate of resources/help/protocol.md: 10 million octets, shared between the profiles.
TEST(SxiCodec, randomOctetsNeverBreakIt) {
    constexpr std::size_t All = 10'000'000;
    constexpr std::size_t AtOnce = 512;
    const std::vector<SxiProfile> profiles = allProfiles();
    Random random(7);
    Octets noise(AtOnce);
    std::size_t fed = 0;
    for (const SxiProfile& profile : profiles) {
        SxiCodec codec(profile);
        for (std::size_t i = 0; i < All / profiles.size() / AtOnce + 1; ++i, fed += AtOnce) {
            std::generate(noise.begin(), noise.end(),
                          [&] { return static_cast<std::uint8_t>(random.below(256)); });
            codec.feed(noise);
            for (const Octets& packet : decoded(codec)) {
                ASSERT_FALSE(packet.empty());
                ASSERT_LE(packet.size(), SxiCodec::MaxPacket);
            }
        }
    }
    EXPECT_GE(fed, All);
}

} // namespace
} // namespace halbench::devices
