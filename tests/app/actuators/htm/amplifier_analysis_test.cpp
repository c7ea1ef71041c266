#include "app/actuators/htm/amplifier_analysis.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// Figures and printed digits of resources/help/htm-theory.md section 5.
TEST(AmplifierAnalysis, agreesWithTheTheoryPage) {
    const Result<AmplifierAnalysis> analysis = analyseAmplifier(models::AmplifierParts{}, 4.0);
    ASSERT_TRUE(analysis.has_value());
    EXPECT_NEAR(analysis->gain_A_per_V, 2.0, 5e-4);
    EXPECT_NEAR(analysis->lagAt10Hz_deg, 1.080, 5e-4);
    ASSERT_TRUE(analysis->cutoff_Hz.has_value());
    EXPECT_NEAR(*analysis->cutoff_Hz, 632.8, 0.05);
    EXPECT_NEAR(analysis->magnitudeAt1kHz_dB, 0.32, 5e-3);
    EXPECT_NEAR(analysis->phaseAt1kHz_deg, -78.0, 0.05);
}

TEST(AmplifierAnalysis, oneShuntWouldBurnMoreThanItsTenWatts) {
    models::AmplifierParts parts; // resources/help/htm-theory.md 6.14: I^2 R, half the current in each of two
    const AmplifierAnalysis analysis = analyseAmplifier(parts, 4.0).value();
    EXPECT_NEAR(analysis.shuntPower_W, 16.0, 1e-12);
    EXPECT_NEAR(analysis.shuntPowerEach_W, 4.0, 1e-12);
}

TEST(AmplifierAnalysis, curveReachesFrom1HzTo100kHzAndFallsSteadily) {
    const AmplifierAnalysis analysis = analyseAmplifier(models::AmplifierParts{}, 4.0).value();
    ASSERT_EQ(analysis.frequency_Hz.size(), 251U); // 5 decades of 50 points and the end
    EXPECT_NEAR(analysis.frequency_Hz.front(), 1.0, 1e-9);
    EXPECT_NEAR(analysis.frequency_Hz.back(), 1e5, 1e-4);
    for (std::size_t i = 1; i < analysis.frequency_Hz.size(); ++i) {
        EXPECT_LE(analysis.magnitude_dB[i], analysis.magnitude_dB[i - 1] + 1e-12); // two real poles
        EXPECT_LT(analysis.phase_deg[i], analysis.phase_deg[i - 1]);
    }
    EXPECT_GT(analysis.phase_deg.back(), -180.0);
}

TEST(AmplifierAnalysis, refusesPartsThatAreNone) {
    models::AmplifierParts parts;
    parts.R10_Ohm = 0.0;
    const Result<AmplifierAnalysis> analysis = analyseAmplifier(parts, 4.0);
    ASSERT_FALSE(analysis.has_value());
    EXPECT_EQ(analysis.error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::app
