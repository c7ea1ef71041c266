#include "control/base/random.h"
#include "control/history/sample_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

const double NaN = std::numeric_limits<double>::quiet_NaN();

/// One column; time = row / 1000.
SampleTrack trackOf(const std::vector<double>& values) {
    SampleTrack track(1);
    std::vector<double> time_s;
    for (std::size_t row = 0; row < values.size(); ++row) {
        time_s.push_back(static_cast<double>(row) / 1000.0);
    }
    const ColumnSource column{values.data()};
    track.add(time_s, {&column, 1});
    return track;
}

std::vector<double> noise(std::size_t count, double offset) {
    Random random(7);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(offset + random.gaussian());
    }
    return values;
}

Extremes plainExtremes(const std::vector<double>& values, std::size_t begin, std::size_t end) {
    Extremes extremes;
    for (std::size_t i = begin; i < end; ++i) {
        extremes.add(values[i]);
    }
    return extremes;
}

TEST(SampleTrack, findsTheSameExtremesAsLookingAtEveryValue) {
    const std::vector<double> values = noise(100'000, 0.0); // 24 chunks: two levels above them
    const SampleTrack track = trackOf(values);
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const auto a = static_cast<std::size_t>(random.uniform() * 100'000.0);
        const auto b = static_cast<std::size_t>(random.uniform() * 100'000.0);
        const Extremes found = track.extremes(0, std::min(a, b), std::max(a, b));
        const Extremes expected = plainExtremes(values, std::min(a, b), std::max(a, b));
        // The pyramid holds floats of values below 5 that are relative to one below 5: 10 * 2^-24.
        EXPECT_NEAR(found.min, expected.min, 6e-7);
        EXPECT_NEAR(found.max, expected.max, 6e-7);
    }
}

TEST(SampleTrack, aLargeConstantPartCostsNoResolution) {
    const std::vector<double> values = noise(5000, 1e6);
    const Extremes found = trackOf(values).extremes(0, 0, 4096);
    EXPECT_NEAR(found.max, plainExtremes(values, 0, 4096).max, 1e-6); // floats of 1e6 would be 0.06 apart
}

TEST(SampleTrack, dropsOldChunksAndStillKnowsTheRest) {
    const std::vector<double> values = noise(100'000, 0.0);
    SampleTrack track = trackOf(values);
    for (int i = 0; i < 7; ++i) {
        track.dropOldestChunk();
    }
    EXPECT_EQ(track.firstRow(), 7U * 4096U);
    EXPECT_EQ(track.endRow(), 100'000U);
    const Extremes found = track.extremes(0, track.firstRow(), track.endRow());
    EXPECT_NEAR(found.min, plainExtremes(values, 7 * 4096, 100'000).min, 6e-7);
    EXPECT_EQ(track.value(0, 50'000), values[50'000]);
}

TEST(SampleTrack, keepsItsMemoryWhileRowsComeAndGo) {
    SampleTrack track(1);
    const double value = 1.0;
    const ColumnSource column{&value};
    for (std::uint64_t row = 0; row < 200'000; ++row) {
        const double time_s = static_cast<double>(row);
        track.add(std::span(&time_s, 1), {&column, 1});
        if (track.chunks() > 3) {
            track.dropOldestChunk();
        }
    }
    EXPECT_EQ(track.bytes(), 3 * SampleChunk::bytesFor(1));
    EXPECT_EQ(track.extremes(0, track.firstRow(), track.endRow()).max, 1.0);
    // Time and one value are 16 bytes; the pyramid may add a third of the value, and a little for itself.
    EXPECT_LT(static_cast<double>(SampleChunk::bytesFor(1)), 1.01 * 4096.0 * (8.0 + 8.0 * 4.0 / 3.0));
}

TEST(SampleTrack, findsRowsByTime) {
    const SampleTrack track = trackOf(std::vector<double>(10'000, 0.0));
    EXPECT_EQ(track.rowAt(-1.0), 0U);
    EXPECT_EQ(track.rowAt(0.5), 500U);
    EXPECT_EQ(track.rowAt(0.5004), 501U);
    EXPECT_EQ(track.rowAt(100.0), 10'000U);
    for (const std::uint64_t start : {0U, 1U, 2U, 300U, 500U, 501U}) {
        EXPECT_EQ(track.rowAtFrom(start, 0.5004), 501U) << start;
        EXPECT_EQ(track.rowAtFrom(start, 100.0), 10'000U) << start;
    }
}

TEST(SampleTrack, findsMarkedRowsByTime) {
    const SampleTrack track = trackOf(std::vector<double>(10'000, 0.0));
    EXPECT_EQ(track.markedRowAt(-1.0), 0U);
    EXPECT_EQ(track.markedRowAt(0.5004), 512U);
    EXPECT_EQ(track.markedRowAt(0.512), 512U);
    EXPECT_EQ(track.markedRowAt(4.09), 4096U); // in the next chunk
    EXPECT_EQ(track.markedRowAt(100.0), 10'000U);
}

TEST(SampleTrack, blocksOfAnySizeGiveTheSamePyramid) {
    const std::vector<double> values = noise(30'000, 0.0);
    const SampleTrack whole = trackOf(values);
    SampleTrack pieces(1);
    Random random(3);
    for (std::size_t row = 0; row < values.size();) {
        const auto rows =
            std::min(values.size() - row, static_cast<std::size_t>(1.0 + 700.0 * random.uniform()));
        std::vector<double> time_s;
        for (std::size_t i = row; i < row + rows; ++i) {
            time_s.push_back(static_cast<double>(i) / 1000.0);
        }
        const ColumnSource column{values.data()};
        pieces.add(time_s, {&column, 1}, row);
        row += rows;
    }
    for (std::uint64_t begin = 0; begin < 30'000; begin += 257) {
        for (std::uint64_t end = begin; end < 30'000; end += 1023) {
            ASSERT_EQ(whole.extremes(0, begin, end).min, pieces.extremes(0, begin, end).min);
            ASSERT_EQ(whole.extremes(0, begin, end).max, pieces.extremes(0, begin, end).max);
        }
    }
}

TEST(SampleTrack, valuesThatAreNotNumbersHaveNoExtremes) {
    std::vector<double> values(4096, NaN);
    EXPECT_TRUE(trackOf(values).extremes(0, 0, 4096).isEmpty());
    values[3000] = -2.0;
    const SampleTrack track = trackOf(values);
    EXPECT_TRUE(track.extremes(0, 0, 3000).isEmpty());
    EXPECT_EQ(track.extremes(0, 0, 4096).min, -2.0);
    EXPECT_EQ(track.extremes(0, 0, 4096).max, -2.0);
}

TEST(SampleTrack, knowsWhereTheLineIsInterrupted) {
    SampleTrack track(1);
    const double value = 0.0;
    const ColumnSource column{&value};
    for (std::uint64_t row = 0; row < 100; ++row) {
        const double time_s = static_cast<double>(row);
        if (row == 40) {
            track.interrupt();
        }
        track.add(std::span(&time_s, 1), {&column, 1});
    }
    EXPECT_TRUE(track.hasGap(40, 41));
    EXPECT_TRUE(track.hasGap(0, 100));
    EXPECT_FALSE(track.hasGap(0, 40));
    EXPECT_FALSE(track.hasGap(41, 100));
}

} // namespace
} // namespace halbench::control
