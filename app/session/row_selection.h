#pragma once

#include "control/base/row_grid.h"
#include "control/base/sample_block.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace halbench::app {

/// Rows of a stream that a file of fixed columns and a fixed rate takes. A stream of more rows is thinned,
/// one of fewer rows gives the rows that it has (rates()); a signal that does not come is NaN. What is
/// missing is counted in rows of the stream as it was thinned.
class RowSelection {
public:
    /// `end_s`: no row from then on, on the clock of the blocks.
    RowSelection(std::shared_ptr<const StreamLayout> layout, std::optional<double> end_s);

    /// The rows to keep, on the axis of the file, split before every gap: a block of the file follows its
    /// gap. `isAfterDrop`: rows of the stream were dropped directly before.
    std::vector<SampleBlock> take(const TimedBlock& block, bool isAfterDrop = false);

    /// First and last row, on the clock of the blocks.
    std::optional<double> first_s() const { return m_first_s; }
    double last_s() const { return m_last_s; }
    /// Distance of the rows that are kept now.
    double step_s() const { return m_step_s; }
    /// On the axis of the file: where rows of another distance begin, or rows that are out of step with those
    /// before. Empty where neither happened.
    std::vector<RateChange> rates() const;

private:
    void follow(const SampleBlock& block);
    std::vector<std::size_t> rowsToKeep(const TimedBlock& block);
    void beginGrid(double time_s);
    std::uint64_t takeTime(std::span<const double> next_s, bool isLossSure);
    std::uint64_t missingAtChange(double time_s) const;
    bool isInStep(double time_s) const;
    void noteRate(double time_s);
    void append(SampleBlock& rows, const TimedBlock& block, std::size_t row) const;

    const std::shared_ptr<const StreamLayout> m_layout;
    const std::optional<double> m_end_s;

    std::shared_ptr<const StreamLayout> m_source; ///< of the newest block
    std::vector<int> m_columns;                   ///< of the source, by column here; -1: does not come
    std::size_t m_stride = 1;                     ///< one of so many rows of the source is kept
    std::uint64_t m_sourceRow = 0;
    double m_step_s;
    RowGrid m_grid; ///< of the rows that are kept
    bool m_isNewGrid = true;
    std::optional<double> m_first_s;
    double m_last_s = 0.0;
    std::vector<RateChange> m_rates;
};

} // namespace halbench::app
