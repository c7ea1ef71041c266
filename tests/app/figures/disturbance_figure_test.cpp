#include "app/figures/disturbance_figure.h"
#include "app/procedures/tune/disturbance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace halbench::app {
namespace {

const MotorEstimate Published{{{"c_over_J", 2.23636}, {"Kf_over_J", 37.27}, {"phi_over_J", 26.0}}, {}, {}};

control::PositionLaw recommended(double factor) {
    control::PositionLaw law;
    law.gains.proportional = factor * 40.0;
    law.gains.integral = factor * 60.0;
    law.gains.derivative = factor * 1.4;
    return law;
}

std::optional<control::LoadStep> disturbed(double factor) {
    const auto loop = runAnalysis(Published, recommended(factor), {});
    return loop ? disturbanceStep(Published, recommended(factor), {}, *loop) : std::nullopt;
}

TEST(DisturbanceFigure, hasBothLoopsWithPeakAndRecoveryOfTheProposedOne) {
    const auto proposed = disturbed(1.0);
    const auto present = disturbed(0.5);
    ASSERT_TRUE(proposed && present);
    EXPECT_GT(present->peak_rad, proposed->peak_rad); // half the stiffness
    const auto figure = disturbanceFigure(proposed, present, widgets::AngleUnit::Degree);
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->panels.at(0).curves.size(), 2U);
    EXPECT_EQ(figure->panels[0].curves[0].label, "before");
    EXPECT_TRUE(figure->isLinked);
    EXPECT_EQ(figure->panels[0].y.unit, "deg");
    const auto& lines = figure->panels[0].lines;
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(lines[0].at, proposed->peak_rad * 180.0 / M_PI, 1e-12);
    EXPECT_EQ(lines[1].at, *proposed->recoveryTime_s);
    EXPECT_NEAR(figure->panels[1].curves[1].y.back(), -DisturbanceLoad_A, 0.05); // it holds the load
}

// Twice the load moves a linear loop twice as far; the band is of the motors that are given, none of none.
TEST(DisturbanceFigure, theBandOfTheMotorsAndAnotherLoadAreDrawn) {
    const auto loop = runAnalysis(Published, recommended(1.0), {});
    ASSERT_TRUE(loop);
    const auto plant = plantFromEstimate(Published);
    ASSERT_TRUE(plant);
    std::vector<control::PositionPlant> motors(100, *plant);
    for (std::size_t i = 0; i < motors.size(); ++i) {
        motors[i].accelerationGain_rad_s2_A *= 0.9 + 0.002 * static_cast<double>(i);
    }
    const auto one = disturbanceOf(Published, recommended(1.0), {}, *loop, 0.5, {});
    const auto two = disturbanceOf(Published, recommended(1.0), {}, *loop, 1.0, motors);
    ASSERT_TRUE(one && two && two->band);
    EXPECT_FALSE(one->band);
    EXPECT_NEAR(two->step.peak_rad, 2.0 * one->step.peak_rad, 1e-12);
    EXPECT_LT(two->band->peak_rad.p5, two->step.peak_rad);
    EXPECT_GT(two->band->peak_rad.p95, two->step.peak_rad);
    const auto figure = disturbanceFigure(two->step, {}, widgets::AngleUnit::Radian, two->load_A, two->band);
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->title.rfind("Load step equal to 1 A", 0), 0U) << figure->title;
    EXPECT_EQ(figure->panels.at(0).curves.back().style, widgets::CurveStyle::Band);
}

TEST(DisturbanceFigure, anUnstableLoopHasNone) {
    EXPECT_FALSE(disturbed(40.0));
    EXPECT_FALSE(disturbanceFigure(std::nullopt, disturbed(1.0)));
    const auto alone = disturbanceFigure(disturbed(1.0), std::nullopt);
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->panels.at(0).curves.size(), 1U);
    EXPECT_EQ(alone->panels.at(0).y.unit, "rad");
}

} // namespace
} // namespace halbench::app
