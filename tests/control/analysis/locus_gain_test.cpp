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

// s^2 + 2 s + K: the gain of a pole at -1 + i b is 1 + b^2; nearest to a place beside it is the one straight
// across. The search ends in the rounding of a distance, 1e-8 of the way for a place beside the branch.
TEST(LocusGain, theGainOfAPoleIsSolvedAndNotRead) {
    const LocusLoop loop = loopThrough({}, {0.0, -2.0}, {-1.0, 2.0}); // K = 5 there
    EXPECT_DOUBLE_EQ(loop.gain, 5.0);
    const RootLocus ofFive =
        *rootLocus(*TransferFunction::make({5.0}, {1.0, 2.0, 0.0}, TimeBase::continuous()), 4.0);
    for (const double height : {0.3, 1.0, 2.0, 3.3, 4.1}) {
        const double gain = 1.0 + height * height;
        const auto branch = branchAt(ofFive, gain / 5.0, {-1.0, height});
        ASSERT_TRUE(branch);
        for (const double beside : {0.0, 0.4}) {
            const double solved = 5.0 * solvedGainNearest(ofFive, *branch, {-1.0 + beside, -height}, loop);
            EXPECT_NEAR(solved, gain, 1e-6 * gain) << height << " " << beside;
        }
    }
    // On the real axis, before the poles meet at K = 1: s (s + 2) = -K.
    for (const double place : {-0.2, -0.6, -0.9}) {
        const auto branch = branchAt(ofFive, -place * (place + 2.0) / 5.0, {place, 0.0});
        EXPECT_NEAR(5.0 * solvedGainNearest(ofFive, *branch, {place, 0.0}, loop), -place * (place + 2.0),
                    1e-6);
    }
}

// The motor's own loop: four poles in the z plane, one of them at zero from a sample of delay.
TEST(LocusGain, aPoleOfASampledLoopIsReachedToAMillionth) {
    const auto openLoop =
        TransferFunction::make({0.02, -0.0185}, {1.0, -1.97, 0.97, 0.0}, TimeBase::sampled(0.01));
    ASSERT_TRUE(openLoop);
    const RootLocus locus = *rootLocus(*openLoop, 4.0);
    const auto closed = [&](double gain) { // second route: the roots of the polynomial
        return poles(*feedback(*series(TransferFunction::gain(gain, openLoop->timeBase()), *openLoop),
                               TransferFunction::gain(1.0, openLoop->timeBase())));
    };
    const LocusLoop loop = loopThrough(zeros(*openLoop), poles(*openLoop), closed(1.0).front());
    for (const double gain : {0.3, 0.8, 1.7, 3.1}) {
        for (const std::complex<double>& pole : closed(gain)) {
            const auto branch = branchAt(locus, gain, pole);
            EXPECT_NEAR(solvedGainNearest(locus, *branch, pole, loop), gain, 1e-6 * gain);
        }
    }
}

TEST(LocusGain, aLocusWithoutBranchesHasNone) {
    EXPECT_FALSE(branchAt({}, 1.0, {0.0, 0.0}).has_value());
}

} // namespace
} // namespace halbench::control
