#include "models/spherical/coverage/placement_search.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

TEST(PlacementLattice, bestOfFiveDegreesReachesTheKnownReadingAndIsProven) {
    const PlacementSearch search = *searchPlacement({});
    EXPECT_TRUE(search.proof.isProven());
    EXPECT_GT(search.proof.bound_T(), 0.038);
    EXPECT_GT(search.pairs, 80000000U);
}

TEST(PlacementLattice, additiveDeviceIsPlacedAsWellAsKnown) {
    PlacementSearchConfig config;
    config.device.device = SphericalDevice::Additive;
    config.finalists = 2000; // the coarse poses tell less about it
    const PlacementSearch search = *searchPlacement(config);
    EXPECT_TRUE(search.proof.isProven());
    // 0.0229 T is known; coarse poses choose the finalists, which may cost a few per cent.
    EXPECT_GT(search.best.least_T, 0.95 * 0.0229);
}

} // namespace
} // namespace halbench::models
