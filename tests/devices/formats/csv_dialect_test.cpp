#include "devices/formats/csv_attempt.h"
#include "devices/formats/csv_dialect.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

struct Written {
    const char* text;
    char separator;
    char decimal;
    CsvHeader header;
};

class CsvDialectSeen : public testing::TestWithParam<Written> {};

TEST_P(CsvDialectSeen, fromTheFirstLinesAlone) {
    const auto sight = detectDialect(GetParam().text, "x.csv", {});
    ASSERT_TRUE(sight) << sight.error().message;
    EXPECT_TRUE(sight->questions.empty()) << sight->questions.front().text;
    ASSERT_EQ(sight->candidates.size(), 1U);
    EXPECT_EQ(separatorWord(sight->candidates[0].separator), separatorWord(GetParam().separator));
    EXPECT_EQ(sight->candidates[0].decimal, GetParam().decimal);
    EXPECT_EQ(sight->candidates[0].header, GetParam().header);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, CsvDialectSeen,
    testing::Values(Written{"t,a\n0.1,1\n", ',', '.', CsvHeader::Names},
                    Written{"t;a\n0,1;1\n", ';', ',', CsvHeader::Names},
                    Written{"0,1;1\n0,2;2\n", ';', ',', CsvHeader::None},
                    Written{"t\ta\ns\tA\n0.1\t1\n", '\t', '.', CsvHeader::NamesAndUnits},
                    Written{"t a\n  0,1   12\n", ' ', ',', CsvHeader::Names},
                    Written{"0.1\n0.2\n", 0, '.', CsvHeader::None},
                    Written{"t\n0,1\n0,25\n", 0, ',', CsvHeader::Names},
                    Written{"t;a\n0;1\n1;2\n", ';', '.', CsvHeader::Names}, // no number has a decimal sign
                    Written{"t,a\n0,1\n1,2\n", ',', '.', CsvHeader::Names}, // two names: no single column
                    Written{"t;a;\n0,1;1;\n0,2;2;\n", ';', ',', CsvHeader::Names},
                    Written{"\"t, s\",a\n\"0,1\",\"1,5\"\n", ',', ',', CsvHeader::Names},
                    Written{"t;a\n0,1;\n0,2;NaN\n", ';', ',', CsvHeader::Names},
                    Written{"t;a\n1,234;2\n0,5;3\n", ';', ',', CsvHeader::Names}, // 0,5: no thousands
                    Written{"1, 2, 3\n2, 3, 4\n", ',', '.', CsvHeader::None}));

TEST(CsvDialect, markAndLineEndsAreSeen) {
    const auto sight = detectDialect("\xEF\xBB\xBF# by x\r\nt;a\r\n0,1;1\r\n", "x.csv", {});
    ASSERT_TRUE(sight) << sight.error().message;
    EXPECT_TRUE(sight->hasByteOrderMark);
    EXPECT_TRUE(sight->hasCrLf);
    EXPECT_EQ(sight->comments, 1U);
}

struct Unsure {
    const char* text;
    std::vector<CsvQuestion::Answer> answers;
};

class CsvDialectUnsure : public testing::TestWithParam<Unsure> {};

TEST_P(CsvDialectUnsure, isAskedWithWhatEveryAnswerWouldRead) {
    const auto sight = detectDialect(GetParam().text, "x.csv", {});
    ASSERT_TRUE(sight) << sight.error().message;
    ASSERT_EQ(sight->questions.size(), 1U);
    const auto& answers = sight->questions[0].answers;
    ASSERT_EQ(answers.size(), GetParam().answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i].option, GetParam().answers[i].option);
        EXPECT_EQ(answers[i].meaning.rfind(GetParam().answers[i].meaning, 0), 0U) << answers[i].meaning;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, CsvDialectUnsure,
    testing::Values(
        Unsure{"1,5\n2,5\n",
               {{"--separator ',' --decimal .", "2 columns: 1 | 5"},
                {"--separator 'none' --decimal ,", "1 column: 1.5"}}},
        Unsure{"t;a\n1,234;2\n2,345;3\n",
               {{"--decimal ,", "2 columns: 1.234 | 2"}, {"--decimal .", "2 columns: 1234 | 2 (thousands"}}},
        Unsure{"1.234;5.678\n",
               {{"--decimal .", "2 columns: 1.234"}, {"--decimal ,", "2 columns: 1234 | 5678 (th"}}},
        Unsure{"1,555,333\n2,666,444\n",
               {{"--separator ','", "3 columns: 1 | 555 | 333"},
                {"--separator 'none'", "1 column: 1555333 (thousands"}}},
        Unsure{"1,a\n2,3\n", {{"--header 0", "no header"}, {"--header 1", "one line"}}},
        Unsure{"t;a\ns;1\n0,5;2\n", {{"--header 1", "one line"}, {"--header units", "a line of names"}}}));

TEST(CsvDialect, anAnswerSettlesTheQuestion) {
    CsvHints hints;
    hints.separator = '\0';
    auto sight = detectDialect("1,5\n2,5\n", "x.csv", hints);
    ASSERT_TRUE(sight) << sight.error().message;
    EXPECT_TRUE(sight->questions.empty());
    EXPECT_EQ(sight->candidates.at(0).decimal, ',');
    hints = {};
    hints.decimal = ',';
    sight = detectDialect("t;a\n1,234;2\n", "x.csv", hints);
    ASSERT_TRUE(sight) << sight.error().message;
    EXPECT_TRUE(sight->questions.empty());
    EXPECT_EQ(sight->candidates.at(0).separator, ';');
}

TEST(CsvDialect, theRestOfTheTextTellsTheDecimalSignWhenTheFirstLinesDoNot) {
    std::string text = "t;a\n";
    for (int row = 0; row < 500; ++row) {
        text += std::to_string(row) + ";1\n";
    }
    auto sight = detectDialect(text + "500;1,5\n", "x.csv", {});
    ASSERT_TRUE(sight) << sight.error().message;
    EXPECT_TRUE(sight->questions.empty());
    EXPECT_EQ(sight->candidates.at(0).decimal, ',');
    sight = detectDialect(text + "500;1,500\n", "x.csv", {});
    ASSERT_TRUE(sight) << sight.error().message;
    ASSERT_EQ(sight->questions.size(), 1U) << "1.5 or 1500";
}

struct Damage {
    const char* text;
    const char* place;
    const char* words;
};

class CsvDialectDamage : public testing::TestWithParam<Damage> {};

TEST_P(CsvDialectDamage, isRefusedWithItsPlace) {
    const auto sight = detectDialect(GetParam().text, "x.csv", {});
    ASSERT_FALSE(sight);
    EXPECT_EQ(sight.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(sight.error().message.find(GetParam().place), std::string::npos) << sight.error().message;
    EXPECT_NE(sight.error().message.find(GetParam().words), std::string::npos) << sight.error().message;
    EXPECT_FALSE(sight.error().hint.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, CsvDialectDamage,
    testing::Values(Damage{"", "x.csv:1:1", "no rows"}, Damage{"# only\n", "x.csv:1:1", "no rows"},
                    Damage{"t;a\n", "x.csv:1:1", "no rows of numbers"},
                    Damage{"t;a\n0,5;1\n1,5;zwei\n", "x.csv:3:5", "'zwei' is not a number"},
                    Damage{"t;a\n0,5;1\n1,5\n", "x.csv:3:1", "1 cells where there are 2"},
                    Damage{"t;a\n0,5;1\n1,5;2;3\n", "x.csv:3:1", "3 cells where there are 2"},
                    Damage{"t;a\n0,5;\"1\n", "x.csv:2:5", "quoted cell"},
                    Damage{"t;a\n1.234,56;2\n", "x.csv:2:1", "thousands separators"},
                    Damage{"\xFF\xFEt\0", "x.csv", "UTF-16"}, Damage{"t;a\r0,5;1\r", "x.csv:1:1", "CR only"},
                    Damage{"hello world\nthis is prose\n", "x.csv", "no"}));

TEST(CsvDialect, aZeroOctetIsNoText) {
    const auto sight = detectDialect(std::string_view("t;a\n\0;1\n", 8), "x.csv", {});
    ASSERT_FALSE(sight);
    EXPECT_NE(sight.error().message.find("not a text"), std::string::npos);
}

TEST(CsvDialect, aVeryLongLineIsRefused) {
    const auto sight = detectDialect(std::string(100000, '1') + "\n", "x.csv", {});
    ASSERT_FALSE(sight);
    EXPECT_NE(sight.error().message.find("x.csv:1:1: the line has 100000"), std::string::npos)
        << sight.error().message;
}

TEST(CsvAttempt, knowsWidthHeadersAndWhereItFailed) {
    const std::vector<CsvLine> lines = {{"t;a", 1}, {"0;1", 2}, {"1;x", 3}};
    CsvAttempt attempt;
    attempt.dialect.separator = ';';
    EXPECT_FALSE(tryToRead(attempt, lines, nullptr, {}));
    EXPECT_EQ(attempt.width, 2U);
    EXPECT_EQ(attempt.headers, std::vector{CsvHeader::Names});
    EXPECT_EQ(attempt.line, 3U);
    EXPECT_EQ(attempt.column, 3U);
}

} // namespace
} // namespace halbench::devices
