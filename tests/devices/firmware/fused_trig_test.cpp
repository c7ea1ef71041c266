// What a processor with a fused multiply-add uses, compiled for this one beside the C library's functions.
#define HB_FEATURE_FUSED_TRIG 1
#define hb_sine_cosine fusedSineCosine
#define hb_angle_of fusedAngleOf
#include "devices/firmware/control/hb_trig.c"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices::firmware {
namespace {

TEST(FusedTrig, sineAndCosineStayWithinTwoRoundingsOverManyTurns) {
    double worst = 0.0;
    for (int i = -200000; i <= 200000; ++i) {
        const float angle = 1e-3F * static_cast<float>(i);
        float sine = 0.0F;
        float cosine = 0.0F;
        fusedSineCosine(angle, &sine, &cosine);
        const double exact = static_cast<double>(angle);
        worst = std::max({worst, std::fabs(static_cast<double>(sine) - std::sin(exact)),
                          std::fabs(static_cast<double>(cosine) - std::cos(exact))});
    }
    // One rounding of a value near one is 6e-8, and the remainder of the division is rounded once before.
    EXPECT_LT(worst, 1.2e-7);
    EXPECT_GT(worst, 1e-8);
}

TEST(FusedTrig, quadrantsMeetWithoutAStep) {
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const auto angle = static_cast<float>((quarter + 0.5) * 1.57079632679489662);
        for (const float beside : {std::nextafter(angle, -1e3F), angle, std::nextafter(angle, 1e3F)}) {
            float sine = 0.0F;
            float cosine = 0.0F;
            fusedSineCosine(beside, &sine, &cosine);
            EXPECT_NEAR(static_cast<double>(sine), std::sin(static_cast<double>(beside)), 1.2e-7) << quarter;
            EXPECT_NEAR(static_cast<double>(cosine), std::cos(static_cast<double>(beside)), 1.2e-7)
                << quarter;
        }
    }
}

} // namespace
} // namespace halbench::devices::firmware
