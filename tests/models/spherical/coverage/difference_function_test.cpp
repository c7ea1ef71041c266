#include "tests/models/spherical/coverage/difference_table.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

double valueAt(DifferenceFunction function, const DifferenceRow& row, const PlacementAngles& placement) {
    PlacementDevice device;
    device.device = SphericalDevice::Additive;
    const PoseGrid one{{placement.alpha_rad, 0, 1}, {placement.beta_rad, 0, 1}, {placement.gamma_rad, 0, 1}};
    const auto values =
        *differenceValues(device, function, publishedPlacement()[1], one, workspaceGrid(degreesToRadians(5)));
    const DifferenceRanking ranking = *rankDifference(values, one, row.isAbsolute, row.reduction, placement);
    EXPECT_EQ(ranking.rank, 1);
    EXPECT_EQ(ranking.best_T2, ranking.claimed_T2);
    return ranking.claimed_T2;
}

// The whole lattice with ties and ranks is searched at night.
TEST(DifferenceFunction, hasTheValuesOfTheTableAtItsPlacements) {
    for (const DifferenceFunction function : {DifferenceFunction::First, DifferenceFunction::Second}) {
        const bool isFirst = function == DifferenceFunction::First;
        for (const DifferenceRow& row : isFirst ? FirstRows : SecondRows) {
            const auto angle = [&](std::size_t k) {
                return degreesToRadians(row.where_deg[k] == Any ? 10.0 : row.where_deg[k]);
            };
            EXPECT_NEAR(valueAt(function, row, {angle(0), angle(1), angle(2)}), row.best, 2e-4);
            EXPECT_NEAR(valueAt(function, row, publishedPlacement()[isFirst ? 1 : 2]), row.claimed, 2e-4);
        }
    }
}

TEST(DifferenceFunction, claimedPlacementMustBeOnTheLattice) {
    const PoseGrid lattice = placementLattice(degreesToRadians(45));
    const auto values =
        *differenceValues({}, DifferenceFunction::First, {}, lattice, workspaceGrid(degreesToRadians(45)));
    EXPECT_EQ(rankDifference(values, lattice, false, DifferenceReduction::Mean, {0.1, 0, 0}).error().code,
              ErrorCode::OutOfRange);
    WorkControl stopped;
    stopped.isStopped = [] { return true; };
    EXPECT_EQ(differenceValues({}, DifferenceFunction::First, {}, lattice, lattice, stopped).error().code,
              ErrorCode::Interrupted);
}

} // namespace
} // namespace halbench::models
