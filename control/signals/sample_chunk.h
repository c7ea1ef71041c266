#pragma once

#include "control/signals/extremes.h"
#include "control/signals/moments.h"

#include <array>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// A stretch of rows of one stream with the extremes of every 4, 16, 64, ... rows (a pyramid of radix 4),
/// kept up to date while rows are added. The pyramid holds floats relative to the column's first value, so
/// that a large constant part costs no resolution; it takes a third of the memory of the values.
class SampleChunk {
public:
    static constexpr std::size_t Levels = 6;
    static constexpr std::size_t Rows = std::size_t{1} << (2 * Levels); ///< 4096

    explicit SampleChunk(std::size_t columns);

    /// `values`: one row, as many as there are columns. Precondition: fewer than `Rows` rows are held.
    void add(double time_s, const double* values);

    std::size_t rows() const { return m_rows; }
    std::size_t bytes() const { return bytesFor(m_columns); }
    static std::size_t bytesFor(std::size_t columns);

    double time_s(std::size_t row) const { return m_time_s[row]; }
    double value(std::size_t column, std::size_t row) const { return m_values[column * Rows + row]; }
    /// Extremes of the complete group `index` of 4^level rows, level 1 ... Levels.
    Extremes group(std::size_t column, std::size_t level, std::size_t index) const;
    /// Of the rows [begin, end); all rows of a full chunk at no cost.
    Moments moments(std::size_t column, std::size_t begin, std::size_t end) const;

private:
    struct FloatExtremes {
        float min;
        float max;
    };
    static constexpr std::size_t Groups = (Rows - 1) / 3; ///< 1024 + 256 + ... + 1
    static constexpr std::size_t firstGroup(std::size_t level);

    void closeGroups(std::size_t column);
    Moments momentsOf(std::size_t column, std::size_t begin, std::size_t end) const;
    Extremes lowestGroup(std::size_t column, std::size_t firstRow) const;

    std::size_t m_columns;
    std::size_t m_rows = 0;
    std::vector<double> m_time_s;
    std::vector<double> m_values;         ///< column by column
    std::vector<double> m_references;     ///< first value of each column that is finite
    std::vector<FloatExtremes> m_pyramid; ///< column by column, levels from fine to coarse
    std::vector<Moments> m_moments;       ///< per column, of a full chunk
};

} // namespace halbench::control
