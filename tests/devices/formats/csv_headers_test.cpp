#include "devices/formats/csv_headers.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(CsvHeaders, theTimeHasItsNamesInAnyCase) {
    for (const char* name : {"t", "T", "Time", "TIMESTAMP", "Zeit"}) {
        EXPECT_TRUE(isTimeName(name)) << name;
    }
    for (const char* name : {"", "times", "t1", "speed"}) {
        EXPECT_FALSE(isTimeName(name)) << name;
    }
}

TEST(CsvHeaders, aUnitThatNobodyKnowsStaysAsItIsWritten) {
    CsvColumn column;
    setUnit(column, "furlong");
    EXPECT_EQ(column.written, "furlong");
    EXPECT_FALSE(column.isUnitKnown);
    EXPECT_EQ(column.unit, "");
    setUnit(column, "mA");
    EXPECT_TRUE(column.isUnitKnown);
    EXPECT_EQ(column.unit, "A");
}

TEST(CsvHeaders, columnsBeyondTheHeaderHaveNoName) {
    const auto columns = readHeaders({"t_ms", "speed (rpm)"}, {}, 3);
    ASSERT_EQ(columns.size(), 3U);
    EXPECT_EQ(columns[0].name, "t");
    EXPECT_EQ(columns[0].unit, "s");
    EXPECT_EQ(columns[1].signal, "speed");
    EXPECT_EQ(columns[1].header, "speed (rpm)");
    EXPECT_EQ(columns[2].header, "");
    EXPECT_EQ(columns[2].signal, "");
}

} // namespace
} // namespace halbench::devices
