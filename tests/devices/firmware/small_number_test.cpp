// Numbers as a small board writes them, compiled for this processor beside those of the full build.
#define HB_NUMBER_DIGITS 6
#define hb_format_float smallFormatFloat
#define hb_format_unsigned smallFormatUnsigned
#define hb_format_hex smallFormatHex
#include "devices/firmware/xcp/hb_text.c"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace halbench::devices::firmware {
namespace {

std::string formatted(float value) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_float(value, text);
    return text;
}

TEST(SmallNumberText, isAWholeNumberAndAPowerOfTen) {
    EXPECT_EQ(formatted(0.0F), "0");
    EXPECT_EQ(formatted(60000.0F), "60000");
    EXPECT_EQ(formatted(-51471.0F), "-51471");
    EXPECT_EQ(formatted(0.02F), "2e-2");
    EXPECT_EQ(formatted(2.7925268e-3F), "279253e-8");
    EXPECT_EQ(formatted(1.0e6F), "1e6");
}

TEST(SmallNumberText, readsBackWithinSixDigits) {
    std::uint32_t state = 12345;
    for (int i = 0; i < 200000; ++i) {
        state = state * 1664525U + 1013904223U;
        // 1e-9 to 1e9 of both signs: what limits of a table are. Half a unit of the sixth digit is 5e-6 where
        // the first digits are 1; eighteen multiplications by ten or a tenth add at most 1e-6 of 6e-8 each.
        const double exponent = -9.0 + 18.0 * static_cast<double>(state >> 8) / 16777216.0;
        const auto value = static_cast<float>((state & 1U ? -1.0 : 1.0) * std::pow(10.0, exponent));
        const std::string text = formatted(value);
        ASSERT_NEAR(std::strtod(text.c_str(), nullptr), value, 6e-6 * std::fabs(value)) << text;
        ASSERT_LT(text.size(), static_cast<std::size_t>(HB_NUMBER_CAPACITY));
    }
}

} // namespace
} // namespace halbench::devices::firmware
