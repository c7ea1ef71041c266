#include "devices/recording/recording_chunks.h"
#include "devices/recording/recording_salvage.h"
#include "tests/devices/recording/recording_sample.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

constexpr std::size_t Rows = 23;
constexpr std::size_t LinesPerChunk = 5;

/// A recording as it was written, and where its lines and chunks begin.
class SalvageTest : public testing::Test {
protected:
    SalvageTest() {
        text = csvHeader(*part.layout);
        appendCsvRows(text, {part.layout, part.time_s, part.values, 0.0, 0});
        std::size_t begin = 0;
        for (std::size_t at = 0; at < text.size(); ++at) {
            if (text[at] != '\n') {
                continue;
            }
            lineEnds.push_back(at + 1);
            if (lineEnds.size() % LinesPerChunk == 0) {
                journal +=
                    chunkLine({at + 1 - begin, crc32(std::string_view(text).substr(begin, at + 1 - begin))});
                begin = at + 1;
            }
        }
    }

    std::size_t lineOf(std::size_t octet) const {
        std::size_t line = 0;
        while (lineEnds[line] <= octet) {
            ++line;
        }
        return line;
    }
    bool isInTail(std::size_t line) const { return line >= lineEnds.size() / LinesPerChunk * LinesPerChunk; }

    SalvagedRows salvage(std::string_view damaged, std::string_view checksums) const {
        auto rows = salvageRows(damaged, checksums, metaOf(part), "run.csv.partial");
        EXPECT_TRUE(rows) << rows.error().message;
        return rows ? *std::move(rows) : SalvagedRows();
    }

    /// Which rows of the original came back, each to the last bit; `wrong`: others.
    std::vector<bool> returned(const SalvagedRows& salvaged, std::size_t& wrong) const {
        std::vector<bool> isBack(Rows, false);
        wrong = 0;
        const std::size_t width = part.layout->columns.size();
        const Recording& got = salvaged.recording;
        for (std::size_t row = 0, at = 0; row < got.rows(); ++row) {
            while (at < Rows && part.time_s[at] < got.time_s[row]) {
                ++at;
            }
            const bool isIt = at < Rows && part.time_s[at] == got.time_s[row] &&
                              std::equal(got.values.begin() + static_cast<long>(row * width),
                                         got.values.begin() + static_cast<long>((row + 1) * width),
                                         part.values.begin() + static_cast<long>(at * width));
            wrong += isIt ? 0 : 1;
            if (isIt) {
                isBack[at] = true;
            }
        }
        return isBack;
    }

    bool hasColumns(const SalvagedRows& salvaged) const {
        return salvaged.recording.layout && csvHeader(*salvaged.recording.layout) == csvHeader(*part.layout);
    }

    Recording part = ramp(Rows); // with the header 24 lines: four chunks and four rows behind them
    std::string text;
    std::string journal;
    std::vector<std::size_t> lineEnds;
};

/// A digit for another, what ends fields and lines, what is no text.
constexpr std::string_view Damage("7,\n-.x\0\xFF", 8);

TEST_F(SalvageTest, oneWrongOctetAnywhereCostsItsChunkAndNothingElse) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t line = lineOf(at);
        for (const char other : Damage) {
            if (other == text[at]) {
                continue;
            }
            std::string damaged = text;
            damaged[at] = other;
            const SalvagedRows salvaged = salvage(damaged, journal);
            std::size_t wrong = 0;
            const std::vector<bool> isBack = returned(salvaged, wrong);
            // Behind the last checksum another digit in a value is as good as the first.
            ASSERT_LE(wrong, isInTail(line) ? 1U : 0U) << at;
            ASSERT_TRUE(hasColumns(salvaged)) << at;
            for (std::size_t row = 0; row < Rows; ++row) {
                const std::size_t itsLine = row + 1;
                const bool isItsChunk = itsLine / LinesPerChunk == line / LinesPerChunk;
                // In the tail the rows before it stay, but the one before a time that goes back.
                const bool isDue = isInTail(line) ? itsLine + 1 < line : !isItsChunk;
                ASSERT_TRUE(isBack[row] || !isDue) << "octet " << at << " row " << row;
                ASSERT_FALSE(isBack[row] && isItsChunk && !isInTail(line))
                    << "octet " << at << " row " << row;
            }
            ASSERT_TRUE(isInTail(line) || salvaged.damagedOctets > 0) << at;
        }
    }
}

TEST_F(SalvageTest, cutAnywhereEveryWholeRowComesBack) {
    for (const std::string& checksums : {journal, std::string()}) {
        for (std::size_t size = lineEnds[0]; size <= text.size(); ++size) {
            const SalvagedRows salvaged = salvage(text.substr(0, size), checksums);
            const std::size_t lines = static_cast<std::size_t>(
                std::upper_bound(lineEnds.begin(), lineEnds.end(), size) - lineEnds.begin());
            ASSERT_EQ(salvaged.recording.rows(), lines - 1) << size;
            ASSERT_EQ(salvaged.damagedOctets, 0U) << size;
            ASSERT_EQ(salvaged.cutOctets, size - lineEnds[lines - 1]) << size;
            std::size_t wrong = 0;
            (void)returned(salvaged, wrong);
            ASSERT_EQ(wrong, 0U) << size;
            ASSERT_TRUE(hasColumns(salvaged));
        }
    }
}

TEST_F(SalvageTest, withoutChecksumsTheRowsBeforeTheWrongLineStay) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t line = lineOf(at);
        for (const char other : Damage) {
            std::string damaged = text;
            damaged[at] = other;
            const SalvagedRows salvaged = salvage(damaged, "");
            std::size_t wrong = 0;
            const std::vector<bool> isBack = returned(salvaged, wrong);
            ASSERT_LE(wrong, 1U) << at;
            ASSERT_TRUE(hasColumns(salvaged)) << at;
            for (std::size_t row = 0; row + 2 < line; ++row) {
                ASSERT_TRUE(isBack[row]) << "octet " << at << " row " << row;
            }
            // A header that is damaged costs no more than the row that it may have swallowed.
            ASSERT_TRUE(line > 0 || salvaged.recording.rows() + 1 >= Rows) << at;
        }
    }
}

TEST_F(SalvageTest, aTimeThatLeaptAheadIsLeftOutToo) {
    std::string damaged = text;
    damaged.replace(damaged.find("\n0.1,"), 5, "\n7.1,");
    const SalvagedRows salvaged = salvage(damaged, "");
    EXPECT_EQ(salvaged.recording.rows(), 10U);
    EXPECT_DOUBLE_EQ(salvaged.recording.time_s.back(), 0.09);
    EXPECT_EQ(salvaged.damagedOctets, text.size() - lineEnds[10]);
}

TEST_F(SalvageTest, withoutASidecarAWholeFirstLineSays) {
    std::string damaged = text;
    damaged[lineEnds[0] + 2] = 'x';
    const auto salvaged = salvageRows(damaged, journal, {}, "run.csv.partial");
    ASSERT_TRUE(salvaged) << salvaged.error().message;
    EXPECT_EQ(salvaged->recording.rows(), Rows - (LinesPerChunk - 1));
    damaged[0] = 'x';
    const auto nameless = salvageRows(damaged, journal, {}, "run.csv.partial");
    ASSERT_FALSE(nameless);
    EXPECT_EQ(nameless.error().code, ErrorCode::InvalidInput);
}

TEST_F(SalvageTest, onlyAHeaderAndAPieceOfARowAreNoRows) {
    for (std::size_t size = 0; size <= lineEnds[2]; ++size) {
        EXPECT_EQ(holdsRows(text.substr(0, size), metaOf(part)), size >= lineEnds[1]) << size;
    }
    EXPECT_FALSE(holdsRows(text.substr(0, lineEnds[0]) + std::string(50, '\0'), {}));
    std::string damaged = text.substr(0, lineEnds[1]);
    damaged[lineEnds[0] - 1] = 'x'; // the header has lost its end, and has the row in it
    EXPECT_TRUE(holdsRows(damaged, metaOf(part)));
}

} // namespace
} // namespace halbench::devices
