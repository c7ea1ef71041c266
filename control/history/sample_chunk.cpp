#include "control/history/sample_chunk.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::control {
namespace {

const double NaN = std::numeric_limits<double>::quiet_NaN();

// Parts of a page: the times, the groups of 16 rows of all columns, those of 64 (they are so short that one
// read for all signals is better than one for each), then of each column its values and its groups of 4.
constexpr std::size_t TimePart = 0;
constexpr std::size_t LevelsPerColumn = 1;
constexpr std::size_t valuePart(std::size_t column) {
    return SampleChunk::Levels + 2 * column;
}
constexpr std::size_t groupPart(std::size_t column, std::size_t level) {
    return level > LevelsPerColumn ? level - LevelsPerColumn : valuePart(column) + 1;
}

constexpr std::size_t groupPartBytes(std::size_t level, std::size_t columns) {
    const std::size_t groups = SampleChunk::Rows >> (2 * level);
    return groups * (level > LevelsPerColumn ? columns : 1) * sizeof(FloatExtremes);
}

/// The upper groups of a column (SampleTrack): a third more than the 16 of the lowest level, rounded up.
constexpr std::size_t UpperBytes = 22 * sizeof(Extremes);

} // namespace

SampleChunk::SampleChunk(std::size_t columns)
    : m_columns(columns), m_detail(std::make_shared<Detail>()), m_references(columns, NaN),
      m_moments(columns) {
    m_detail->time_s.resize(Rows);
    m_detail->values.resize(Rows * columns);
    for (std::size_t level = 1; level <= Levels; ++level) {
        m_detail->groups[level - 1].resize(groupsOf(level) * columns);
        m_groups[level - 1] = m_detail->groups[level - 1].data();
    }
    m_times_s = m_detail->time_s.data();
}

SampleChunk::~SampleChunk() {
    if (m_page) {
        m_pages->store().release(*m_page);
    }
}

std::size_t SampleChunk::detailBytesFor(std::size_t columns) {
    std::size_t groups = 0;
    for (std::size_t level = 1; level <= Levels; ++level) {
        groups += groupsOf(level);
    }
    return Rows * sizeof(double) * (1 + columns) + columns * groups * sizeof(FloatExtremes);
}

std::size_t SampleChunk::bytesFor(std::size_t columns) {
    return sizeof(SampleChunk) + sizeof(Detail) + detailBytesFor(columns) +
           columns * (sizeof(double) + sizeof(Moments) + UpperBytes);
}

std::size_t SampleChunk::pagedBytesFor(std::size_t columns) {
    return sizeof(SampleChunk) + (Rows / MarkRows + 1) * sizeof(double) +
           columns * (sizeof(double) + sizeof(Moments) + UpperBytes);
}

void SampleChunk::add(std::span<const double> time_s, std::span<const ColumnSource> columns,
                      std::size_t firstRow) {
    HB_ASSERT(m_detail != nullptr && m_rows + time_s.size() <= Rows);
    std::copy(time_s.begin(), time_s.end(), m_detail->time_s.begin() + static_cast<std::ptrdiff_t>(m_rows));
    for (std::size_t column = 0; column < m_columns; ++column) {
        addColumn(column, time_s.size(), columns[column], firstRow);
    }
    const std::size_t formerRows = m_rows;
    m_rows += time_s.size();
    for (std::size_t column = 0; column < m_columns; ++column) {
        closeGroups(column, formerRows);
        if (isFull()) {
            m_moments[column] = momentsOf(column, 0, Rows);
        }
    }
}

void SampleChunk::addColumn(std::size_t column, std::size_t rows, const ColumnSource& source,
                            std::size_t firstRow) {
    double* kept = m_detail->values.data() + column * Rows + m_rows;
    const double* values = source.values + firstRow * source.stride;
    const std::size_t stride = source.stride;
    double& reference = m_references[column];
    for (std::size_t row = 0; row < rows; ++row) {
        const double value = values[row * stride];
        kept[row] = std::isfinite(value) ? value : NaN;
        if (std::isnan(reference)) {
            reference = kept[row];
        }
    }
}

void SampleChunk::closeGroups(std::size_t column, std::size_t formerRows) {
    const double reference = std::isnan(m_references[column]) ? 0.0 : m_references[column];
    const double* values = m_detail->values.data() + column * Rows;
    FloatExtremes* lowest = m_detail->groups[0].data() + column * groupsOf(1);
    for (std::size_t index = formerRows / 4; index < m_rows / 4; ++index) {
        Extremes extremes;
        for (std::size_t row = 4 * index; row < 4 * index + 4; ++row) {
            extremes.add(values[row]);
        }
        lowest[index] = {static_cast<float>(extremes.min - reference),
                         static_cast<float>(extremes.max - reference)};
    }
    for (std::size_t level = 2; level <= Levels; ++level) {
        const FloatExtremes* finer = m_detail->groups[level - 2].data() + column * groupsOf(level - 1);
        FloatExtremes* groups = m_detail->groups[level - 1].data() + column * groupsOf(level);
        for (std::size_t index = formerRows >> (2 * level); index < m_rows >> (2 * level); ++index) {
            FloatExtremes merged = finer[4 * index];
            for (std::size_t i = 4 * index + 1; i < 4 * index + 4; ++i) {
                merged.min = std::min(merged.min, finer[i].min);
                merged.max = std::max(merged.max, finer[i].max);
            }
            groups[index] = merged;
        }
    }
}

double SampleChunk::time_s(std::size_t row) const {
    if (m_times_s != nullptr) {
        return m_times_s[row];
    }
    const auto* octets = m_pages->part(*m_page, TimePart, Rows * sizeof(double));
    if (octets != nullptr) {
        return reinterpret_cast<const double*>(octets)[row];
    }
    // The page is damaged, or not here yet. Values are missing, but time goes on: between the known times.
    const std::size_t mark = row / MarkRows;
    const double before_s = m_marks_s[mark];
    const std::size_t next = std::min((mark + 1) * MarkRows, Rows - 1);
    const auto part = static_cast<double>(row - mark * MarkRows);
    return before_s + (m_marks_s[mark + 1] - before_s) * part / static_cast<double>(next - mark * MarkRows);
}

const double* SampleChunk::values(std::size_t column) const {
    if (m_detail) {
        return m_detail->values.data() + column * Rows;
    }
    return reinterpret_cast<const double*>(m_pages->part(*m_page, valuePart(column), Rows * sizeof(double)));
}

double SampleChunk::value(std::size_t column, std::size_t row) const {
    const double* all = values(column);
    return all != nullptr ? all[row] : NaN;
}

Extremes SampleChunk::group(std::size_t column, std::size_t level, std::size_t index) const {
    if (std::isnan(m_references[column])) {
        return {};
    }
    const FloatExtremes* all = groups(column, level);
    if (all == nullptr) {
        return {};
    }
    return {m_references[column] + static_cast<double>(all[index].min),
            m_references[column] + static_cast<double>(all[index].max)};
}

const FloatExtremes* SampleChunk::groups(std::size_t column, std::size_t level) const {
    const std::size_t first = column * groupsOf(level);
    if (m_groups[level - 1] != nullptr) {
        return m_groups[level - 1] + first;
    }
    const auto* octets = m_pages->part(*m_page, groupPart(column, level), groupPartBytes(level, m_columns));
    const std::size_t skipped = level > LevelsPerColumn ? first : 0;
    return octets != nullptr ? reinterpret_cast<const FloatExtremes*>(octets) + skipped : nullptr;
}

bool SampleChunk::isPageAtHand(std::size_t column, std::size_t level) const {
    if (level == 0) {
        return m_pages->isAtHand(*m_page, valuePart(column), Rows * sizeof(double));
    }
    return m_pages->isAtHand(*m_page, groupPart(column, level), groupPartBytes(level, m_columns));
}

Moments SampleChunk::momentsOf(std::size_t column, std::size_t begin, std::size_t end) const {
    Moments moments;
    const double* all = values(column);
    for (std::size_t row = begin; row < end; ++row) {
        moments.add(all != nullptr ? all[row] : NaN);
    }
    return moments;
}

Moments SampleChunk::moments(std::size_t column, std::size_t begin, std::size_t end) const {
    return begin == 0 && end == Rows && isFull() ? m_moments[column] : momentsOf(column, begin, end);
}

void SampleChunk::putInto(const std::shared_ptr<PageCache>& pages) {
    HB_ASSERT(isFull() && !isPut());
    PageContent content;
    content.owner = m_detail;
    content.parts.push_back(std::as_bytes(std::span(m_detail->time_s)));
    for (std::size_t level = LevelsPerColumn + 1; level <= Levels; ++level) {
        content.parts.push_back(std::as_bytes(std::span(m_detail->groups[level - 1])));
    }
    for (std::size_t column = 0; column < m_columns; ++column) {
        content.parts.push_back(std::as_bytes(std::span(m_detail->values.data() + column * Rows, Rows)));
        content.parts.push_back(
            std::as_bytes(std::span(m_detail->groups[0].data() + column * groupsOf(1), groupsOf(1))));
    }
    m_pages = pages;
    m_page = pages->store().put(std::move(content));
}

bool SampleChunk::settle() {
    if (m_detail && m_page && m_pages->store().state(*m_page) == PageState::Kept) {
        for (std::size_t row = 0; row < Rows; row += MarkRows) {
            m_marks_s.push_back(m_detail->time_s[row]);
        }
        m_marks_s.push_back(m_detail->time_s[Rows - 1]);
        m_times_s = nullptr;
        m_groups.fill(nullptr);
        m_detail.reset();
    }
    return m_detail == nullptr;
}

} // namespace halbench::control
