#include "devices/formats/csv_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices {
namespace {

std::vector<std::string> cellsOf(std::string_view line, char separator) {
    std::vector<CsvCell> cells;
    EXPECT_TRUE(splitCsv(line, separator, cells));
    std::vector<std::string> texts;
    for (const CsvCell& cell : cells) {
        texts.emplace_back(cell.text);
    }
    return texts;
}

using Texts = std::vector<std::string>;

TEST(CsvText, linesComeWithoutMarkCommentsAndEmptyLinesButWithTheirNumber) {
    CsvLines lines("\xEF\xBB\xBF# title\r\n\r\na;b\r\n % note\n1;2");
    CsvLine line;
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line.text, "a;b");
    EXPECT_EQ(line.number, 3U);
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line.text, "1;2");
    EXPECT_EQ(line.number, 5U);
    EXPECT_FALSE(lines.next(line));
    EXPECT_TRUE(lines.hasByteOrderMark());
    EXPECT_TRUE(lines.hasCrLf());
    EXPECT_EQ(lines.comments(), 2U);
}

TEST(CsvText, cellsLoseTheirBlanksAndQuotes) {
    EXPECT_EQ(cellsOf(" 1 ; \"a;b\" ;;3", ';'), (Texts{"1", "a;b", "", "3"}));
    EXPECT_EQ(cellsOf("1\t\t2", '\t'), (Texts{"1", "", "2"}));
    EXPECT_EQ(cellsOf("  1   2 \t 3  ", ' '), (Texts{"1", "2", "", "3"}))
        << "blanks are one separator, a tab is none";
    EXPECT_EQ(cellsOf("1;2;", ';'), (Texts{"1", "2", ""}));
    EXPECT_EQ(cellsOf("1, 2", 0), (Texts{"1, 2"}));
    EXPECT_EQ(cellsOf("\"say \"\"x\"\"\",2", ','), (Texts{"say \"\"x\"\"", "2"}));
}

TEST(CsvText, aQuoteThatDoesNotEndIsSeenWithItsPlace) {
    std::vector<CsvCell> cells;
    EXPECT_FALSE(splitCsv("1;\"2;3", ';', cells));
    EXPECT_EQ(cells.back().column, 3U);
    EXPECT_FALSE(splitCsv("1;\"2\"x;3", ';', cells));
}

TEST(CsvText, aCellIsANumberOnlyWhenAllOfItIs) {
    double value = 0.0;
    EXPECT_EQ(readCell("-1.5e-3", '.', value), CellKind::Number);
    EXPECT_EQ(value, -1.5e-3);
    EXPECT_EQ(readCell("+1,5", ',', value), CellKind::Number);
    EXPECT_EQ(value, 1.5);
    EXPECT_EQ(readCell(".5", '.', value), CellKind::Number);
    EXPECT_EQ(readCell("5.", '.', value), CellKind::Number);
    for (const char* text : {"1,5", "1.5x", "0x10", "-", "+-1", "abc", "1 2", "1e", "--1", "."}) {
        EXPECT_EQ(readCell(text, '.', value), CellKind::Text) << text;
    }
    for (const char* text : {"1.5", "1,", ",5", "1,5,5", "-,5"}) {
        EXPECT_EQ(readCell(text, ',', value), CellKind::Text) << text;
    }
    EXPECT_EQ(readCell("1e999", '.', value), CellKind::TooLarge);
}

TEST(CsvText, wordsForNoNumberAreMissing) {
    for (const char* text : {"", "NaN", "nan", "N/A", "#N/A", "NULL", "Inf", "-inf", "Infinity", "1.#QNAN"}) {
        for (const char decimal : {'.', ','}) {
            double value = 0.0;
            EXPECT_EQ(readCell(text, decimal, value), CellKind::Missing) << text;
            EXPECT_TRUE(std::isnan(value)) << text;
        }
    }
}

TEST(CsvText, groupsOfThreeDigitsAreRecognised) {
    EXPECT_TRUE(isGrouped("1,234", ','));
    EXPECT_TRUE(isGrouped("-12.345.678,25", '.'));
    EXPECT_EQ(groupedValue("-12.345.678,25", '.'), -12345678.25);
    for (const char* text : {"0,234", "1,23", "1,2345", "1234,567", "1", ",123", "1,234x", "1,234,56"}) {
        EXPECT_FALSE(isGrouped(text, ',')) << text;
    }
}

} // namespace
} // namespace halbench::devices
