#pragma once

#include "control/history/front_queue.h"
#include "control/history/sample_chunk.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace halbench::control {

/// The rows of one stream in the order of time: chunks with their pyramids, coarser levels above them, and
/// where the line is interrupted. Rows are numbered from the stream's first; dropping old ones keeps numbers.
/// The oldest chunks may be pages of a store; the coarser levels always stay in memory.
class SampleTrack {
public:
    explicit SampleTrack(std::size_t columns);

    /// Rows of `columns` from `firstRow` on; what is not finite counts as NaN.
    void add(std::span<const double> time_s, std::span<const ColumnSource> columns, std::size_t firstRow = 0);
    /// Something is missing before the row that comes next.
    void interrupt() { m_gaps.push_back(m_endRow); }
    void dropOldestChunk();

    std::uint64_t firstRow() const { return m_firstChunk * SampleChunk::Rows; }
    std::uint64_t endRow() const { return m_endRow; }
    bool isEmpty() const { return m_chunks.empty(); }
    std::size_t chunks() const { return m_chunks.size(); }
    std::size_t bytes() const; ///< in memory

    /// Chunks whose rows are only in the store.
    std::size_t pagedChunks() const { return m_paged; }
    /// Chunks that were put into the store and are still in memory.
    std::size_t waitingChunks() const { return m_put - m_paged; }
    /// Begin of the oldest full chunk that could be put into a store.
    std::optional<double> nextToPut_s() const;
    void putNext(const std::shared_ptr<PageCache>& pages) { m_chunks[m_put++]->putInto(pages); }
    /// Forgets what the store has by now.
    void settle();

    double time_s(std::uint64_t row) const { return chunkOf(row).time_s(row % SampleChunk::Rows); }
    double value(std::size_t column, std::uint64_t row) const {
        return chunkOf(row).value(column, row % SampleChunk::Rows);
    }
    double begin_s() const { return m_begins_s.front(); }
    /// First row not before a time; endRow() when all are. O(log rows), reads back one chunk at most.
    std::uint64_t rowAt(double time_s) const;
    /// The same, searching from a row that is not after the answer: fast for small steps.
    std::uint64_t rowAtFrom(std::uint64_t start, double time_s) const;
    /// First row not before a time that is a multiple of SampleChunk::MarkRows, or endRow(); reads nothing
    /// back.
    std::uint64_t markedRowAt(double time_s) const;
    /// Extremes of rows [begin, end) in O(log(end - begin)). In a glance, where detail is not at hand, those
    /// of the groups of 256 rows that they are in: never less.
    Extremes extremes(std::size_t column, std::uint64_t begin, std::uint64_t end) const;
    /// Whether the values of rows [begin, end) are answered without waiting; in a glance what is not is asked
    /// for.
    bool areAtHand(std::size_t column, std::uint64_t begin, std::uint64_t end) const;
    /// Moments of rows [begin, end): a step a chunk, and up to two chunks row by row.
    Moments moments(std::size_t column, std::uint64_t begin, std::uint64_t end) const;
    /// Whether the line is interrupted before any of the rows [begin, end); and how often.
    bool hasGap(std::uint64_t begin, std::uint64_t end) const;
    std::size_t gaps(std::uint64_t begin, std::uint64_t end) const;

private:
    using Level = std::vector<FrontQueue<Extremes>>; ///< per column; index 0 is group m_firstGroup
    const SampleChunk& chunkOf(std::uint64_t row) const {
        return *m_chunks[static_cast<std::size_t>(row / SampleChunk::Rows - m_firstChunk)];
    }
    /// Number of chunks that begin before a time.
    std::size_t chunksBefore(double time_s) const;
    Extremes group(std::size_t column, std::size_t level, std::uint64_t index) const;
    Extremes mergedGroups(std::size_t column, std::size_t level, std::uint64_t first) const;
    void closeUpperGroups();
    bool hasUpperLevel(std::size_t level) const { return level <= SampleChunk::Levels + m_upper.size(); }

    std::size_t m_columns;
    std::uint64_t m_firstChunk = 0;
    std::uint64_t m_endRow = 0;
    FrontQueue<std::unique_ptr<SampleChunk>> m_chunks;
    FrontQueue<double> m_begins_s;           ///< of the chunks
    std::size_t m_paged = 0;                 ///< the first so many chunks are only in the store
    std::size_t m_put = 0;                   ///< the first so many were put into it
    std::vector<Level> m_upper;              ///< groups of 256, 1024, ... rows
    std::vector<std::uint64_t> m_firstUpper; ///< number of the first group held, per upper level
    std::deque<std::uint64_t> m_gaps;        ///< rows before which the line is interrupted
};

} // namespace halbench::control
