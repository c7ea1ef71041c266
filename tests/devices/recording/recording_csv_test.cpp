#include "control/base/random.h"
#include "devices/recording/recording_csv.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

namespace halbench::devices {
namespace {

std::shared_ptr<const StreamLayout> layoutOf(std::vector<StreamLayout::Column> columns) {
    return std::make_shared<const StreamLayout>(StreamLayout{std::move(columns), 0.01});
}

std::string numberText(double value) {
    std::string text;
    appendCsvNumber(text, value);
    return text;
}

TEST(RecordingCsv, columnIsTheSignalWithUnderscoresAndTheUnitSuffix) {
    EXPECT_EQ(csvColumnName("hall.a", "T"), "hall_a_T");
    EXPECT_EQ(csvColumnName("coil_temperature.b", "degC"), "coil_temperature_b_degC");
    EXPECT_EQ(csvColumnName("torn_count", ""), "torn_count");
    EXPECT_EQ(csvHeader(*layoutOf({{"position", "rad"}, {"speed", "rad/s"}})),
              "time_s,position_rad,speed_rad_s\n");
}

TEST(RecordingCsv, numbersAreTheShortestThatReadBack) {
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(0.01), "0.01");
    EXPECT_EQ(numberText(-3.0), "-3");
    EXPECT_EQ(numberText(static_cast<double>(0.1F)), "0.1") << "a 4-octet float in its own precision";
    EXPECT_EQ(numberText(4294967295.0), "4294967295") << "a large count keeps every digit";
    EXPECT_EQ(numberText(std::nan("")), "");
}

TEST(RecordingCsv, aDoubleThatHappensToBeAFloatKeepsItsDigitsWhenAskedTo) {
    const double value = static_cast<double>(0.1F); // 0.100000001490116..., not the double nearest to 0.1
    std::string text;
    appendCsvNumber(text, value, CsvNumbers::Exact);
    EXPECT_EQ(text, "0.10000000149011612");
}

TEST(RecordingCsv, everyDoubleSurvivesWritingAndReading) {
    Random random(7);
    SampleBlock block;
    block.layout = layoutOf({{"position", "rad"}});
    for (int row = 0; row < 2000; ++row) {
        block.time_s.push_back(row / 1000.0);
        block.values.push_back(random.gaussian() * std::pow(10.0, 20.0 * random.uniform() - 10.0));
    }
    std::string text = csvHeader(*block.layout);
    appendCsvRows(text, block);
    const auto recording = parseRecordingCsv(text, "x.csv");
    ASSERT_TRUE(recording) << recording.error().message;
    EXPECT_EQ(recording->time_s, block.time_s);
    EXPECT_EQ(recording->values, block.values);
    EXPECT_EQ(recording->layout->columns[0].name, "position");
    EXPECT_EQ(recording->layout->columns[0].unit, "rad");
    EXPECT_NEAR(recording->layout->period_s, 0.001, 1e-12);
}

TEST(RecordingCsv, localeChangesNothing) {
    const char* changed = std::setlocale(LC_ALL, "de_DE.UTF-8"); // may not be installed: then nothing to show
    EXPECT_EQ(numberText(0.5), "0.5");
    EXPECT_TRUE(parseRecordingCsv("time_s,a\n0.5,1.5\n", "x"));
    if (changed != nullptr) {
        std::setlocale(LC_ALL, "C");
    }
}

TEST(RecordingCsv, emptyFieldsAndNotANumberReadAsNan) {
    const auto recording = parseRecordingCsv("time_s,a\n0,\n1,nan\n2,inf\n3,4\n", "x");
    ASSERT_TRUE(recording);
    for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_TRUE(std::isnan(recording->values[row]));
    }
    EXPECT_EQ(recording->values[3], 4.0);
}

TEST(RecordingCsv, takesByteOrderMarkAndWindowsLineEnds) {
    const auto recording = parseRecordingCsv("\xEF\xBB\xBFtime_s,a\r\n0,1\r\n", "x");
    ASSERT_TRUE(recording) << recording.error().message;
    EXPECT_EQ(recording->values, std::vector<double>{1.0});
}

/// A first column in another unit of time, and how many of it make 10 ms.
struct TimeColumn {
    const char* name;
    double step;
};

class RecordingCsvTime : public testing::TestWithParam<TimeColumn> {};

TEST_P(RecordingCsvTime, isReadInSeconds) {
    const double step = GetParam().step;
    const std::string text =
        fmt::format("{},position_rad\n0,1\n{},2\n{},3\n{},4\n", GetParam().name, step, 2 * step, 3 * step);
    const auto recording = parseRecordingCsv(text, "x.csv");
    ASSERT_TRUE(recording) << recording.error().message;
    ASSERT_EQ(recording->rows(), 4U);
    EXPECT_NEAR(recording->time_s[3], 0.03, 1e-15); // a few roundings of a double
    EXPECT_NEAR(recording->layout->period_s, 0.01, 1e-15);
    EXPECT_EQ(recording->lostRows, 0U);
}

INSTANTIATE_TEST_SUITE_P(Units, RecordingCsvTime,
                         testing::Values(TimeColumn{"time_s", 0.01}, TimeColumn{"time_ms", 10.0},
                                         TimeColumn{"time_us", 1e4}, TimeColumn{"time_ns", 1e7},
                                         TimeColumn{"time_min", 0.01 / 60}, TimeColumn{"time [ms]", 10.0},
                                         TimeColumn{"time(us)", 1e4}, TimeColumn{"time_\xC2\xB5s", 1e4}));

TEST(RecordingCsv, aTimeInNoUnitOfTimeIsRefused) {
    for (const char* name : {"time_Hz", "time_S", "time_samples", "time", "time_", "time []", "time_ms_2",
                             "timems", "time_rad", "t_ms"}) {
        const auto recording = parseRecordingCsv(std::string(name) + ",a\n0,1\n1,2\n", "x.csv");
        ASSERT_FALSE(recording) << name;
        EXPECT_NE(recording.error().hint.find("halbench import"), std::string::npos) << name;
    }
}

TEST(RecordingCsv, rowsMissingInTheTimeAxisAreCounted) {
    const auto recording = parseRecordingCsv("time_s,a\n0,1\n0.01,1\n0.02,1\n0.05,1\n0.06,1\n", "x");
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->lostRows, 2U); // 0.03 and 0.04
}

struct Damage {
    const char* text;
    const char* place;
};

class RecordingCsvDamage : public testing::TestWithParam<Damage> {};

TEST_P(RecordingCsvDamage, isRefusedWithLineAndColumn) {
    const auto recording = parseRecordingCsv(GetParam().text, "x.csv");
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(recording.error().message.find(std::string("x.csv:") + GetParam().place), std::string::npos)
        << recording.error().message;
    EXPECT_FALSE(recording.error().hint.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, RecordingCsvDamage,
    testing::Values(Damage{"", "1:1"}, Damage{"position_rad\n1\n", "1:1"}, Damage{"time_s,a,a\n", "1:10"},
                    Damage{"time_s,\n", "1:8"}, Damage{"time_s,a\n0,1\n1\n", "3:1"},
                    Damage{"time_s,a\n0,1,2\n", "2:1"}, Damage{"time_s,a\n0,1\n1,zwei\n", "3:3"},
                    Damage{"time_s,a\n0,1.5 \n", "2:3"}, Damage{"time_s,a\n0,1\n0,2\n", "3:1"},
                    Damage{"time_s,a\nnan,1\n", "2:1"}, Damage{"time_s,a\n0,1e999\n", "2:3"}));

TEST(RecordingCsv, aFileCutOffAnywhereIsReadOrRefusedButNeverMisread) {
    const std::string text = "time_s,position_rad\n0,1.25\n0.01,2.5\n0.02,3.75\n";
    const auto whole = parseRecordingCsv(text, "x");
    ASSERT_TRUE(whole);
    for (std::size_t size = 0; size < text.size(); ++size) {
        const auto part = parseRecordingCsv(std::string_view(text).substr(0, size), "x");
        if (!part || part->rows() == 0) {
            continue;
        }
        // Only the row that was cut may differ (a number that lost its last digits).
        for (std::size_t row = 0; row + 1 < part->rows(); ++row) {
            EXPECT_EQ(part->values[row], whole->values[row]) << size;
        }
    }
}

TEST(RecordingCsv, emptyFieldsAndWordsForNoNumberAreMissingWhereverTheyStand) {
    const auto read = parseRecordingCsv("time_s,a,b,c\n0,,2,\n1,nan,5,inf\n2,7,,9\n", "x");
    ASSERT_TRUE(read) << read.error().message;
    const std::vector<int> missing = {1, 0, 1, 1, 0, 1, 0, 1, 0};
    ASSERT_EQ(read->values.size(), missing.size());
    for (std::size_t i = 0; i < missing.size(); ++i) {
        EXPECT_EQ(std::isnan(read->values[i]), missing[i] == 1) << i;
    }
    EXPECT_EQ(read->values[4], 5.0);
    EXPECT_EQ(read->values[8], 9.0);
}

TEST(RecordingCsv, piecesOfAnyLengthReadAsTheWhole) {
    const std::string text = "\xEF\xBB\xBFtime_s,hall_a_T,n\r\n0,0.25,1\r\n\r\n0.5,,2\n1,-1e-3,3\n2,7,4";
    const Result<Recording> whole = parseRecordingCsv(text, "run.csv");
    ASSERT_TRUE(whole) << whole.error().message;
    ASSERT_EQ(whole->rows(), 4U);
    for (std::size_t length = 1; length <= text.size(); ++length) {
        RecordingCsvParser parser("run.csv", text.size(), 1000);
        for (std::size_t begin = 0; begin < text.size(); begin += length) {
            ASSERT_TRUE(parser.feed(std::string_view(text).substr(begin, length)));
        }
        const Result<Recording> pieces = parser.finish();
        ASSERT_TRUE(pieces) << pieces.error().message;
        EXPECT_EQ(pieces->time_s, whole->time_s);
        EXPECT_EQ(pieces->values[0], 0.25);
        EXPECT_TRUE(std::isnan(pieces->values[2]));
        EXPECT_EQ(pieces->layout->columns[0].name, "hall_a");
        EXPECT_EQ(pieces->layout->period_s, whole->layout->period_s);
    }
}

TEST(RecordingCsv, piecesSayTheLineOfAnError) {
    RecordingCsvParser parser("run.csv", 100, 1000);
    ASSERT_TRUE(parser.feed("time_s,n\n0,1\n1,"));
    const Result<void> bad = parser.feed("two\n");
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().message.find("run.csv:3:3:"), std::string::npos) << bad.error().message;
}

TEST(RecordingCsv, moreThanMemoryTakesIsRefusedWithTheLine) {
    std::string text = "time_s,n\n";
    for (int row = 0; row < 70'000; ++row) { // 1.1 MB of numbers
        text += std::to_string(row) + ",1\n";
    }
    RecordingCsvParser parser("run.csv", text.size(), std::uint64_t{1} << 20);
    const Result<void> fed = parser.feed(text);
    ASSERT_FALSE(fed);
    EXPECT_EQ(fed.error().code, ErrorCode::InvalidInput);
    // 65536 rows of 16 octets are a megabyte; it is looked at every thousand rows, below one line of header.
    EXPECT_NE(fed.error().message.find("run.csv:66001:"), std::string::npos) << fed.error().message;
    EXPECT_NE(fed.error().message.find("1 MB"), std::string::npos);
    EXPECT_FALSE(fed.error().hint.empty());
}

TEST(RecordingCsv, aFileWithoutLinesIsRefusedBeforeItFillsTheMemory) {
    RecordingCsvParser parser("run.csv", 0, 1000);
    const std::string zeros(600'000, '\0');
    ASSERT_TRUE(parser.feed(zeros));
    const Result<void> fed = parser.feed(zeros);
    ASSERT_FALSE(fed);
    EXPECT_NE(fed.error().message.find("run.csv:1:1:"), std::string::npos) << fed.error().message;
}

TEST(RecordingCsv, aLongFileCanBeGivenUpWhileItIsRead) {
    std::string text = "time_s,a\n";
    for (int row = 0; row < 50000; ++row) {
        text += std::to_string(row) + ",1\n";
    }
    int questions = 0;
    const auto recording = parseRecordingCsv(text, "x", [&questions]() -> Result<void> {
        return ++questions < 3 ? Result<void>()
                               : failure(ErrorCode::Interrupted, "cancelled by the user", {});
    });
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(questions, 3); // of fifty
}

} // namespace
} // namespace halbench::devices
