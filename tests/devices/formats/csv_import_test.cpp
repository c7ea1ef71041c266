#include "control/base/random.h"
#include "devices/formats/csv_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace halbench::devices {
namespace {

Result<CsvImport> import(std::string_view text, const CsvImportRequest& request = {}) {
    const Result<CsvPlan> plan = planCsvImport(text, "x.csv", request);
    if (!plan) {
        return failure(plan.error());
    }
    if (!plan->questions.empty()) {
        return failure(ErrorCode::Usage, plan->questions.front().text);
    }
    return importCsv(text, "x.csv", *plan);
}

struct Style {
    char separator;
    char decimal;
    CsvHeader header;
    const char* lineEnd;
    bool hasMark;
};

/// The number as another program may write it, and as the C library reads it: the second route. Seventeen
/// digits tell every double from its neighbours; more digits than that must be rounded as one number.
struct WrittenNumber {
    std::string text;
    double value;
};

WrittenNumber numberFor(Random& random, int row) {
    char text[64];
    const double value = random.gaussian() * std::pow(10.0, 30.0 * random.uniform() - 15.0);
    constexpr const char* Formats[] = {"%.17g", "%.6f", "%.25e", "%.3g", "%.0f"};
    std::snprintf(text, sizeof text, Formats[row % 5], value);
    return {text, std::strtod(text, nullptr)};
}

std::string cellFor(std::string text, const Style& style) {
    if (style.decimal == ',') {
        const std::size_t point = text.find('.');
        if (point != std::string::npos) {
            text[point] = ',';
        }
        return style.separator == ',' ? '"' + text + '"' : text;
    }
    return text;
}

std::string headerFor(const Style& style) {
    const std::string separator(1, style.separator);
    switch (style.header) {
    case CsvHeader::None:
        return "";
    case CsvHeader::Names:
        return "t[s]" + separator + "omega[rpm]" + separator + "other" + style.lineEnd;
    case CsvHeader::NamesAndUnits:
        return "t" + separator + "omega" + separator + "other" + style.lineEnd + "s" + separator + "rpm" +
               separator + "-" + style.lineEnd;
    }
    return "";
}

std::vector<Style> everyStyle() {
    std::vector<Style> styles;
    for (const char separator : {',', ';', '\t', ' '}) {
        for (const char decimal : {'.', ','}) {
            for (const CsvHeader header : {CsvHeader::None, CsvHeader::Names, CsvHeader::NamesAndUnits}) {
                for (const char* lineEnd : {"\n", "\r\n"}) {
                    styles.push_back({separator, decimal, header, lineEnd, false});
                    styles.push_back({separator, decimal, header, lineEnd, true});
                }
            }
        }
    }
    return styles;
}

class CsvImportStyles : public testing::TestWithParam<Style> {};

TEST_P(CsvImportStyles, isSeenAndReadToTheLastBit) {
    const Style style = GetParam();
    Random random(7);
    std::string text = (style.hasMark ? "\xEF\xBB\xBF" : "") + headerFor(style);
    std::vector<double> times;
    std::vector<double> others;
    for (int row = 0; row < 200; ++row) {
        const std::string time = std::to_string(row) + "." + std::to_string(row % 9 + 1);
        const WrittenNumber other = numberFor(random, row);
        times.push_back(std::strtod(time.c_str(), nullptr));
        others.push_back(other.value);
        text += cellFor(time, style) + style.separator + std::to_string(row) + style.separator +
                cellFor(other.text, style) + style.lineEnd;
    }
    CsvImportRequest request;
    if (style.header == CsvHeader::None) {
        request.timeColumn = "1";
        request.units = {{"1", "s"}, {"2", "rpm"}};
    }
    const Result<CsvImport> read = import(text, request);
    ASSERT_TRUE(read) << read.error().message << read.error().hint;
    EXPECT_EQ(read->recording.time_s, times);
    ASSERT_EQ(read->recording.values.size(), 2 * others.size());
    for (std::size_t row = 0; row < others.size(); ++row) {
        EXPECT_EQ(read->recording.values[2 * row],
                  static_cast<double>(row) * (3.14159265358979323846 / 30.0));
        EXPECT_EQ(read->recording.values[2 * row + 1], others[row]) << row;
    }
    EXPECT_EQ(read->recording.layout->columns[0].unit, "rad/s");
}

INSTANTIATE_TEST_SUITE_P(Product, CsvImportStyles, testing::ValuesIn(everyStyle()));

TEST(CsvImport, timeIsFoundByNameAndConvertedFromItsUnit) {
    for (const auto& [header, factor] : std::vector<std::pair<std::string, double>>{
             {"a,time [ms]", 1e3}, {"a,t_us", 1e6}, {"a,Zeit (s)", 1.0}, {"a [ms],t [s]", 1.0}}) {
        const Result<CsvImport> read = import(header + "\n5,1\n6,2\n7.5,4\n");
        ASSERT_TRUE(read) << header << read.error().message;
        EXPECT_EQ(read->recording.time_s, (std::vector<double>{1 / factor, 2 / factor, 4 / factor}));
        EXPECT_FALSE(read->isUniform);
        EXPECT_EQ(read->longestStep_s, 4 / factor - 2 / factor);
        EXPECT_EQ(read->shortestStep_s, 2 / factor - 1 / factor);
    }
}

TEST(CsvImport, aRateReplacesTheTime) {
    CsvImportRequest request;
    request.rate_Hz = 3.0;
    const Result<CsvImport> read = import("0.5\n0.25\n0.125\n", request);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->recording.time_s, (std::vector<double>{0.0, 1.0 / 3.0, 2.0 / 3.0}));
    EXPECT_TRUE(read->isUniform);
    EXPECT_EQ(read->recording.layout->columns[0].name, "column_1");
    request.rate_Hz = 0.0;
    EXPECT_EQ(import("1\n2\n", request).error().code, ErrorCode::OutOfRange);
    request = {};
    request.rate_Hz = 10.0;
    request.timeColumn = "1";
    EXPECT_EQ(import("1\n2\n", request).error().code, ErrorCode::Usage);
}

TEST(CsvImport, missingCellsAreNanAndCounted) {
    const Result<CsvImport> read = import("t_s;a;b;\n0,5;;NaN;\n1,5;2,5;#N/A;\n2,5;inf;3;\n");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->missing, 4U);
    EXPECT_EQ(read->firstMissing, "line 2, column 2, 'a'");
    EXPECT_TRUE(std::isnan(read->recording.values[0]));
    EXPECT_EQ(read->recording.values[2], 2.5);
    EXPECT_EQ(read->recording.values[5], 3.0);
}

TEST(CsvImport, aMissingTimeIsNamedWithItsColumn) {
    const auto read = import("a,t_s,b\n1,0,1\n2,,1\n3,0.2,1\n");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message.find("x.csv:3:3: the time is missing (column 2, 't_s')"), 0U)
        << read.error().message;
}

TEST(CsvImport, rowsMissingInTheTimeAxisAreCounted) {
    const Result<CsvImport> read = import("t_s,a\n0,1\n0.01,1\n0.02,1\n0.05,1\n0.06,1\n");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->recording.lostRows, 2U); // 0.03 and 0.04
}

TEST(CsvImport, aTableWithQuestionsNamesWhatIsMissing) {
    const Result<CsvPlan> plan = planCsvImport("x,y\n1.5,2\n2.5,3\n", "x.csv", {});
    ASSERT_TRUE(plan) << plan.error().message;
    ASSERT_EQ(plan->questions.size(), 1U);
    EXPECT_EQ(plan->questions[0].about, "time");
    EXPECT_EQ(plan->questions[0].answers.front().option, "--time x");
    EXPECT_EQ(plan->questions[0].answers.back().option, "--rate_Hz F");
    EXPECT_EQ(plan->firstLines.front(), "x,y");
}

TEST(CsvImport, namesInLatin1BecomeUtf8) {
    const Result<CsvPlan> plan = planCsvImport("t_s;W\xE4rme [\xB0\x43]\n0,5;1\n", "x.csv", {});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->columns[1].header, "W\xC3\xA4rme [\xC2\xB0\x43]");
    EXPECT_EQ(plan->columns[1].unit, "degC");
    EXPECT_EQ(plan->columns[1].signal, "W_rme");
}

struct Damage {
    const char* rows; ///< behind 200 good rows, so that only the reading sees them
    const char* place;
    const char* words;
};

class CsvImportDamage : public testing::TestWithParam<Damage> {};

TEST_P(CsvImportDamage, isRefusedWithLineAndColumn) {
    std::string text = "t [s];a\n"; // line 1; the good rows are lines 2 to 201
    for (int row = 0; row < 200; ++row) {
        text += std::to_string(row) + ",5;1\n";
    }
    const Result<CsvImport> read = import(text + GetParam().rows);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(read.error().message.find(std::string("x.csv:") + GetParam().place), std::string::npos)
        << read.error().message;
    EXPECT_NE(read.error().message.find(GetParam().words), std::string::npos) << read.error().message;
    EXPECT_FALSE(read.error().hint.empty());
}

INSTANTIATE_TEST_SUITE_P(Rows, CsvImportDamage,
                         testing::Values(Damage{"200,5\n", "202:1", "1 cells"},
                                         Damage{"200,5;1;2\n", "202:9", "3 cells"},
                                         Damage{"200,5;x\n", "202:7", "'x' is not a number (column 2"},
                                         Damage{"200,5;1.5\n", "202:7", "'1.5' is not a number"},
                                         Damage{"200,5;1.234\n", "202:7", "thousands"},
                                         Damage{"200,5;1 234\n", "202:7", "thousands"},
                                         Damage{"200,5;1.234,5\n", "202:7", "thousands"},
                                         Damage{"200,5;1e999\n", "202:7", "out of the number range"},
                                         Damage{"200,5;\"1\n", "202:7", "quoted"},
                                         Damage{"199,5;1\n", "202:1", "does not increase"},
                                         Damage{";1\n", "202:1", "missing"},
                                         Damage{"nan;1\n", "202:1", "missing"},
                                         Damage{"# note\n\n200,5;x\n", "204:7", "not a number"}));

TEST(CsvImport, aTableCutOffAnywhereIsReadOrRefusedButNeverMisread) {
    const std::string text = "t [s];a\n0,5;1,25\n1,5;2,5\n2,5;3,75\n";
    const Result<CsvImport> whole = import(text);
    ASSERT_TRUE(whole);
    for (std::size_t size = 0; size < text.size(); ++size) {
        const Result<CsvImport> part = import(text.substr(0, size));
        for (std::size_t row = 0; part && row + 1 < part->recording.rows();
             ++row) { // but for the row that was cut
            EXPECT_EQ(part->recording.values[row], whole->recording.values[row]) << size;
        }
    }
}

TEST(CsvImport, aLongTableCanBeGivenUpWhileItIsRead) {
    std::string text = "t_s,a\n";
    for (int row = 0; row < 5000; ++row) {
        text += std::to_string(row) + ",1.5\n";
    }
    const Result<CsvPlan> plan = planCsvImport(text, "x.csv", {});
    ASSERT_TRUE(plan) << plan.error().message;
    int questions = 0;
    const auto read = importCsv(text, "x.csv", *plan, [&questions]() -> Result<void> {
        return ++questions < 3 ? Result<void>()
                               : failure(ErrorCode::Interrupted, "cancelled by the user", {});
    });
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(questions, 3); // of five
}

} // namespace
} // namespace halbench::devices
