#include "control/analysis/locus_gain.h"
#include "control/lti/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

/// K/(s (s + 2)): s^2 + 2 s + K; both poles real up to K = 1, then at -1 +- i sqrt(K - 1).
RootLocus secondOrder() {
    return *rootLocus(*TransferFunction::make({1.0}, {1.0, 2.0, 0.0}, TimeBase::continuous()), 20.0);
}

TEST(LocusGain, aPlaceOnABranchGivesTheGainOfItsPole) {
    const RootLocus locus = secondOrder();
    for (const double gain : {2.0, 5.0, 10.0}) {
        const std::complex<double> pole(-1.0, std::sqrt(gain - 1.0));
        const auto branch = branchAt(locus, gain, pole);
        ASSERT_TRUE(branch.has_value());
        // Straight lines between the points of the locus, whose steps are some hundredths of the way.
        EXPECT_NEAR(gainNearest(locus, *branch, pole), gain, 0.02 * gain);
        EXPECT_NEAR(gainNearest(locus, *branch, std::conj(pole)), gain, 0.02 * gain);
    }
}

TEST(LocusGain, aPlaceBesideABranchGivesTheNearestPoleOfIt) {
    const RootLocus locus = secondOrder();
    const auto branch = branchAt(locus, 5.0, {-1.0, 2.0});
    ASSERT_TRUE(branch.has_value());
    EXPECT_NEAR(gainNearest(locus, *branch, {0.5, 2.0}), 5.0, 0.1); // straight across: -1 + 2i
    EXPECT_DOUBLE_EQ(gainNearest(locus, *branch, {-1.0, 50.0}), locus.gain.back());
}

TEST(LocusGain, aLocusWithoutBranchesHasNone) {
    EXPECT_FALSE(branchAt({}, 1.0, {0.0, 0.0}).has_value());
}

} // namespace
} // namespace halbench::control
