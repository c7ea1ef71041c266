#include "control/assess/filtered_loop.h"
#include "control/base/random.h"
#include "control/robustness/filtered_bands.h"
#include "control/robustness/robustness.h"
#include "tests/control/filtered_example.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::control {
namespace {

constexpr LoopTiming OneLate{0.01, 1};

std::vector<PositionPlant> motors(std::size_t count = 400) {
    UncertainPlant uncertain;
    uncertain.mean = Eigen::Vector2d(2.2363636, 26.0);
    uncertain.covariance = Eigen::MatrixXd::Zero(2, 2);
    uncertain.covariance(1, 1) = std::pow(26.0 * 0.05, 2);
    uncertain.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), 1.4336}; };
    auto drawn = *drawPlants(uncertain, 1000, Random(5));
    drawn.resize(count);
    return drawn;
}

void expectNear(const std::vector<double>& one, const std::vector<double>& other, double tolerance) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_NEAR(one[i], other[i], tolerance) << i;
    }
}

void expectNear(const Band& one, const Band& other, double tolerance) {
    expectNear(one.p5, other.p5, tolerance);
    expectNear(one.p95, other.p95, tolerance);
}

const std::vector<double> Frequencies_rad_s = {0.3, 2.0, 10.0, 40.0, 90.0, 200.0, 300.0};

// The rounding of sums in another order, and 1e-9 dB where the integrator's gain is large.
TEST(FilteredBands, withNothingFilteredAreThoseOfTheBoardsLaw) {
    const auto plants = motors();
    const auto board = loopBands(plants, lively(), OneLate, Frequencies_rad_s);
    const auto own = filteredLoopBands(plants, of(lively()), OneLate, Frequencies_rad_s);
    ASSERT_TRUE(board && own);
    expectNear(own->magnitude_dB, board->magnitude_dB, 1e-9);
    expectNear(own->phase_deg, board->phase_deg, 1e-8);
    const auto boardStep = stepBand(plants, lively(), OneLate, 0.7, 1.0, 3, 40);
    const auto ownStep = filteredStepBand(plants, of(lively()), OneLate, 0.7, 1.0, 3, 40);
    ASSERT_TRUE(boardStep && ownStep);
    EXPECT_EQ(ownStep->time_s, boardStep->time_s);
    expectNear(ownStep->response_rad, boardStep->response_rad, 1e-10);
    const auto boardLoad = disturbanceEnvelope(plants, lively(), OneLate, 0.5, 1.0, 3, 40);
    const auto ownLoad = filteredDisturbanceEnvelope(plants, of(lively()), OneLate, 0.5, 1.0, 3, 40);
    ASSERT_TRUE(boardLoad && ownLoad);
    expectNear(ownLoad->angle_rad, boardLoad->angle_rad, 1e-10);
    EXPECT_NEAR(ownLoad->peak_rad.p95, boardLoad->peak_rad.p95, 1e-10);
    ASSERT_EQ(ownLoad->recoveryTime_s.has_value(), boardLoad->recoveryTime_s.has_value());
    EXPECT_EQ(ownLoad->recoveryTime_s->p95, boardLoad->recoveryTime_s->p95);
}

/// The value that so many of a hundred do not exceed, by sorting.
double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[rank - 1];
}

// Second route: every motor's own loop, one by one.
TEST(FilteredBands, areThePercentilesOfTheLoopsOneByOne) {
    const auto plants = motors(200);
    std::vector<double> magnitude_dB, angle_rad, loaded_rad, peak_rad;
    for (const PositionPlant& plant : plants) {
        magnitude_dB.push_back(
            20.0 * std::log10(std::abs(filteredOpenLoop(plant, filtered(), OneLate)->atFrequency(90.0))));
        angle_rad.push_back(filteredStep(plant, filtered(), OneLate, 1.0, 0.3, 1)->response_rad.at(20));
        const auto loaded = filteredLoad(plant, filtered(), OneLate, 0.5, 0.6, 5);
        loaded_rad.push_back(loaded->angle_rad.at(100));
        peak_rad.push_back(loaded->peak_rad);
    }
    const auto loop = filteredLoopBands(plants, filtered(), OneLate, {90.0});
    const auto step = filteredStepBand(plants, filtered(), OneLate, 1.0, 0.3, 1);
    const auto load = filteredDisturbanceEnvelope(plants, filtered(), OneLate, 0.5, 0.6, 5);
    ASSERT_TRUE(loop && step && load);
    EXPECT_NEAR(loop->magnitude_dB.p5[0], percentile(magnitude_dB, 0.05), 1e-9);
    EXPECT_NEAR(loop->magnitude_dB.p95[0], percentile(magnitude_dB, 0.95), 1e-9);
    EXPECT_NEAR(step->response_rad.p5[20], percentile(angle_rad, 0.05), 1e-10);
    EXPECT_NEAR(load->angle_rad.p95[100], percentile(loaded_rad, 0.95), 1e-10);
    EXPECT_NEAR(load->peak_rad.p5, percentile(peak_rad, 0.05), 1e-10);
}

// After a load the integral brings the angle back; without one K_P and the filters' gain for a constant hold.
TEST(FilteredBands, aLoadEndsWhereTheFiltersGainForAConstantLeavesIt) {
    FilteredLaw law = filtered();
    law.proportionalWeight = 1.0;
    law.gains.integral = 0.0;
    law.filters = {LagFilter{1.0, 2.0}};
    const auto step = filteredLoad(published(), law, OneLate, 0.6, 15.0);
    ASSERT_TRUE(step);
    EXPECT_NEAR(step->final_rad, 0.6 / (2.0 * 12.0), 1e-12);
    EXPECT_NEAR(step->angle_rad.back(), step->final_rad, 1e-4 * step->final_rad);
    EXPECT_NEAR(step->current_A.back(), -0.6, 1e-4);
    const auto board = loadStep(published(), lively(), OneLate, 0.5, 1.0);
    const auto own = filteredLoad(published(), of(lively()), OneLate, 0.5, 1.0);
    ASSERT_TRUE(board && own);
    expectNear(own->angle_rad, board->angle_rad, 1e-12);
    EXPECT_EQ(own->recoveryTime_s, board->recoveryTime_s);
    EXPECT_EQ(*filteredRest_rad(filtered(), 0.01, 0.6), 0.0);
}

TEST(FilteredBands, badInputsAreRefused) {
    const std::vector<PositionPlant> none = {{1.0, -1.0, 0.0}};
    EXPECT_EQ(filteredStepBand(none, filtered(), OneLate, 1.0, 1.0).error().code, ErrorCode::Refused);
    EXPECT_EQ(filteredDisturbanceEnvelope(none, filtered(), OneLate, 1.0, 1.0).error().code,
              ErrorCode::Refused);
    EXPECT_FALSE(filteredLoopBands(none, filtered(), OneLate, Frequencies_rad_s));
    EXPECT_FALSE(filteredStepBand(motors(100), filtered(), OneLate, 0.0, 1.0));
    FilteredLaw law = filtered();
    law.proportionalWeight = 2.0;
    EXPECT_FALSE(filteredLoopBands(motors(100), law, OneLate, Frequencies_rad_s));
    EXPECT_FALSE(filteredDisturbanceEnvelope(motors(100), law, OneLate, 0.5, 1.0));
    EXPECT_FALSE(filteredLoad(published(), filtered(), OneLate, 0.0, 1.0));
}

} // namespace
} // namespace halbench::control
