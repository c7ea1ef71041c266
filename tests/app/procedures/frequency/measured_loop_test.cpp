#include "app/procedures/frequency/measured_loop.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

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

// The loop of each axis, cut open while the others stay closed, over a law of K_P alone and its delay.
TEST(MeasuredLoopTest, thePlantOfAnAxisIsItsLoopOverTheLawThatRan) {
    AxesFrequencyResult result;
    result.period_s = 1e-3;
    for (const auto& [id, gain] : {std::pair("x", 660.0), std::pair("phi", 3.864)}) {
        AxisResponse axis;
        axis.axis.id = id;
        axis.law.kp_A_per_rad = gain;
        axis.law.ki_A_per_rad_s = 0.0;
        axis.law.period_s = 1e-3;
        axis.law.delaySamples = 1;
        result.axes.push_back(axis);
    }
    const std::vector<std::complex<double>> masses = {1.0 / 0.64, 1e3};
    for (const double w : {10.0, 50.0, 100.0}) {
        AxesFrequencyPoint point;
        point.plant.frequency_rad_s = w;
        point.plant.coherence = Eigen::Vector2d(0.99, 0.5);
        point.isUsed = {true, false};
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const std::complex<double> plant = -masses[i] / (w * w);
            point.loop.loops.push_back(
                {result.axes[i].law.kp_A_per_rad * std::polar(1.0, -1e-3 * w) * plant, 0.0});
        }
        result.points.push_back(point);
    }
    const auto plants = measuredPlants(result);
    ASSERT_EQ(plants.size(), 2U);
    const MeasuredPlant& phi = plants.at("phi");
    ASSERT_EQ(phi.points.size(), 3U);
    EXPECT_FALSE(phi.points.front().isUsed);
    EXPECT_EQ(phi.points.front().coherence, 0.5);
    EXPECT_TRUE(plants.at("x").points.front().isUsed);
    for (const MeasuredPlant::Point& point : phi.points) {
        const double w = 2.0 * Pi * point.frequency_Hz;
        EXPECT_NEAR(std::abs(point.value + 1e3 / (w * w)) * w * w / 1e3, 0.0, 1e-9) << w;
    }
}

// Second route: the polynomials of the law with its filter on the derivative.
TEST(MeasuredLoopTest, aFilterOfTheLawIsInTheLoop) {
    const control::LoopTiming timing{0.01, 1};
    control::FilteredLaw law;
    law.gains = recommended();
    law.gains.filter_s = 0.02;
    const auto filtered = measuredLoop(exactPlant(), law, timing);
    ASSERT_TRUE(filtered) << filtered.error().message;
    const auto controller = control::filteredController(law, timing.period_s);
    ASSERT_TRUE(controller);
    const MeasuredPlant plant = exactPlant();
    for (std::size_t i = 0; i < plant.points.size(); ++i) {
        const double w = 2.0 * Pi * plant.points[i].frequency_Hz;
        const std::complex<double> L =
            controller->atFrequency(w) * std::polar(1.0, -w * 0.01) * plant.points[i].value;
        EXPECT_NEAR(filtered->magnitude_dB[i], 20.0 * std::log10(std::abs(L)), 1e-9);
    }
    const auto plain = measuredLoop(exactPlant(), recommended(), timing);
    ASSERT_TRUE(plain);
    EXPECT_GT(plain->magnitude_dB.back() - filtered->magnitude_dB.back(), 3.0); // past 1/filter_s = 50 rad/s
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
