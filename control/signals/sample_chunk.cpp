#include "control/signals/sample_chunk.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::control {

constexpr std::size_t SampleChunk::firstGroup(std::size_t level) {
    std::size_t first = 0;
    for (std::size_t finer = 1; finer < level; ++finer) {
        first += Rows >> (2 * finer);
    }
    return first;
}

SampleChunk::SampleChunk(std::size_t columns)
    : m_columns(columns), m_time_s(Rows), m_values(Rows * columns),
      m_references(columns, std::numeric_limits<double>::quiet_NaN()), m_pyramid(Groups * columns),
      m_moments(columns) {}

std::size_t SampleChunk::bytesFor(std::size_t columns) {
    return sizeof(SampleChunk) + Rows * sizeof(double) * (1 + columns) +
           columns * (sizeof(double) + Groups * sizeof(FloatExtremes) + sizeof(Moments));
}

void SampleChunk::add(double time_s, const double* values) {
    HB_ASSERT(m_rows < Rows);
    m_time_s[m_rows] = time_s;
    for (std::size_t column = 0; column < m_columns; ++column) {
        m_values[column * Rows + m_rows] = values[column];
        if (std::isnan(m_references[column]) && std::isfinite(values[column])) {
            m_references[column] = values[column];
        }
    }
    ++m_rows;
    if (m_rows % 4 == 0) {
        for (std::size_t column = 0; column < m_columns; ++column) {
            closeGroups(column);
        }
    }
    if (m_rows == Rows) {
        for (std::size_t column = 0; column < m_columns; ++column) {
            m_moments[column] = momentsOf(column, 0, Rows);
        }
    }
}

Moments SampleChunk::momentsOf(std::size_t column, std::size_t begin, std::size_t end) const {
    Moments moments;
    for (std::size_t row = begin; row < end; ++row) {
        moments.add(value(column, row));
    }
    return moments;
}

Moments SampleChunk::moments(std::size_t column, std::size_t begin, std::size_t end) const {
    return begin == 0 && end == Rows && m_rows == Rows ? m_moments[column] : momentsOf(column, begin, end);
}

Extremes SampleChunk::lowestGroup(std::size_t column, std::size_t firstRow) const {
    Extremes extremes;
    for (std::size_t row = firstRow; row < firstRow + 4; ++row) {
        extremes.add(value(column, row));
    }
    return extremes;
}

void SampleChunk::closeGroups(std::size_t column) {
    const double reference = std::isnan(m_references[column]) ? 0.0 : m_references[column];
    FloatExtremes* pyramid = m_pyramid.data() + column * Groups;
    const Extremes lowest = lowestGroup(column, m_rows - 4);
    pyramid[m_rows / 4 - 1] = {static_cast<float>(lowest.min - reference),
                               static_cast<float>(lowest.max - reference)};
    for (std::size_t level = 2; level <= Levels && m_rows % (std::size_t{1} << (2 * level)) == 0; ++level) {
        const std::size_t index = (m_rows >> (2 * level)) - 1;
        const FloatExtremes* finer = pyramid + firstGroup(level - 1) + 4 * index;
        FloatExtremes merged = finer[0];
        for (std::size_t i = 1; i < 4; ++i) {
            merged.min = std::min(merged.min, finer[i].min);
            merged.max = std::max(merged.max, finer[i].max);
        }
        pyramid[firstGroup(level) + index] = merged;
    }
}

Extremes SampleChunk::group(std::size_t column, std::size_t level, std::size_t index) const {
    if (std::isnan(m_references[column])) {
        return {};
    }
    const FloatExtremes& relative = m_pyramid[column * Groups + firstGroup(level) + index];
    return {m_references[column] + static_cast<double>(relative.min),
            m_references[column] + static_cast<double>(relative.max)};
}

} // namespace halbench::control
