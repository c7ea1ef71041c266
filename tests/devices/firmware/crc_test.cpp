#include "devices/firmware/xcp/hb_crc.h"

#include <gtest/gtest.h>

#include <string>

namespace {

const std::uint8_t* octets(const std::string& text) {
    return reinterpret_cast<const std::uint8_t*>(text.data());
}

// Check values published for CRC-16/CCITT-FALSE and FNV-1a (32 bit).
TEST(Crc, hasThePublishedCheckValue) {
    EXPECT_EQ(hb_crc16(HB_CRC_START, octets("123456789"), 9), 0x29B1);
    EXPECT_EQ(hb_crc16(HB_CRC_START, nullptr, 0), 0xFFFF);
}

TEST(Crc, canBeTakenInPieces) {
    const std::string text = "123456789";
    for (std::uint16_t cut = 0; cut <= 9; ++cut) {
        const std::uint16_t begun = hb_crc16(HB_CRC_START, octets(text), cut);
        EXPECT_EQ(hb_crc16(begun, octets(text) + cut, static_cast<std::uint16_t>(9 - cut)), 0x29B1);
    }
}

TEST(Hash, hasThePublishedCheckValues) {
    EXPECT_EQ(hb_hash(HB_HASH_START, octets("a"), 1), 0xE40C292CU);
    EXPECT_EQ(hb_hash(HB_HASH_START, octets("foobar"), 6), 0xBF9CF968U);
}

} // namespace
