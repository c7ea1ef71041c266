#pragma once

#include "control/base/block_columns.h"
#include "control/history/extremes.h"
#include "control/history/page_cache.h"
#include "control/signals/moments.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace halbench::control {

/// Relative to the first value of the column.
struct FloatExtremes {
    float min;
    float max;
};

/// A stretch of rows of one stream with the extremes of every 4, 16 and 64 rows (the fine levels of a pyramid
/// of radix 4), kept up to date while rows are added. The pyramid holds floats relative to the column's first
/// value, so that a large constant part costs no resolution; with the levels above it (SampleTrack) it takes
/// a third of the memory of the values.
///
/// A full chunk can be kept as a page of a store: then rows and groups are read back when they are asked for,
/// column by column, and only every 64th time stays in memory. What cannot be read back has no value.
class SampleChunk {
public:
    static constexpr std::size_t Levels = 3;
    static constexpr std::size_t Rows = 4096;
    static constexpr std::size_t MarkRows = 64; ///< rows between times that stay in memory

    explicit SampleChunk(std::size_t columns);
    ~SampleChunk();
    SampleChunk(const SampleChunk&) = delete;
    SampleChunk& operator=(const SampleChunk&) = delete;

    /// Rows of `columns` from `firstRow` on; what is not finite is kept as NaN. Precondition: no more than
    /// `Rows` rows in all.
    void add(std::span<const double> time_s, std::span<const ColumnSource> columns, std::size_t firstRow);

    std::size_t rows() const { return m_rows; }
    bool isFull() const { return m_rows == Rows; }
    static std::size_t bytesFor(std::size_t columns);      ///< all of it in memory, with its upper groups
    static std::size_t pagedBytesFor(std::size_t columns); ///< what stays when its detail does not

    double time_s(std::size_t row) const;
    /// Of a row that is a multiple of MarkRows; never reads anything back.
    double markedTime_s(std::size_t row) const {
        return m_times_s != nullptr ? m_times_s[row] : m_marks_s[row / MarkRows];
    }
    double value(std::size_t column, std::size_t row) const;
    /// Whether the values of a column (level 0), or its groups, are answered without waiting for the store;
    /// in a glance what is not is asked for.
    bool isAtHand(std::size_t column, std::size_t level) const {
        return m_groups[0] != nullptr || isPageAtHand(column, level); // asked for every group of a frame
    }
    /// Extremes of the complete group `index` of 4^level rows, level 1 ... Levels.
    Extremes group(std::size_t column, std::size_t level, std::size_t index) const;
    /// Of the rows [begin, end); all rows of a full chunk at no cost.
    Moments moments(std::size_t column, std::size_t begin, std::size_t end) const;

    /// Puts the detail into the store of the cache, which has room for it. Precondition: full, not put yet.
    void putInto(const std::shared_ptr<PageCache>& pages);
    bool isPut() const { return m_page.has_value(); }
    /// Forgets the detail when the store has it. Whether it is forgotten.
    bool settle();
    /// Size of the page.
    static std::size_t detailBytesFor(std::size_t columns);

private:
    static constexpr std::size_t groupsOf(std::size_t level) { return Rows >> (2 * level); }
    /// What a page holds.
    struct Detail {
        std::vector<double> time_s;
        std::vector<double> values;                            ///< column by column
        std::array<std::vector<FloatExtremes>, Levels> groups; ///< by level, column by column
    };

    const FloatExtremes* groups(std::size_t column, std::size_t level) const;
    bool isPageAtHand(std::size_t column, std::size_t level) const;
    void addColumn(std::size_t column, std::size_t rows, const ColumnSource& source, std::size_t firstRow);
    void closeGroups(std::size_t column, std::size_t formerRows);
    const double* values(std::size_t column) const;
    Moments momentsOf(std::size_t column, std::size_t begin, std::size_t end) const;

    std::size_t m_columns;
    std::size_t m_rows = 0;
    std::shared_ptr<Detail> m_detail;
    const double* m_times_s = nullptr; ///< in the detail, as long as it is here; a step less than through it
    std::array<const FloatExtremes*, Levels> m_groups{}; ///< likewise
    std::vector<double> m_references;                    ///< first value of each column that is finite
    std::vector<Moments> m_moments;                      ///< per column, of a full chunk
    std::vector<double> m_marks_s; ///< when the detail is elsewhere: every MarkRows-th time and the last
    std::optional<PageStore::Page> m_page;
    std::shared_ptr<PageCache> m_pages;
};

} // namespace halbench::control
