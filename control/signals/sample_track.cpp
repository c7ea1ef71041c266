#include "control/signals/sample_track.h"

#include <algorithm>

namespace halbench::control {

SampleTrack::SampleTrack(std::size_t columns) : m_columns(columns) {}

void SampleTrack::add(double time_s, const double* values, bool isAfterGap) {
    if (m_endRow % SampleChunk::Rows == 0) {
        m_chunks.push_back(std::make_unique<SampleChunk>(m_columns));
    }
    if (isAfterGap) {
        m_gaps.push_back(m_endRow);
    }
    m_chunks.back()->add(time_s, values);
    ++m_endRow;
    if (m_endRow % SampleChunk::Rows == 0) {
        closeUpperGroups();
    }
}

void SampleTrack::closeUpperGroups() {
    std::uint64_t groups = m_endRow / SampleChunk::Rows;
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
    ++m_firstChunk;
    for (std::size_t i = 0; i < m_upper.size(); ++i) {
        const std::uint64_t firstUseful = m_firstChunk >> (2 * (i + 1));
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

std::uint64_t SampleTrack::rowAt(double time_s) const {
    std::uint64_t low = firstRow();
    std::uint64_t high = m_endRow;
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (this->time_s(middle) < time_s) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

std::uint64_t SampleTrack::rowAtFrom(std::uint64_t start, double time_s) const {
    std::uint64_t step = 1;
    std::uint64_t low = start;
    while (low < m_endRow && this->time_s(low) < time_s) {
        const std::uint64_t next = low + step;
        if (next < m_endRow && this->time_s(next) < time_s) {
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
        if (level == 0) {
            result.add(value(column, begin));
        } else {
            result.add(group(column, level, begin >> (2 * level)));
        }
        begin += std::uint64_t{1} << (2 * level);
    }
    return result;
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
