#include "app/documents/text/numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

TEST(Numbers, areWrittenAsTheShortestTextThatReadsBack) {
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(4.0), "4");
    EXPECT_EQ(formatNumber(-0.0), "0");
    EXPECT_EQ(formatNumber(1.0 / 3.0), "0.3333333333333333");
    for (const double value : {5.5e-4, 2.05e-2, 1e300, 5e-324, 123456789.123, -1.43e-2}) {
        EXPECT_EQ(parseNumber(formatNumber(value)), value);
    }
}

TEST(Numbers, readOnlyAWholeText) {
    EXPECT_EQ(parseNumber("2e-3"), 2e-3);
    EXPECT_EQ(parseNumber("+1.5"), 1.5);
    for (const char* wrong : {"", " 1", "1 ", "1,5", "0x10", "1e", "ten", "1.5.2", "--1", "+"}) {
        EXPECT_FALSE(parseNumber(wrong).has_value()) << wrong;
    }
}

TEST(Numbers, keepTheirPointInAGermanLocale) {
    const char* found = std::setlocale(LC_ALL, "de_DE.UTF-8");
    ASSERT_NE(found, nullptr) << "the locale is part of ./dev's packages";
    EXPECT_EQ(formatNumber(1.5), "1.5");
    EXPECT_EQ(parseNumber("1.5"), 1.5);
    EXPECT_FALSE(parseNumber("1,5").has_value());
    std::setlocale(LC_ALL, "C");
}

TEST(Numbers, notFiniteOnesAreReadSoThatTheyCanBeRefusedByName) {
    EXPECT_TRUE(std::isnan(*parseNumber("nan")));
    EXPECT_EQ(numberOption("--rate", "nan").error().code, ErrorCode::NotFinite);
    EXPECT_EQ(numberOption("--rate", "-inf").error().code, ErrorCode::NotFinite);
    const Result<double> word = numberOption("--rate", "fast");
    EXPECT_EQ(word.error().code, ErrorCode::Usage);
    EXPECT_NE(word.error().message.find("--rate"), std::string::npos);
    EXPECT_NE(word.error().message.find("fast"), std::string::npos);
}

TEST(Numbers, anOptionThatWasNotGivenHasNone) {
    EXPECT_EQ(optionalNumber("--from", "").value(), std::nullopt);
    EXPECT_EQ(optionalNumber("--from", "0").value(), 0.0);
    EXPECT_EQ(optionalNumber("--from", "now").error().code, ErrorCode::Usage);
}

TEST(Numbers, integersAreWhole) {
    EXPECT_EQ(parseInteger("-7"), -7);
    for (const char* wrong : {"", "7.0", "1e3", "7 ", "99999999999999999999"}) {
        EXPECT_FALSE(parseInteger(wrong).has_value()) << wrong;
    }
}

} // namespace
} // namespace halbench::app
