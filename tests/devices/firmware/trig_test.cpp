// The tables of small processors, compiled for this one beside the C library's functions of the full build.
#define HB_FEATURE_TABLE_TRIG 1
#define hb_sine_cosine tableSineCosine
#define hb_angle_of tableAngleOf
#include "devices/firmware/control/hb_trig.c"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::firmware {
namespace {

constexpr double Pi = 3.14159265358979323846;

TEST(TableTrig, sineAndCosineStayWithinTheirBoundOverManyTurns) {
    double worst = 0.0;
    for (int i = -40000; i <= 40000; ++i) {
        const float angle = 1e-3F * static_cast<float>(i);
        float sine = 0.0F;
        float cosine = 0.0F;
        tableSineCosine(angle, &sine, &cosine);
        worst = std::max(worst, std::fabs(static_cast<double>(sine) - std::sin(static_cast<double>(angle))));
        worst =
            std::max(worst, std::fabs(static_cast<double>(cosine) - std::cos(static_cast<double>(angle))));
    }
    // a straight line over pi/128 leaves 7.5e-5, the phase counts 9.6e-5 rad
    EXPECT_LT(worst, 1.9e-4);
    EXPECT_GT(worst, 1e-6);
}

TEST(TableTrig, theArcIsRightInEveryDirectionAtAnyLength) {
    for (const double length : {0.157, 2e-3, 1.0}) {
        double worst = 0.0;
        for (int i = -3600; i <= 3600; ++i) {
            const double angle = Pi * i / 3600.0;
            const float found = tableAngleOf(static_cast<float>(length * std::sin(angle)),
                                             static_cast<float>(length * std::cos(angle)));
            worst = std::max(worst, std::fabs(std::remainder(static_cast<double>(found) - angle, 2.0 * Pi)));
        }
        // a straight line over 1/64 leaves 2e-5, the ratio counts 6.1e-5, the result 2.4e-5
        EXPECT_LT(worst, 1.1e-4) << length;
    }
    EXPECT_EQ(tableAngleOf(0.0F, 0.0F), 0.0F);
    EXPECT_NEAR(static_cast<double>(tableAngleOf(0.0F, -1.0F)), Pi, 3e-5);
}

} // namespace
} // namespace halbench::devices::firmware
