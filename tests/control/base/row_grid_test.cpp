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
        const std::size_t known = std::min(time_s.size() - row, RowGrid::LookAhead + 1);
        const std::uint64_t missing = grid.missingBefore(std::span(time_s).subspan(row, known));
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
        if (row > 50 && random.below(20) == 0) {
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

TEST(RowGrid, onlyALongStepThatIsNoWholeNumberOfPeriodsIsInDoubt) {
    RowGrid grid(1.0);
    EXPECT_FALSE(grid.isInDoubt(7.0)) << "the first row";
    grid.take(0.0, 0);
    EXPECT_FALSE(grid.isInDoubt(1.2));
    EXPECT_TRUE(grid.isInDoubt(1.7));
    EXPECT_FALSE(grid.isInDoubt(2.0)) << "a stamp on the grid is behind a loss";
    EXPECT_FALSE(grid.isInDoubt(5.0));
    EXPECT_TRUE(grid.isInDoubt(5.3));
}

} // namespace
} // namespace halbench
