#include "app/procedures/frequency/measured_loop.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

const control::PositionPlant Published{1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, 1.43357};

control::PidGains recommended() {
    control::PidGains gains;
    gains.proportional = 40.0;
    gains.integral = 60.0;
    gains.derivative = 1.4;
    return gains;
}

MeasuredPlant exactPlant() {
    MeasuredPlant plant;
    for (const double w : control::logarithmicFrequencies(2.0, 250.0, 60)) {
        plant.points.push_back({w / (2.0 * Pi), control::sampledPlant(Published, 0.01).atFrequency(w), true});
    }
    return plant;
}

// Second route: the polynomials of the whole loop in series, with one sample of delay.
TEST(MeasuredLoopTest, otherGainsOnTheMeasuredPlantAreTheLoopInSeries) {
    const control::LoopTiming timing{0.01, 1};
    const auto loop = measuredLoop(exactPlant(), recommended(), timing);
    ASSERT_TRUE(loop) << loop.error().message;
    const auto expected = control::sampledOpenLoop(Published, recommended(), timing);
    for (std::size_t i = 0; i < loop->frequency_Hz.size(); ++i) {
        const std::complex<double> L = expected->atFrequency(2.0 * Pi * loop->frequency_Hz[i]);
        EXPECT_NEAR(loop->magnitude_dB[i], 20.0 * std::log10(std::abs(L)), 1e-9);
        EXPECT_NEAR(std::remainder(loop->phase_deg[i] - radiansToDegrees(std::arg(L)), 360.0), 0.0, 1e-9);
    }
}

TEST(MeasuredLoopTest, thePhaseRunsOnAndAPointThatIsNotCoherentDoesNotLeadItAstray) {
    MeasuredPlant plant = exactPlant();
    plant.points[30].value *= -1.0; // half a turn off, whatever it was
    plant.points[30].isUsed = false;
    const auto loop = measuredLoop(plant, recommended(), {0.01, 2});
    ASSERT_TRUE(loop);
    for (std::size_t i = 1; i < loop->phase_deg.size(); ++i) {
        if (i != 30 && i != 31) {
            EXPECT_LT(std::abs(loop->phase_deg[i] - loop->phase_deg[i - 1]), 90.0) << i;
        }
    }
    EXPECT_LT(std::abs(loop->phase_deg[31] - loop->phase_deg[29]), 90.0);
    EXPECT_FALSE(loop->isUsed[30]);
}

TEST(MeasuredLoopTest, aLoopOfAnotherRateIsAnotherLoop) {
    const auto loop = measuredLoop(exactPlant(), recommended(), {0.005, 0});
    ASSERT_FALSE(loop);
    EXPECT_EQ(loop.error().code, ErrorCode::InvalidInput);
}

TEST(MeasuredPlant, takesThePointsOfAResultWithTheirUse) {
    FrequencyResult result;
    result.period_s = 0.005;
    FrequencyResultPoint point;
    point.measured.frequency_rad_s = 2.0 * M_PI * 3.0;
    point.measured.value = {-0.1, 0.02};
    point.measured.coherence = 0.97;
    result.config.leastCoherence = 0.8;
    point.isUsed = true;
    result.points = {point, point, point};
    result.points[1].isUsed = false;
    result.points[2].measured.value = 0.0; // has neither magnitude nor phase
    const MeasuredPlant plant = measuredPlant(result);
    EXPECT_EQ(plant.period_s, 0.005);
    ASSERT_EQ(plant.points.size(), 2U);
    EXPECT_NEAR(plant.points[0].frequency_Hz, 3.0, 1e-12);
    EXPECT_EQ(plant.points[0].value, std::complex<double>(-0.1, 0.02));
    EXPECT_EQ(plant.points[0].coherence, 0.97);
    EXPECT_EQ(plant.leastCoherence, 0.8);
    const auto loop = measuredLoop(plant, recommended(), {0.005, 0});
    ASSERT_TRUE(loop);
    EXPECT_EQ(loop->coherence, (std::vector<double>{0.97, 0.97})); // gains change nothing about it
    EXPECT_EQ(loop->leastCoherence, 0.8);
    EXPECT_TRUE(plant.points[0].isUsed);
    EXPECT_FALSE(plant.points[1].isUsed);
}

} // namespace
} // namespace halbench::app
