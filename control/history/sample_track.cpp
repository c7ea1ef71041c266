#include "control/history/sample_track.h"

#include <algorithm>
#include <iterator>

namespace halbench::control {

SampleTrack::SampleTrack(std::size_t columns) : m_columns(columns) {}

void SampleTrack::add(std::span<const double> time_s, std::span<const ColumnSource> columns,
                      std::size_t firstRow) {
    constexpr std::uint64_t Group = std::uint64_t{1} << (2 * (SampleChunk::Levels + 1));
    while (!time_s.empty()) {
        if (m_endRow % SampleChunk::Rows == 0) {
            m_chunks.push_back(std::make_unique<SampleChunk>(m_columns));
            m_begins_s.push_back(time_s.front());
        }
        const std::size_t rows = std::min(time_s.size(), static_cast<std::size_t>(Group - m_endRow % Group));
        m_chunks.back()->add(time_s.first(rows), columns, firstRow);
        m_endRow += rows;
        time_s = time_s.subspan(rows);
        firstRow += rows;
        if (m_endRow % Group == 0) {
            closeUpperGroups();
        }
    }
}

std::size_t SampleTrack::bytes() const {
    return (m_chunks.size() - m_paged) * SampleChunk::bytesFor(m_columns) +
           m_paged * SampleChunk::pagedBytesFor(m_columns);
}

std::optional<double> SampleTrack::nextToPut_s() const {
    const bool isThere = m_put < m_chunks.size() && m_chunks[m_put]->isFull() && m_put + 1 < m_chunks.size();
    return isThere ? std::optional(m_begins_s[m_put]) : std::nullopt;
}

void SampleTrack::settle() {
    while (m_paged < m_put && m_chunks[m_paged]->settle()) {
        ++m_paged;
    }
}

void SampleTrack::closeUpperGroups() {
    std::uint64_t groups = m_endRow >> (2 * SampleChunk::Levels);
    for (std::size_t i = 0; groups % 4 == 0; ++i) {
        groups /= 4;
        const std::size_t level = SampleChunk::Levels + 1 + i;
        if (m_upper.size() <= i) {
            m_upper.emplace_back(m_columns);
            m_firstUpper.push_back(groups - 1);
        }
        for (std::size_t column = 0; column < m_columns; ++column) {
            m_upper[i][column].push_back(mergedGroups(column, level - 1, 4 * (groups - 1)));
        }
    }
}

Extremes SampleTrack::mergedGroups(std::size_t column, std::size_t level, std::uint64_t first) const {
    Extremes merged;
    for (std::uint64_t index = first; index < first + 4; ++index) {
        if ((index << (2 * level)) >= firstRow()) { // what was dropped meanwhile is never asked for again
            merged.add(group(column, level, index));
        }
    }
    return merged;
}

void SampleTrack::dropOldestChunk() {
    m_chunks.pop_front();
    m_begins_s.pop_front();
    ++m_firstChunk;
    m_paged -= m_paged > 0 ? 1 : 0;
    m_put -= m_put > 0 ? 1 : 0;
    for (std::size_t i = 0; i < m_upper.size(); ++i) {
        const std::uint64_t firstUseful = firstRow() >> (2 * (SampleChunk::Levels + 1 + i));
        while (m_firstUpper[i] < firstUseful && !m_upper[i].front().empty()) {
            for (auto& column : m_upper[i]) {
                column.pop_front();
            }
            ++m_firstUpper[i];
        }
    }
    while (!m_gaps.empty() && m_gaps.front() < firstRow()) {
        m_gaps.pop_front();
    }
}

namespace {

/// The last mark of the chunk that is before a time; its first is.
std::size_t markBefore(const SampleChunk& chunk, double time_s) {
    std::size_t mark = 0;
    for (std::size_t last = (chunk.rows() - 1) / SampleChunk::MarkRows; mark < last;) {
        const std::size_t middle = (mark + last + 1) / 2;
        if (chunk.markedTime_s(middle * SampleChunk::MarkRows) < time_s) {
            mark = middle;
        } else {
            last = middle - 1;
        }
    }
    return mark;
}

/// First row of the chunk that is not before a time; its first row is.
std::size_t rowWithin(const SampleChunk& chunk, double time_s) {
    const std::size_t mark = markBefore(chunk, time_s);
    std::size_t low = mark * SampleChunk::MarkRows + 1;
    for (std::size_t high = std::min(low - 1 + SampleChunk::MarkRows, chunk.rows()); low < high;) {
        const std::size_t middle = (low + high) / 2;
        if (chunk.time_s(middle) < time_s) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

} // namespace

std::size_t SampleTrack::chunksBefore(double time_s) const {
    return static_cast<std::size_t>(std::lower_bound(m_begins_s.begin(), m_begins_s.end(), time_s) -
                                    m_begins_s.begin());
}

std::uint64_t SampleTrack::rowAt(double time_s) const {
    // The last chunk, and in it the last mark, that begins before the time: what is looked for comes after.
    const std::size_t chunks = chunksBefore(time_s);
    if (chunks == 0) {
        return firstRow();
    }
    return firstRow() + (chunks - 1) * SampleChunk::Rows + rowWithin(*m_chunks[chunks - 1], time_s);
}

std::uint64_t SampleTrack::markedRowAt(double time_s) const {
    const std::size_t chunks = chunksBefore(time_s);
    if (chunks == 0) {
        return firstRow();
    }
    const std::size_t mark = markBefore(*m_chunks[chunks - 1], time_s) + 1;
    return std::min(firstRow() + (chunks - 1) * SampleChunk::Rows + mark * SampleChunk::MarkRows, m_endRow);
}

namespace {

/// First of start, start + 1, ... that is not before, or end; `start` is not after it. Steps that grow and
/// shrink: O(log(answer - start)).
template <typename IsBefore>
std::uint64_t gallop(std::uint64_t start, std::uint64_t end, const IsBefore& isBefore) {
    std::uint64_t step = 1;
    std::uint64_t low = start;
    while (low < end && isBefore(low)) {
        const std::uint64_t next = low + step;
        if (next < end && isBefore(next)) {
            low = next;
            step *= 2;
        } else if (step == 1) {
            return low + 1;
        } else {
            step = std::max<std::uint64_t>(1, step / 4);
        }
    }
    return low;
}

} // namespace

std::uint64_t SampleTrack::rowAtFrom(std::uint64_t start, double time_s) const {
    return gallop(start, m_endRow, [&](std::uint64_t row) { return this->time_s(row) < time_s; });
}

Extremes SampleTrack::group(std::size_t column, std::size_t level, std::uint64_t index) const {
    if (level <= SampleChunk::Levels) {
        const std::uint64_t row = index << (2 * level);
        const std::size_t within = static_cast<std::size_t>(row % SampleChunk::Rows);
        return chunkOf(row).group(column, level, within >> (2 * level));
    }
    const std::size_t i = level - SampleChunk::Levels - 1;
    return m_upper[i][column][static_cast<std::size_t>(index - m_firstUpper[i])];
}

Extremes SampleTrack::extremes(std::size_t column, std::uint64_t begin, std::uint64_t end) const {
    Extremes result;
    std::size_t level = 0;
    const auto fits = [&](std::size_t candidate) {
        const std::uint64_t size = std::uint64_t{1} << (2 * candidate);
        return begin % size == 0 && begin + size <= end;
    };
    while (begin < end) {
        while (level > 0 && !fits(level)) {
            --level;
        }
        while (hasUpperLevel(level + 1) && fits(level + 1)) {
            ++level;
        }
        constexpr std::size_t Coarse = SampleChunk::Levels + 1;
        if (level < Coarse && !chunkOf(begin).isAtHand(column, level)) {
            result.add(group(column, Coarse, begin >> (2 * Coarse)));
            begin = ((begin >> (2 * Coarse)) + 1) << (2 * Coarse);
            continue;
        }
        if (level == 0) {
            result.add(value(column, begin));
        } else {
            result.add(group(column, level, begin >> (2 * level)));
        }
        begin += std::uint64_t{1} << (2 * level);
    }
    return result;
}

bool SampleTrack::areAtHand(std::size_t column, std::uint64_t begin, std::uint64_t end) const {
    bool areHere = true;
    for (std::uint64_t row = begin; row < end; row = (row / SampleChunk::Rows + 1) * SampleChunk::Rows) {
        areHere = chunkOf(row).isAtHand(column, 0) && areHere; // all of them are asked for at once
    }
    return areHere;
}

Moments SampleTrack::moments(std::size_t column, std::uint64_t begin, std::uint64_t end) const {
    Moments moments;
    while (begin < end) {
        const auto first = static_cast<std::size_t>(begin % SampleChunk::Rows);
        const auto rows =
            static_cast<std::size_t>(std::min<std::uint64_t>(SampleChunk::Rows - first, end - begin));
        moments.add(chunkOf(begin).moments(column, first, first + rows));
        begin += rows;
    }
    return moments;
}

std::size_t SampleTrack::gaps(std::uint64_t begin, std::uint64_t end) const {
    const auto first = std::lower_bound(m_gaps.begin(), m_gaps.end(), begin);
    return static_cast<std::size_t>(std::lower_bound(first, m_gaps.end(), end) - first);
}

bool SampleTrack::hasGap(std::uint64_t begin, std::uint64_t end) const {
    const auto gap = std::lower_bound(m_gaps.begin(), m_gaps.end(), begin);
    return gap != m_gaps.end() && *gap < end;
}

} // namespace halbench::control
