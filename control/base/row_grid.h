#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace halbench {

/// Rows that were due in the step from the last row of one stream to the first row of the next, at the longer
/// of the two periods. The streams are not in phase: a step of half a period more counts none more, however
/// the stamps were rounded. A period of 0 or less: none.
std::uint64_t rowsMissingAtChange(double step_s, double period_s);

/// Counts the rows that are missing in a stream of an even rate, by its time stamps. A lost row shifts all
/// that follow; a stamp that is early or late (jitter) does not. The stamps are therefore compared with the
/// grid on which the rows before stand, and the shift counts that the rows behind have in common.
///
/// The grid follows the stamps as a phase-locked loop does, so that a period that is not quite the nominal
/// one loses nothing. Jitter of up to 0.45 periods on every stamp is no loss. Nor is a board that was held
/// up: its stamps are late, by however many periods, and catch up row by row. Only a shift that LookAhead
/// rows in a row have, without getting smaller, is a loss.
class RowGrid {
public:
    /// Rows behind the least shift that are needed to tell a loss from late stamps.
    static constexpr std::size_t LookAhead = 16;
    /// Rows behind a long step beyond which nobody waits for the late ones to catch up.
    static constexpr std::size_t MostAhead = 4096;

    /// A period of 0 or less: nothing is ever missing.
    explicit RowGrid(double period_s) : m_period_s(period_s) {}

    /// Rows missing directly before the first of `next_s`: the stamps of the row that comes and of those
    /// behind it, as far as they are known. Where none behind has the same shift (the end of a stream), only
    /// a step of a whole number of periods between stamps that are exact is a loss, unless something else
    /// tells that rows were lost (`isLossSure`).
    std::uint64_t missingBefore(std::span<const double> next_s, bool isLossSure = false) const;
    /// Whether rows behind these may yet show that the first stamp is only late; those of a board that stamps
    /// exactly are never in doubt on a whole number of periods. `lookAhead`: as LookAhead, less where nobody
    /// can wait so long.
    bool isInDoubt(std::span<const double> next_s, std::size_t lookAhead = LookAhead) const;
    /// The next row, before which so many are missing.
    void take(double time_s, std::uint64_t missing);

private:
    struct Shift { ///< least of the rows, in periods
        double missing = 0.0;
        std::size_t rowsBehind = 0; ///< that were looked at behind the row that has it
    };

    bool isExactLoss(double time_s) const;
    Shift leastShift(std::span<const double> next_s, std::size_t lookAhead) const;
    /// Periods from the place of the last row; 1 is that of the next.
    double placesAhead(double time_s) const { return (time_s - m_place_s) / m_period_s; }
    bool isLongStep(double time_s) const;

    double m_period_s;
    std::uint64_t m_rows = 0;
    double m_last_s = 0.0;        ///< stamp of the last row
    double m_place_s = 0.0;       ///< where it stands on the grid
    bool m_isLate = false;        ///< the last stamps are late and tell nothing of the grid
    double m_scatter_ratio = 0.0; ///< largest distance from the grid, in periods; fades
};

} // namespace halbench
