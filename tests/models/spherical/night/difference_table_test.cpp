#include "tests/models/spherical/coverage/difference_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

void expectRows(DifferenceFunction function, const PlacementAngles& claimed,
                const std::vector<DifferenceRow>& rows) {
    PlacementDevice device;
    device.device = SphericalDevice::Additive;
    const PoseGrid lattice = placementLattice(degreesToRadians(5));
    const auto values = *differenceValues(device, function, publishedPlacement()[1], lattice,
                                          workspaceGrid(degreesToRadians(5)));
    EXPECT_EQ(values.size(), 13357U);
    for (const DifferenceRow& row : rows) {
        const DifferenceRanking ranking =
            *rankDifference(values, lattice, row.isAbsolute, row.reduction, claimed);
        EXPECT_NEAR(ranking.best_T2, row.best, 2e-4);
        EXPECT_NEAR(ranking.claimed_T2, row.claimed, 2e-4);
        bool isThere = false;
        for (const PlacementAngles& at : ranking.bestAt) {
            const std::array<double, 3> is_deg = {radiansToDegrees(at.alpha_rad),
                                                  radiansToDegrees(at.beta_rad),
                                                  radiansToDegrees(at.gamma_rad)};
            bool isSame = true;
            for (std::size_t k = 0; k < 3; ++k) {
                isSame = isSame && (row.where_deg[k] == Any || std::abs(is_deg[k] - row.where_deg[k]) < 1e-6);
            }
            isThere = isThere || isSame;
        }
        EXPECT_TRUE(isThere) << row.best;
        if (row.ties > 0) {
            EXPECT_EQ(ranking.bestAt.size(), row.ties) << row.best;
        }
        if (row.rank > 0) {
            EXPECT_EQ(ranking.rank, row.rank) << row.best;
        }
    }
}

TEST(DifferenceTable, firstFunctionHasItsMaximaTiesAndRanks) {
    expectRows(DifferenceFunction::First, publishedPlacement()[1], FirstRows);
}

TEST(DifferenceTable, secondFunctionHasItsMaximaTiesAndRanks) {
    expectRows(DifferenceFunction::Second, publishedPlacement()[2], SecondRows);
}

} // namespace
} // namespace halbench::models
