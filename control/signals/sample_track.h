#pragma once

#include "control/signals/sample_chunk.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace halbench::control {

/// The rows of one stream in the order of time: chunks with their pyramids, coarser levels above them, and
/// where the line is interrupted. Rows are numbered from the stream's first; dropping old ones keeps numbers.
class SampleTrack {
public:
    explicit SampleTrack(std::size_t columns);

    /// `isAfterGap`: something is missing between this row and the one before.
    void add(double time_s, const double* values, bool isAfterGap);
    void dropOldestChunk();

    std::uint64_t firstRow() const { return m_firstChunk * SampleChunk::Rows; }
    std::uint64_t endRow() const { return m_endRow; }
    bool isEmpty() const { return m_chunks.empty(); }
    std::size_t chunks() const { return m_chunks.size(); }
    std::size_t bytes() const { return m_chunks.size() * SampleChunk::bytesFor(m_columns); }

    double time_s(std::uint64_t row) const { return chunkOf(row).time_s(row % SampleChunk::Rows); }
    double value(std::size_t column, std::uint64_t row) const {
        return chunkOf(row).value(column, row % SampleChunk::Rows);
    }
    /// First row not before a time; endRow() when all are. O(log rows).
    std::uint64_t rowAt(double time_s) const;
    /// The same, searching from a row that is not after the answer: fast for small steps.
    std::uint64_t rowAtFrom(std::uint64_t start, double time_s) const;
    /// Extremes of rows [begin, end) in O(log(end - begin)).
    Extremes extremes(std::size_t column, std::uint64_t begin, std::uint64_t end) const;
    /// Moments of rows [begin, end): a step a chunk, and up to two chunks row by row.
    Moments moments(std::size_t column, std::uint64_t begin, std::uint64_t end) const;
    /// Whether the line is interrupted before any of the rows [begin, end); and how often.
    bool hasGap(std::uint64_t begin, std::uint64_t end) const;
    std::size_t gaps(std::uint64_t begin, std::uint64_t end) const;

private:
    using Level = std::vector<std::deque<Extremes>>; ///< per column; index 0 is group m_firstGroup
    const SampleChunk& chunkOf(std::uint64_t row) const {
        return *m_chunks[static_cast<std::size_t>(row / SampleChunk::Rows - m_firstChunk)];
    }
    Extremes group(std::size_t column, std::size_t level, std::uint64_t index) const;
    Extremes mergedGroups(std::size_t column, std::size_t level, std::uint64_t first) const;
    void closeUpperGroups();
    bool hasUpperLevel(std::size_t level) const { return level <= SampleChunk::Levels + m_upper.size(); }

    std::size_t m_columns;
    std::uint64_t m_firstChunk = 0;
    std::uint64_t m_endRow = 0;
    std::deque<std::unique_ptr<SampleChunk>> m_chunks;
    std::vector<Level> m_upper;              ///< groups of 4, 16, ... chunks
    std::vector<std::uint64_t> m_firstUpper; ///< number of the first group held, per upper level
    std::deque<std::uint64_t> m_gaps;        ///< rows before which the line is interrupted
};

} // namespace halbench::control
