#include "app/session/row_selection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace halbench::app {

namespace {

/// Distances of rows that differ by less than this are the same rate.
constexpr double SameRate_ratio = 1e-6;
/// A row so near to its place, in periods, continues the rows before.
constexpr double InStep_ratio = 0.02;

} // namespace

RowSelection::RowSelection(std::shared_ptr<const StreamLayout> layout, std::optional<double> end_s)
    : m_layout(std::move(layout)), m_end_s(end_s), m_step_s(m_layout->period_s), m_grid(m_step_s) {}

void RowSelection::follow(const SampleBlock& block) {
    m_sourceRow += block.lostRows;
    m_isNewGrid = m_isNewGrid || block.isBreak || m_source != block.layout;
    if (m_source == block.layout) {
        return;
    }
    m_source = block.layout;
    m_sourceRow = 0;
    m_columns.clear();
    for (const StreamLayout::Column& column : m_layout->columns) {
        m_columns.push_back(m_source->indexOf(column.name));
    }
    const bool hasRate = m_source->period_s > 0.0;
    const double ratio = hasRate ? m_layout->period_s / m_source->period_s : 1.0;
    m_stride = static_cast<std::size_t>(std::max(1.0, std::round(ratio)));
}

std::vector<std::size_t> RowSelection::rowsToKeep(const TimedBlock& block) {
    std::vector<std::size_t> rows;
    double last_s = m_first_s ? m_last_s : -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < block.rows(); ++row) {
        const double time_s = block.time_s(row);
        const bool isBeyond = m_end_s && time_s >= *m_end_s;
        if (m_sourceRow++ % m_stride == 0 && time_s > last_s && !isBeyond) {
            rows.push_back(row);
            last_s = time_s;
        }
    }
    return rows;
}

/// Rows that were due between the last one of a stream and this first one of the next.
std::uint64_t RowSelection::missingAtChange(double time_s) const {
    if (m_rates.empty()) {
        return 0;
    }
    return rowsMissingAtChange(time_s - m_last_s, std::max(m_step_s, m_rates.back().period_s));
}

/// Whether this row comes one period after the last, at the same distance of rows.
bool RowSelection::isInStep(double time_s) const {
    const bool isSame =
        !m_rates.empty() && std::abs(m_rates.back().period_s - m_step_s) <= SameRate_ratio * m_step_s;
    return isSame && std::abs(time_s - m_last_s - m_step_s) <= InStep_ratio * m_step_s;
}

void RowSelection::noteRate(double time_s) {
    if (!isInStep(time_s)) {
        m_rates.push_back({time_s - *m_first_s, m_step_s});
    }
}

void RowSelection::append(SampleBlock& rows, const TimedBlock& block, std::size_t row) const {
    rows.time_s.push_back(block.time_s(row) - *m_first_s);
    for (const int column : m_columns) {
        rows.values.push_back(column < 0 ? std::numeric_limits<double>::quiet_NaN()
                                         : block.block->value(row, static_cast<std::size_t>(column)));
    }
}

void RowSelection::beginGrid(double time_s) {
    m_isNewGrid = false;
    m_step_s =
        m_source->period_s > 0.0 ? static_cast<double>(m_stride) * m_source->period_s : m_layout->period_s;
    m_grid = RowGrid(m_step_s);
    m_first_s = m_first_s ? m_first_s : time_s;
}

/// Before the first of these. The stream counts what it lost; a board that is held up sends rows late and
/// loses none. Where nothing was counted, only a step of whole periods between exact stamps is a gap.
std::uint64_t RowSelection::takeTime(std::span<const double> next_s, bool isLossSure) {
    const std::uint64_t missing = m_grid.missingBefore(isLossSure ? next_s : next_s.first(1), isLossSure);
    m_grid.take(next_s.front(), missing);
    return missing;
}

std::vector<SampleBlock> RowSelection::take(const TimedBlock& block, bool isAfterDrop) {
    follow(*block.block);
    const bool isAfterLoss = isAfterDrop || block.block->lostRows > 0;
    const std::vector<std::size_t> rows = rowsToKeep(block);
    std::vector<double> times_s;
    std::ranges::transform(rows, std::back_inserter(times_s),
                           [&](std::size_t row) { return block.time_s(row); });
    std::vector<SampleBlock> parts;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool isChange = m_isNewGrid;
        if (isChange) {
            beginGrid(times_s[i]);
        }
        std::uint64_t missing = takeTime(std::span(times_s).subspan(i), i == 0 && isAfterLoss);
        if (isChange) {
            missing = i == 0 && block.block->isBreak ? 0 : missingAtChange(times_s[i]);
            noteRate(times_s[i]);
        }
        if (parts.empty() || missing > 0) {
            parts.emplace_back();
            parts.back().layout = m_layout;
            parts.back().lostRows = missing;
            parts.back().isBreak = block.block->isBreak && i == 0;
        }
        m_last_s = times_s[i];
        append(parts.back(), block, rows[i]);
    }
    return parts;
}

std::vector<RateChange> RowSelection::rates() const {
    return m_rates.size() > 1 ? m_rates : std::vector<RateChange>();
}

} // namespace halbench::app
