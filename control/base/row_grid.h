#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace halbench {

/// Counts the rows that are missing in a stream of an even rate, by its time stamps. A lost row shifts all
/// that follow; a stamp that is early or late (jitter) does not. The stamps are therefore compared with the
/// grid on which the rows before stand, and the shift counts that the rows behind have in common.
///
/// The grid follows the stamps as a phase-locked loop does, so that a period that is not quite the nominal
/// one loses nothing. Jitter of up to 0.45 periods on every stamp and single stamps that are late by up to
/// LookAhead periods are no loss.
class RowGrid {
public:
    /// Rows behind a long step that are needed to tell a loss from a late stamp.
    static constexpr std::size_t LookAhead = 4;

    /// A period of 0 or less: nothing is ever missing.
    explicit RowGrid(double period_s) : m_period_s(period_s) {}

    /// Rows missing directly before the first of `next_s`: the stamps of the row that comes and of those
    /// behind it, as far as they are known (LookAhead of them are used).
    std::uint64_t missingBefore(std::span<const double> next_s) const;
    /// Whether rows behind this one may yet show that its stamp is only late: the step is long, and no whole
    /// number of periods.
    bool isInDoubt(double time_s) const;
    /// The next row, before which so many are missing.
    void take(double time_s, std::uint64_t missing);

private:
    /// Periods from the place of the last row; 1 is that of the next.
    double placesAhead(double time_s) const { return (time_s - m_place_s) / m_period_s; }
    bool isLongStep(double time_s) const;

    double m_period_s;
    std::uint64_t m_rows = 0;
    double m_last_s = 0.0;  ///< stamp of the last row
    double m_place_s = 0.0; ///< where it stands on the grid
};

} // namespace halbench
