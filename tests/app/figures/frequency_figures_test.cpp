#include "app/figures/frequency_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

using widgets::CurveStyle;

/// L = -j at 1 Hz, coherent, its circle a tenth of it; L = -0.1 at 10 Hz, not coherent.
FrequencyResult response() {
    FrequencyResult result;
    FrequencyResultPoint first;
    first.measured.frequency_rad_s = 2.0 * M_PI;
    first.measured.value = {0.02, 0.0};
    first.measured.coherence = 0.99;
    first.radius = 0.002;
    first.openLoop = {0.0, -1.0};
    first.openLoopRadius = 0.1;
    first.closedLoop = first.openLoop / (1.0 + first.openLoop);
    first.isUsed = true;
    FrequencyResultPoint second = first;
    second.measured.frequency_rad_s = 20.0 * M_PI;
    second.measured.coherence = 0.5;
    second.openLoop = {-0.1, 0.0};
    second.isUsed = false;
    result.points = {first, second};
    result.margins.phase_deg = {control::MeasuredMargin::Withheld::No, 2.0 * M_PI, 90.0,
                                std::pair(89.0, 91.0)};
    return result;
}

const widgets::Curve* curveOf(const widgets::Panel& panel, CurveStyle style) {
    for (const widgets::Curve& curve : panel.curves) {
        if (curve.style == style) {
            return &curve;
        }
    }
    return nullptr;
}

TEST(FrequencyFigure, showsMagnitudePhaseAndCoherenceOverOneFrequency) {
    const auto figure = frequencyFigure(response(), FrequencyView::OpenLoop);
    EXPECT_TRUE(figure.x.isLogarithmic);
    ASSERT_EQ(figure.panels.size(), 3U);
    const double expected[3][2] = {{0.0, -20.0}, {-90.0, -180.0}, {0.99, 0.5}}; // of the values above
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* used = curveOf(figure.panels[i], CurveStyle::Points);
        const auto* rest = curveOf(figure.panels[i], CurveStyle::HollowPoints);
        ASSERT_TRUE(used != nullptr && rest != nullptr) << i;
        ASSERT_EQ(used->x.size(), 1U);
        EXPECT_NEAR(used->x[0], 1.0, 1e-12);
        EXPECT_NEAR(rest->x[0], 10.0, 1e-12);
        EXPECT_NEAR(used->y[0], expected[i][0], 1e-9) << i;
        EXPECT_NEAR(rest->y[0], expected[i][1], 1e-9) << i;
    }
    EXPECT_EQ(figure.panels[2].lines.at(0).at, 0.9); // the threshold
    ASSERT_EQ(figure.panels[1].lines.size(), 2U);
    EXPECT_EQ(figure.panels[1].lines[1].label, "phase margin 90.0 \u00b1 1.0\u00b0");
}

// A circle of a tenth: 20 log10(1 -+ 0.1) and asin(0.1); of what is not coherent nothing is claimed.
TEST(FrequencyFigure, dottedLinesHoldTheCircleOfAPointThatIsUsed) {
    const auto figure = frequencyFigure(response(), FrequencyView::OpenLoop);
    const auto* low_dB = curveOf(figure.panels[0], CurveStyle::DottedLine);
    const auto* low_deg = curveOf(figure.panels[1], CurveStyle::DottedLine);
    EXPECT_NEAR(low_dB->y[0], 20.0 * std::log10(0.9), 1e-12);
    EXPECT_NEAR(low_deg->y[0], -90.0 - 180.0 / M_PI * std::asin(0.1), 1e-12);
    EXPECT_TRUE(std::isnan(low_dB->y[1]));
}

TEST(FrequencyFigure, everyViewShowsItsOwnValues) {
    const auto plant = frequencyFigure(response(), FrequencyView::Plant);
    EXPECT_NEAR(curveOf(plant.panels[0], CurveStyle::Points)->y[0], 20.0 * std::log10(0.02), 1e-9);
    EXPECT_TRUE(plant.panels[1].lines.empty()); // margins are those of the open loop
    const auto closed = frequencyFigure(response(), FrequencyView::ClosedLoop);
    // |-j/(1 - j)| = 1/sqrt 2, and its circle 0.1/|1 - j|^2 = 0.05
    EXPECT_NEAR(curveOf(closed.panels[0], CurveStyle::Points)->y[0], -10.0 * std::log10(2.0), 1e-9);
    EXPECT_NEAR(curveOf(closed.panels[0], CurveStyle::DottedLine)->y[0],
                20.0 * std::log10(std::sqrt(0.5) - 0.05), 1e-9);
}

TEST(FrequencyFigure, theRotorThatFitsIsDrawnThroughThePlant) {
    FrequencyResult result = response();
    EXPECT_EQ(curveOf(frequencyFigure(result, FrequencyView::Plant).panels[0], CurveStyle::DashedLine),
              nullptr);
    result.fit.emplace();
    result.fit->rotor = {2.236, 26.0, 0.3e-3, 0.0};
    const auto figure = frequencyFigure(result, FrequencyView::Plant);
    const auto* rotor = curveOf(figure.panels[0], CurveStyle::DashedLine);
    ASSERT_NE(rotor, nullptr);
    const auto first = control::sampledPlantResponse(result.fit->rotor, result.period_s, 2.0 * M_PI);
    EXPECT_NEAR(rotor->y.front(), 20.0 * std::log10(std::abs(first)), 1e-9);
    EXPECT_NEAR(rotor->x.back(), 10.0, 1e-9);
}

TEST(FrequencyFigure, theRawRecordShowsTheSpeedOfTheReference) {
    FrequencyResult result = response();
    EXPECT_FALSE(excitationFigure(result));
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"reference", "rad"}, {"speed", "rad/s"}, {"current_command", "A"}};
    result.recording.layout = layout;
    result.recording.time_s = {0.0, 0.01, 0.02};
    result.recording.values = {0.0, 5.0, 2.0, 0.05, 5.1, 2.1, 0.11, 5.2, 2.2};
    const auto figure = excitationFigure(result);
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->panels.size(), 3U);
    EXPECT_NEAR(figure->panels[0].curves[0].y[2], 6.0, 1e-9);
    EXPECT_EQ(figure->panels[1].curves[0].y[1], 5.1);
    EXPECT_EQ(figure->panels[2].curves[0].y[0], 2.0);
}

} // namespace
} // namespace halbench::app
