#include "models/drives/dac.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

constexpr double AmplifierGain_A_per_V = 2.0;

TEST(Dac, oneCodeIsTheQuotedCurrentStep) {
    const DacConfig dac;
    EXPECT_NEAR(dacStep_V(dac), 1.2207e-3, 5e-8);
    EXPECT_NEAR(AmplifierGain_A_per_V * dacStep_V(dac), 2.4414e-3, 5e-8);
}

TEST(Dac, fourAmperesUseTheQuotedCodes) {
    const DacConfig dac;
    EXPECT_EQ(nearestDacCode(dac, -4.0 / AmplifierGain_A_per_V), 410);
    EXPECT_EQ(nearestDacCode(dac, 4.0 / AmplifierGain_A_per_V), 3686);
    EXPECT_EQ(nearestDacCode(dac, 0.0), 2048);
    EXPECT_EQ(dacOutput_V(dac, 2048.0), 0.0);
    // Full scale is +-5 A.
    EXPECT_EQ(AmplifierGain_A_per_V * dacOutput_V(dac, 0.0), -5.0);
}

TEST(Dac, roundsToNearestAndClips) {
    const DacConfig dac;
    for (int code = 0; code < 4096; code += 13) {
        EXPECT_EQ(nearestDacCode(dac, dacOutput_V(dac, code + 0.49)), code);
    }
    EXPECT_EQ(nearestDacCode(dac, 9.0), 4095);
    EXPECT_EQ(nearestDacCode(dac, -9.0), 0);
    EXPECT_NEAR(dacOutput_V(dac, exactDacCode(dac, 1.2345)), 1.2345, 1e-15);
}

TEST(Dac, nonLinearityStaysWithinItsCountsAndVanishesAtMidScale) {
    DacConfig dac;
    const DacConfig perfect = dac;
    dac.integralNonLinearity_codes = 2.0;
    double worst_codes = 0.0;
    for (int code = 0; code < 4096; ++code) {
        const double error_V = dacOutput_V(dac, code) - dacOutput_V(perfect, code);
        worst_codes = std::fmax(worst_codes, std::abs(error_V) / dacStep_V(dac));
    }
    EXPECT_NEAR(worst_codes, 2.0, 1e-9); // reached at a quarter of the scale, code 1024
    EXPECT_NEAR(dacOutput_V(dac, 2048.0), 0.0, 1e-15);
}

TEST(Dac, gainErrorScalesTheUnipolarOutput) {
    DacConfig dac;
    dac.gainError_ratio = 0.004;
    EXPECT_NEAR(dacOutput_V(dac, 3072.0), 3.75 * 1.004 - 2.5, 1e-15);
}

} // namespace
} // namespace halbench::models
