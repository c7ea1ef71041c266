#include "control/base/random.h"
#include "devices/xcp/packets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::devices::xcp {
namespace {

// Layouts: resources/help/protocol.md 3.5, written out by hand.

TEST(Commands, haveTheOctetsOfTheTable) {
    const CommandEncoder little;
    const Address address{0x00010004, 2};
    EXPECT_EQ(little.connect(), (Packet{0xFF, 0x00}));
    EXPECT_EQ(little.getId(IdType::Upload), (Packet{0xFA, 4}));
    EXPECT_EQ(little.setMta(address), (Packet{0xF6, 0, 0, 2, 4, 0, 1, 0}));
    EXPECT_EQ(little.upload(7), (Packet{0xF5, 7}));
    EXPECT_EQ(little.shortUpload(address, 4), (Packet{0xF4, 4, 0, 2, 4, 0, 1, 0}));
    EXPECT_EQ(little.buildChecksum(0x100), (Packet{0xF3, 0, 0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(little.userCommand(0x45), (Packet{0xF1, 0x45}));
    EXPECT_EQ(little.download(Packet{1, 2}), (Packet{0xF0, 2, 1, 2}));
    EXPECT_EQ(little.shortDownload(address, Packet{9}), (Packet{0xED, 1, 0, 2, 4, 0, 1, 0, 9}));
    EXPECT_EQ(little.setCalPage(2, 0, 1), (Packet{0xEB, 2, 0, 1}));
    EXPECT_EQ(little.getCalPage(PageAccess::ControlLoop, 0), (Packet{0xEA, 1, 0}));
    EXPECT_EQ(little.copyCalPage(0, 0, 1), (Packet{0xE4, 0, 0, 0, 1}));
    EXPECT_EQ(little.allocDaq(1), (Packet{0xD5, 0, 1, 0}));
    EXPECT_EQ(little.allocOdt(0, 2), (Packet{0xD4, 0, 0, 0, 2}));
    EXPECT_EQ(little.allocOdtEntry(0, 1, 3), (Packet{0xD3, 0, 0, 0, 1, 3}));
    EXPECT_EQ(little.setDaqPtr(0x0102, 3, 4), (Packet{0xE2, 0, 2, 1, 3, 4}));
    EXPECT_EQ(little.writeDaq(address, 4), (Packet{0xE1, 0xFF, 4, 2, 4, 0, 1, 0}));
    EXPECT_EQ(little.setDaqListMode(0x10, 0, 1, 5), (Packet{0xE0, 0x10, 0, 0, 1, 0, 5, 0}));
    EXPECT_EQ(little.startStopDaqList(2, 0), (Packet{0xDE, 2, 0, 0}));
    EXPECT_EQ(little.startStopSynch(1), (Packet{0xDD, 1}));
    EXPECT_EQ(little.getDaqEventInfo(0x0201), (Packet{0xD7, 0, 1, 2}));
    EXPECT_EQ(little.setRequest(1), (Packet{0xF9, 1, 0, 0}));
    EXPECT_EQ(CommandEncoder(ByteOrder::BigEndian).setMta(address), (Packet{0xF6, 0, 0, 2, 0, 1, 0, 4}));
}

TEST(Responses, connectTellsSizesAndByteOrder) {
    const auto little = decodeConnect(Packet{0xFF, 0x05, 0xC0, 255, 0xFC, 0x01, 1, 1});
    ASSERT_TRUE(little);
    EXPECT_EQ(little->maxCto, 255);
    EXPECT_EQ(little->maxDto, 508);
    EXPECT_TRUE(little->hasBlockMode() && little->hasDaq());
    const auto big = decodeConnect(Packet{0xFF, 0x05, 0x01, 32, 0x01, 0xFC, 1, 1});
    ASSERT_TRUE(big);
    EXPECT_EQ(big->maxDto, 508);
    EXPECT_EQ(big->order, ByteOrder::BigEndian);
    EXPECT_FALSE(decodeConnect(Packet{0xFF, 0x05, 0x00, 7, 8, 0, 1, 1})) << "MAX_CTO below 8";
    EXPECT_FALSE(decodeConnect(Packet{0xFF, 0x05, 0x02, 8, 8, 0, 1, 1})) << "word granularity";
}

TEST(Responses, timeStampModesGiveTicksThatDivideExactly) {
    // size 4, unit 3 = 1 us, 1 tick
    const auto micro = decodeDaqResolution(Packet{0xFF, 1, 8, 1, 8, 0x34, 1, 0}, ByteOrder::LittleEndian);
    ASSERT_TRUE(micro);
    EXPECT_EQ(micro->timestampSize, 4);
    EXPECT_DOUBLE_EQ(micro->tick_s, 1e-6);
    EXPECT_EQ(micro->ticksPerSecond, 1e6);
    // unit 6 = 1 ms, 3 ticks: a third of a thousand is not whole
    const auto odd = decodeDaqResolution(Packet{0xFF, 1, 8, 1, 8, 0x62, 3, 0}, ByteOrder::LittleEndian);
    ASSERT_TRUE(odd);
    EXPECT_EQ(odd->ticksPerSecond, 0.0);
    EXPECT_DOUBLE_EQ(odd->tick_s, 3e-3);
    for (const Packet& nonsense : {Packet{0xFF, 0, 8, 1, 8, 0x34, 1, 0}, Packet{0xFF, 1, 0, 1, 8, 0x34, 1, 0},
                                   Packet{0xFF, 1, 8, 1, 8, 0x33, 1, 0}, Packet{0xFF, 1, 8, 1, 8, 0xA4, 1, 0},
                                   Packet{0xFF, 1, 8, 1, 8, 0x34, 0, 0}}) {
        EXPECT_FALSE(decodeDaqResolution(nonsense, ByteOrder::LittleEndian)) << hexText(nonsense);
    }
}

TEST(Responses, everyShorterOneIsRefused) {
    const Packet longest(8, 0x08);
    const auto refuses = [&](std::size_t needed, const auto& decode) {
        for (std::size_t size = 0; size < needed; ++size) {
            EXPECT_FALSE(decode(Octets(longest).first(size)))
                << needed << " octets needed, " << size << " given";
        }
    };
    refuses(8, [](Octets o) { return decodeConnect(o); });
    refuses(6, [](Octets o) { return decodeStatus(o); });
    refuses(8, [](Octets o) { return decodeId(o, ByteOrder::LittleEndian); });
    refuses(8, [](Octets o) { return decodeChecksum(o, ByteOrder::LittleEndian); });
    refuses(4, [](Octets o) { return decodeCalPage(o); });
    refuses(8, [](Octets o) { return decodeDaqProcessor(o, ByteOrder::LittleEndian); });
    refuses(8, [](Octets o) { return decodeDaqResolution(o, ByteOrder::LittleEndian); });
    refuses(7, [](Octets o) { return decodeDaqEvent(o); });
    refuses(8, [](Octets o) { return decodeDaqClock(o, ByteOrder::LittleEndian); });
}

TEST(Responses, clockIsTheFieldBehindItsFormat) {
    const Packet answer{0xFF, 0, 0, 1, 0x78, 0x56, 0x34, 0x12};
    EXPECT_EQ(*decodeDaqClock(answer, ByteOrder::LittleEndian), 0x12345678U);
    EXPECT_EQ(*decodeDaqClock(answer, ByteOrder::BigEndian), 0x78563412U);
}

TEST(Octets, checksumIsCrc16CittOfTheStandardCheckText) {
    // CRC-16/CCITT-FALSE of "123456789" is 29B1 in every catalogue of CRCs.
    const std::string text = "123456789";
    EXPECT_EQ(crc16(Packet(text.begin(), text.end())), 0x29B1);
    EXPECT_EQ(crc16({}), 0xFFFF);
}

TEST(Octets, everyTypeKeepsItsLimitsInBothByteOrders) {
    for (const ByteOrder order : {ByteOrder::LittleEndian, ByteOrder::BigEndian}) {
        for (int i = 0; i <= static_cast<int>(DataType::Float64); ++i) {
            const auto type = static_cast<DataType>(i);
            for (const double value : {lowestOf(type), 0.0, 1.0, highestOf(type)}) {
                Packet octets;
                appendRaw(octets, value, type, order);
                ASSERT_EQ(octets.size(), sizeOf(type));
                EXPECT_EQ(decodeRaw(octets, type, order), value) << i;
            }
        }
    }
    Packet big;
    appendRaw(big, -2.0, DataType::SWord, ByteOrder::BigEndian);
    EXPECT_EQ(big, (Packet{0xFF, 0xFE}));
}

TEST(Octets, numbersOutsideATypeAreKeptInsideIt) {
    Packet octets;
    appendRaw(octets, 1e9, DataType::UByte, ByteOrder::LittleEndian);
    appendRaw(octets, -5.0, DataType::UByte, ByteOrder::LittleEndian);
    appendRaw(octets, -200.0, DataType::SByte, ByteOrder::LittleEndian);
    appendRaw(octets, std::nan(""), DataType::UByte, ByteOrder::LittleEndian);
    EXPECT_EQ(octets, (Packet{255, 0, 0x80, 0}));
    Packet tiny;
    appendRaw(tiny, std::numeric_limits<double>::max(), DataType::Float32, ByteOrder::LittleEndian);
    EXPECT_TRUE(std::isfinite(decodeRaw(tiny, DataType::Float32, ByteOrder::LittleEndian)));
}

} // namespace
} // namespace halbench::devices::xcp
