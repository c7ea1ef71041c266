#include "app/procedures/disturbance.h"
#include "app/report/disturbance_figure.h"

#include <gtest/gtest.h>

#include <cmath>

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
