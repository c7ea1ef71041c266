#include "control/base/random.h"
#include "devices/xcp/daq_list.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

DaqFormat formatOf(IdField field, std::uint16_t maxDto = 16) {
    DaqFormat format;
    format.idField = field;
    format.timestampSize = 4;
    format.maxDto = maxDto;
    format.maxEntrySize = 8;
    return format;
}

std::vector<DaqEntry> floats(std::size_t count) {
    std::vector<DaqEntry> entries(count);
    for (DaqEntry& entry : entries) {
        entry.type = DataType::Float32;
    }
    return entries;
}

TEST(DaqPlan, isFirstFitWithRoomForIdentificationAndTimeStamp) {
    // 16 octets: 1 + 4 leave 11 in the first packet (two floats), 1 leaves 15 in the next (three floats).
    const auto plan = planDaqList(floats(7), formatOf(IdField::Absolute));
    ASSERT_TRUE(plan);
    EXPECT_EQ(*plan, (DaqPlan{{0, 1}, {2, 3, 4}, {5, 6}}));
    // The aligned word field takes 4: 8 octets left in the first.
    EXPECT_EQ(*planDaqList(floats(3), formatOf(IdField::RelativeWordAligned)), (DaqPlan{{0, 1}, {2}}));
}

TEST(DaqPlan, refusesValuesAndListsTheBoardCannotTake) {
    DaqFormat format = formatOf(IdField::Absolute);
    format.maxEntrySize = 2;
    EXPECT_FALSE(planDaqList(floats(1), format));
    format.maxEntrySize = 8;
    format.granularity = 8;
    EXPECT_FALSE(planDaqList(floats(1), format));
    EXPECT_FALSE(planDaqList(floats(2000), formatOf(IdField::Absolute)))
        << "more packets than identifications";
    EXPECT_FALSE(planDaqList(floats(1), formatOf(IdField::RelativeWordAligned, 6)));
}

DtoDecoder decoderOf(IdField field, std::size_t signals) {
    const DaqFormat format = formatOf(field);
    return DtoDecoder(format, floats(signals), *planDaqList(floats(signals), format), 0, 5);
}

Packet floatPacket(std::initializer_list<std::uint8_t> head, std::initializer_list<double> values) {
    Packet packet(head);
    for (const double value : values) {
        appendRaw(packet, value, DataType::Float32, ByteOrder::LittleEndian);
    }
    return packet;
}

TEST(DtoDecoder, aSampleIsCompleteWithItsLastPacketOnly) {
    DtoDecoder decoder = decoderOf(IdField::Absolute, 3);
    EXPECT_FALSE(decoder.feed(floatPacket({5, 0x10, 0x27, 0, 0}, {1.0, 2.0})));
    EXPECT_TRUE(decoder.feed(floatPacket({6}, {3.0})));
    EXPECT_EQ(decoder.timestamp(), 10000U);
    EXPECT_EQ(decoder.row(), (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(DtoDecoder, packetsOfTwoSamplesAreNeverMixed) {
    DtoDecoder decoder = decoderOf(IdField::Absolute, 3);
    EXPECT_FALSE(decoder.feed(floatPacket({5, 1, 0, 0, 0}, {1.0, 1.0})));
    EXPECT_FALSE(decoder.feed(floatPacket({5, 2, 0, 0, 0}, {2.0, 2.0})))
        << "the last packet of sample 1 was lost";
    EXPECT_TRUE(decoder.feed(floatPacket({6}, {2.0})));
    EXPECT_EQ(decoder.row(), (std::vector<double>{2.0, 2.0, 2.0}));
    EXPECT_FALSE(decoder.feed(floatPacket({6}, {3.0}))) << "the first packet of sample 3 was lost";
    EXPECT_EQ(decoder.incompleteSamples(), 1U);
}

TEST(DtoDecoder, longerPacketsAreTakenShorterNever) {
    DtoDecoder decoder = decoderOf(IdField::Absolute, 1);
    Packet padded = floatPacket({5, 0, 0, 0, 0}, {1.5});
    padded.resize(padded.size() + 3, 0xEE);
    EXPECT_TRUE(decoder.feed(padded));
    EXPECT_EQ(decoder.row()[0], 1.5);
    const Packet whole = floatPacket({5, 0, 0, 0, 0}, {2.5});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(decoder.feed(Octets(whole).first(size)));
    }
    EXPECT_EQ(decoder.foreignPackets(), whole.size());
}

TEST(DtoDecoder, bitMaskAndConversionGiveThePhysicalValue) {
    DaqEntry entry;
    entry.type = DataType::UWord;
    entry.bitMask = 0x00F0;
    entry.factor = 0.5;
    entry.offset = -1.0;
    const DaqFormat format = formatOf(IdField::Absolute);
    DtoDecoder decoder(format, {entry}, {{0}}, 0, 0);
    ASSERT_TRUE(decoder.feed(Packet{0, 0, 0, 0, 0, 0x3F, 0x12}));
    EXPECT_EQ(decoder.row()[0], 0.5 * 0x30 - 1.0);
}

TEST(TickUnwrapper, nanosecondClockOfFourOctetsIsFollowedOverTwoTurns) {
    // 2^32 ns = 4.295 s; samples every 10 ms for 10 s.
    TickUnwrapper unwrapper(4, 1e-9);
    const std::uint64_t start = 0xFFFF0000U;
    for (int i = 0; i <= 1000; ++i) {
        const std::uint64_t truth = 10000000ULL * static_cast<std::uint64_t>(i);
        const double jitter_s = 0.004 * (i % 3); // arrival is late now and then
        ASSERT_EQ(unwrapper.unwrap((start + truth) & 0xFFFFFFFFU, 0.01 * i + jitter_s),
                  static_cast<std::int64_t>(truth));
    }
}

TEST(TickUnwrapper, turnsLostInAPauseComeFromTheHostsClock) {
    TickUnwrapper unwrapper(1, 1e-3); // wraps every 0.256 s
    EXPECT_EQ(unwrapper.unwrap(10, 0.0), 0);
    EXPECT_EQ(unwrapper.unwrap((10 + 5000) & 0xFF, 5.02), 5000) << "19 turns and a bit, 20 ms late";
}

TEST(TickUnwrapper, aStepBackShowsAsSmaller) {
    TickUnwrapper unwrapper(4, 1e-6);
    EXPECT_EQ(unwrapper.unwrap(100000, 0.0), 0);
    EXPECT_EQ(unwrapper.unwrap(110000, 0.01), 10000);
    EXPECT_LT(unwrapper.unwrap(105000, 0.02), 10000);
}

} // namespace
} // namespace halbench::devices::xcp
