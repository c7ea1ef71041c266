#include "devices/formats/mdf4_blocks.h"

#include <gtest/gtest.h>

namespace halbench::devices::mdf4 {
namespace {

TEST(Mdf4Blocks, aBlockIsIdLengthLinksAndDataFilledUpToEightOctets) {
    const std::string block = makeBlock("##TX", {0x1122334455667788U}, std::string("abc\0", 4));
    const std::string expected("##TX\0\0\0\0"
                               "\x28\0\0\0\0\0\0\0" // 24 + 8 + 4 = 36, filled up to 40
                               "\x01\0\0\0\0\0\0\0"
                               "\x88\x77\x66\x55\x44\x33\x22\x11"
                               "abc\0\0\0\0\0",
                               40);
    EXPECT_EQ(block, expected);
}

TEST(Mdf4Blocks, numbersAreLittleEndianAndComeBack) {
    std::string octets;
    put(octets, std::uint16_t{0x0102});
    put(octets, 1.0); // 3FF0000000000000
    EXPECT_EQ(octets, std::string("\x02\x01\0\0\0\0\0\0\xF0\x3F", 10));
    EXPECT_EQ(get<std::uint16_t>(octets, 0), 0x0102);
    EXPECT_EQ(get<double>(octets, 2), 1.0);
}

TEST(Mdf4Blocks, theSizesAreThoseOfTheStandard) {
    EXPECT_EQ(Hd.size(), 104U);
    EXPECT_EQ(Fh.size(), 56U);
    EXPECT_EQ(Dg.size(), 64U);
    EXPECT_EQ(Cg.size(), 104U);
    EXPECT_EQ(Si.size(), 56U);
    EXPECT_EQ(Cn.size(), 160U);
    EXPECT_EQ(Ev.size(), 96U);
}

} // namespace
} // namespace halbench::devices::mdf4
