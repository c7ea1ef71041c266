#include "control/base/random.h"
#include "control/base/row_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace halbench {
namespace {

constexpr double Period_s = 1e-3;

/// What a reader that has all stamps finds.
std::uint64_t lostOf(const std::vector<double>& time_s, double period_s = Period_s) {
    RowGrid grid(period_s);
    std::uint64_t lost = 0;
    for (std::size_t row = 0; row < time_s.size(); ++row) {
        const std::uint64_t missing = grid.missingBefore(std::span(time_s).subspan(row));
        grid.take(time_s[row], missing);
        lost += missing;
    }
    return lost;
}

template <typename Stamp>
std::vector<double> stampsOf(std::size_t rows, Stamp stamp) {
    std::vector<double> time_s;
    for (std::size_t row = 0; row < rows; ++row) {
        time_s.push_back(Period_s * stamp(row));
    }
    return time_s;
}

TEST(RowGrid, aStampThatIsLateLosesNothing) {
    for (const double late : {0.55, 0.6, 0.8, 0.95}) {
        const auto time_s = stampsOf(
            4000, [&](std::size_t row) { return static_cast<double>(row) + (row % 20 == 7 ? late : 0.0); });
        EXPECT_EQ(lostOf(time_s), 0U) << late;
    }
}

TEST(RowGrid, aBurstOfRowsThatWereAllStampedLateLosesNothing) {
    // The stamps of rows 50 to 53 are made when the fourth of them was there, 10 us apart.
    const auto time_s = stampsOf(200, [](std::size_t row) {
        return row >= 50 && row <= 53 ? 53.5 + 0.01 * static_cast<double>(row - 50)
                                      : static_cast<double>(row);
    });
    EXPECT_EQ(lostOf(time_s), 0U);
}

TEST(RowGrid, jitterOfAThirdOfAPeriodLosesNothingAndHidesNoLoss) {
    Random random(3);
    std::vector<double> time_s;
    std::uint64_t lost = 0;
    for (int row = 0; row < 5000; ++row) {
        if (row > 50 && row < 4990 && random.below(20) == 0) { // the last rows have none behind that tell
            ++lost;
        } else {
            time_s.push_back(Period_s * (row + 0.6 * random.uniform() - 0.3));
        }
    }
    // The grid's phase is known to 0.05 periods (eight rows of sigma 0.17), so that 0.3 + 0.05 < 0.5.
    EXPECT_EQ(lostOf(time_s), lost);
}

TEST(RowGrid, rowsThatAreMissingAreCountedExactlyHoweverMany) {
    EXPECT_EQ(lostOf({0.0, 0.001, 0.004, 0.005, 0.007}), 3U);
    EXPECT_EQ(lostOf({0.0, 0.001, 0.5}), 498U);
    Random random(4);
    std::vector<double> time_s;
    std::uint64_t lost = 0;
    for (int row = 0; row < 2000; ++row) {
        if (row > 0 && row < 1999 && random.uniform() < 0.4) {
            ++lost;
        } else {
            time_s.push_back(Period_s * row);
        }
    }
    EXPECT_EQ(lostOf(time_s), lost);
}

TEST(RowGrid, aPeriodThatIsNotTheNominalOneLosesNothing) {
    for (const double ratio : {0.8, 0.97, 1.03, 1.2}) {
        EXPECT_EQ(lostOf(stampsOf(3000, [&](std::size_t row) { return ratio * static_cast<double>(row); })),
                  0U)
            << ratio;
    }
}

TEST(RowGrid, withoutAPeriodOrBeforeTheFirstRowNothingIsMissing) {
    EXPECT_EQ(lostOf({0.0, 100.0}, 0.0), 0U);
    EXPECT_EQ(lostOf({}), 0U);
    EXPECT_EQ(RowGrid(1.0).missingBefore(std::vector<double>{5.0}), 0U);
}

TEST(RowGrid, aBoardThatIsHeldUpAndCatchesUpLosesNothing) {
    // A task that sleeps until its next moment, on a processor that others use: it is held up now and then,
    // for up to a hundred periods, and stamps the rows that are due then at once, 20 us apart.
    for (const double hold_periods : {0.7, 1.5, 3.0, 3.01, 12.4, 100.0}) {
        Random random(static_cast<std::uint64_t>(10.0 * hold_periods));
        const auto rows_a_hold =
            static_cast<std::uint64_t>(20.0 + 3.0 * hold_periods); // it keeps up on the whole
        double now = 0.0;
        const auto time_s = stampsOf(6000, [&](std::size_t row) {
            now = std::max(now + 0.02, static_cast<double>(row));
            now += random.below(rows_a_hold) == 0 ? hold_periods * random.uniform() : 0.0;
            return now;
        });
        EXPECT_EQ(lostOf(time_s), 0U) << hold_periods;
    }
}

TEST(RowGrid, rowsThatAHeldUpBoardLeavesOutAreCounted) {
    // As before, but after each hold-up the board goes on with the row that is due and leaves out the others.
    Random random(8);
    std::vector<double> time_s;
    std::uint64_t lost = 0;
    for (int row = 0; row < 6000; ++row) {
        time_s.push_back(Period_s * (row + 0.1 * random.uniform()));
        if (row > 20 && row < 5960 && random.below(60) == 0) {
            const int left = 1 + static_cast<int>(random.below(12));
            lost += static_cast<std::uint64_t>(left);
            row += left;
        }
    }
    EXPECT_EQ(lostOf(time_s), lost);
}

/// A grid of period 1 up to row 0, whose stamps were so far off.
RowGrid gridWith(double scatter) {
    RowGrid grid(1.0);
    for (int row = -40; row <= 0; ++row) {
        grid.take(row + (row < 0 && row % 2 == 0 ? scatter : 0.0), 0);
    }
    return grid;
}

TEST(RowGrid, aLongStepIsInDoubtUntilSixteenRowsHaveItsShift) {
    const RowGrid grid = gridWith(0.05);
    EXPECT_FALSE(RowGrid(1.0).isInDoubt(std::vector<double>{7.0})) << "the first row";
    EXPECT_FALSE(grid.isInDoubt(std::vector<double>{1.2}));
    std::vector<double> next_s{3.0};
    for (std::size_t behind = 0; behind < RowGrid::LookAhead; ++behind) {
        EXPECT_TRUE(grid.isInDoubt(next_s)) << behind;
        next_s.push_back(next_s.back() + 1.0);
    }
    EXPECT_FALSE(grid.isInDoubt(next_s));
    EXPECT_EQ(grid.missingBefore(next_s), 2U);
    EXPECT_FALSE(grid.isInDoubt(std::vector<double>{3.0, 3.1, 3.2}))
        << "caught up: row 3 is there at its time";
    EXPECT_EQ(grid.missingBefore(std::vector<double>{3.0, 3.1, 3.2}), 0U);
}

TEST(RowGrid, ofATimerThatStampsExactlyAWholeStepIsALossAtOnce) {
    EXPECT_FALSE(gridWith(0.0).isInDoubt(std::vector<double>{3.0}));
    EXPECT_EQ(gridWith(0.0).missingBefore(std::vector<double>{3.0}), 2U);
    EXPECT_TRUE(gridWith(0.0).isInDoubt(std::vector<double>{3.3}));
    EXPECT_TRUE(gridWith(0.05).isInDoubt(std::vector<double>{3.0}))
        << "a late stamp may stand there by chance";
}

TEST(RowGrid, atTheEndOnlyAnExactStepIsALoss) {
    EXPECT_EQ(gridWith(0.0).missingBefore(std::vector<double>{3.4}), 0U);
    EXPECT_EQ(gridWith(0.05).missingBefore(std::vector<double>{3.0}), 0U);
    EXPECT_EQ(gridWith(0.05).missingBefore(std::vector<double>{3.0, 4.0}), 2U)
        << "the next has the same shift";
    EXPECT_EQ(gridWith(0.05).missingBefore(std::vector<double>{3.0}, true), 2U) << "the transport says so";
}

} // namespace
} // namespace halbench
