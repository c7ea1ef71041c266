#include "app/figures/loop_figures.h"
#include "app/figures/loop_marks.h"
#include "app/figures/tuning_figures.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <utility>

namespace halbench::app {
namespace {

const widgets::Curve& curve(const widgets::Figure& figure, std::size_t panel, const std::string& part) {
    const auto& curves = figure.panels.at(panel).curves;
    return *std::find_if(curves.begin(), curves.end(), [&part](const widgets::Curve& each) {
        return each.label.find(part) != std::string::npos;
    });
}

using Complex = std::complex<double>;

/// Three points of a loop: far below, at and above its crossover.
AnalysisResult crossing() {
    AnalysisResult loop;
    loop.isStable = true;
    loop.bode = {{0.1, 1.0, 10.0}, {40.0, 0.0, -40.0}, {-90.0, -90.0, -180.0}};
    loop.margins.modulusMargin = 0.5;
    return loop;
}

TEST(LoopFigures, theNyquistPlotHasTheLoopAsComplexNumbers) {
    const widgets::Figure figure = nyquistFigure(crossing(), std::nullopt);
    EXPECT_TRUE(figure.isEqualScale);
    const widgets::Curve& loop = figure.panels.at(0).curves.at(0);
    EXPECT_NEAR(loop.x.at(0), 0.0, 1e-12);
    EXPECT_NEAR(loop.y.at(0), -100.0, 1e-12);
    EXPECT_NEAR(loop.y.at(1), -1.0, 1e-12);
    EXPECT_NEAR(loop.x.at(2), -0.01, 1e-12);
    const widgets::Curve& margin = curve(figure, 0, "modulus margin: 0.50 (Ms 2.00)");
    for (std::size_t i = 0; i < margin.x.size(); ++i) {
        EXPECT_NEAR(std::hypot(margin.x[i] + 1.0, margin.y[i]), 0.5, 1e-12);
    }
    const widgets::Curve& critical = curve(figure, 0, "\u22121");
    EXPECT_EQ(critical.x, std::vector<double>{-1.0});
    EXPECT_EQ(critical.y, std::vector<double>{0.0});
}

TEST(LoopFigures, theNicholsPlotHasThePhaseAcrossAndTheSameDistanceFromMinusOne) {
    const widgets::Figure figure = nicholsFigure(crossing(), std::nullopt);
    const widgets::Curve& loop = figure.panels.at(0).curves.at(0);
    EXPECT_EQ(loop.x, (std::vector<double>{-90.0, -90.0, -180.0}));
    EXPECT_EQ(loop.y, (std::vector<double>{40.0, 0.0, -40.0}));
    EXPECT_LE(*figure.x.min, -180.0);
    const widgets::Curve& margin = curve(figure, 0, "Ms 2.00");
    for (std::size_t i = 0; i < margin.x.size(); ++i) {
        const auto value = std::polar(std::pow(10.0, margin.y[i] / 20.0), margin.x[i] * Pi / 180.0);
        EXPECT_NEAR(std::abs(1.0 + value), 0.5, 1e-12);
        EXPECT_GT(margin.x[i], -360.0);
        EXPECT_LE(margin.x[i], 0.0);
    }
}

// By hand: the margins of the points themselves.
TEST(LoopFigures, theNicholsPlotMarksTheMarginsOnItsOwnTurn) {
    AnalysisResult loop = crossing();
    loop.isStable = true;
    for (double& phase_deg : loop.bode.phase_deg) {
        phase_deg -= 360.0;
    }
    const double gain_rad_s = 2.0 * Pi * loop.bode.frequency_Hz[1];
    const double phase_rad_s = 2.0 * Pi * loop.bode.frequency_Hz[2];
    loop.margins.gainCrossover_rad_s = gain_rad_s;
    loop.margins.phaseCrossover_rad_s = phase_rad_s;
    loop.margins.phaseMargin_deg = 90.0;
    loop.margins.gainMargin_ratio = 100.0;
    control::Crossing gain{};
    gain.kind = control::Crossing::Kind::Gain;
    gain.frequency_rad_s = gain_rad_s;
    gain.phaseMargin_deg = 90.0;
    control::Crossing phase{};
    phase.kind = control::Crossing::Kind::Phase;
    phase.frequency_rad_s = phase_rad_s;
    phase.gainMargin_ratio = 100.0;
    loop.crossings = {gain, phase};
    const widgets::Figure figure = nicholsFigure(loop, std::nullopt);
    const widgets::Curve& phaseMargin = curve(figure, 0, "phase margin 90\u00b0");
    EXPECT_NEAR(phaseMargin.x.at(0), -90.0 - 360.0, 1e-12);
    EXPECT_NEAR(phaseMargin.y.at(0), 0.0, 1e-12);
    const widgets::Curve& gainMargin = curve(figure, 0, "gain margin 40.0 dB");
    EXPECT_NEAR(gainMargin.x.at(0), -180.0 - 360.0, 1e-12);
    EXPECT_NEAR(gainMargin.y.at(0), -40.0, 1e-12);
}

// A crossing at a factor of 0.1 stands at -10 + 0i and at +20 dB: outside the one picture, inside the other.
TEST(LoopFigures, theLegendHasOtherCrossingsOnlyWhereTheyAreSeen) {
    AnalysisResult loop = crossing();
    control::Crossing far{};
    far.kind = control::Crossing::Kind::Phase;
    far.frequency_rad_s = 2.0 * Pi * loop.bode.frequency_Hz[0];
    far.gainMargin_ratio = 0.1;
    loop.crossings = {far};
    const auto hasOthers = [](const widgets::Figure& figure) {
        const auto& curves = figure.panels.at(0).curves;
        return std::any_of(curves.begin(), curves.end(),
                           [](const widgets::Curve& each) { return each.label == "other crossings"; });
    };
    EXPECT_FALSE(hasOthers(nyquistFigure(loop, std::nullopt)));
    EXPECT_TRUE(hasOthers(nicholsFigure(loop, std::nullopt)));
    loop.crossings[0].gainMargin_ratio = 1e-4; // +80 dB
    EXPECT_FALSE(hasOthers(nicholsFigure(loop, std::nullopt)));
}

TEST(LoopFigures, theNicholsPlotsAxisEndsWhereItsCurvesDo) {
    EXPECT_EQ(*nicholsFigure(crossing(), std::nullopt).x.max, -90.0);
    AnalysisResult leading = crossing();
    leading.bode.phase_deg[0] = -20.0;
    EXPECT_EQ(*nicholsFigure(leading, std::nullopt).x.max, 0.0);
}

TEST(LoopFigures, sensitivityIsWhatTheLoopLeavesOver) {
    const auto figure = sensitivityFigure(crossing(), std::nullopt);
    ASSERT_TRUE(figure);
    const auto& left = figure->panels.at(0).curves.at(0).y;
    const auto& follows = figure->panels.at(1).curves.at(0).y;
    // L = -100 i, -i and -0.01: |1 + L| is sqrt(10001), sqrt(2) and 0.99.
    EXPECT_NEAR(left.at(0), -10.0 * std::log10(10001.0), 1e-9);
    EXPECT_NEAR(left.at(1), -10.0 * std::log10(2.0), 1e-9);
    EXPECT_NEAR(left.at(2), -20.0 * std::log10(0.99), 1e-9);
    EXPECT_NEAR(follows.at(0), 40.0 - 10.0 * std::log10(10001.0), 1e-9);
    EXPECT_NEAR(follows.at(1), -10.0 * std::log10(2.0), 1e-9);
    EXPECT_NEAR(follows.at(2), -40.0 - 20.0 * std::log10(0.99), 1e-9);
    EXPECT_NEAR(figure->panels.at(0).lines.at(0).at, 20.0 * std::log10(2.0), 1e-12);
}

// Circles, margins and marks have a colour of their own, however many designs are beside each other.
TEST(LoopFigures, noLoopLooksLikeAnotherOrLikeAMark) {
    const AnalysisResult loop = crossing();
    const std::vector<NamedLoop> others(12, {"kept", &loop});
    std::set<std::pair<int, widgets::CurveStyle>> looks;
    for (const LoopCurve& each : loopCurves(loop, loop, others)) {
        EXPECT_NE(each.colour, MarkColour);
        EXPECT_TRUE(looks.insert({each.colour, each.style}).second) << looks.size();
    }
    const widgets::Figure figure = openLoopFigure(loop, loop, others);
    const widgets::Figure plane = nyquistFigure(loop, loop, others);
    for (std::size_t i = 0; i < others.size() + 2; ++i) { // the same in every picture
        EXPECT_EQ(figure.panels.at(0).curves.at(i).colour, plane.panels.at(0).curves.at(i).colour) << i;
    }
}

TEST(LoopFigures, anUnstableLoopHasNeitherSensitivityNorModulusMargin) {
    AnalysisResult unstable = crossing();
    unstable.isStable = false;
    EXPECT_FALSE(sensitivityFigure(unstable, std::nullopt));
    EXPECT_EQ(nyquistFigure(unstable, std::nullopt).panels.at(0).curves.size(), 3U); // loop, circle, point
    const auto beside = sensitivityFigure(crossing(), unstable);
    EXPECT_EQ(beside->panels.at(0).curves.size(), 1U);
}

// The curve of the published motor with its recommended gains: what the pictures show against the margins,
// which are found on a grid of their own.
TEST(LoopFigures, theCurveTouchesTheCircleOfTheModulusMarginAndCutsTheAxisAtTheGainMargin) {
    const MotorEstimate motor{{{"c_over_J", 2.23636}, {"Kf_over_J", 37.27}, {"phi_over_J", 26.0}}, {}, {}};
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 60.0;
    law.gains.derivative = 1.4;
    const auto loop = runAnalysis(motor, law, {});
    ASSERT_TRUE(loop) << loop.error().message;
    ASSERT_TRUE(loop->isStable);
    const widgets::Figure figure = nyquistFigure(*loop, std::nullopt);
    const widgets::Curve& drawn = figure.panels.at(0).curves.at(0);
    double nearest = 1e9;
    double cut = 0.0; // where the curve comes up through the negative real axis
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        nearest = std::min(nearest, std::hypot(drawn.x[i] + 1.0, drawn.y[i]));
        if (i > 0 && drawn.y[i - 1] < 0.0 && drawn.y[i] >= 0.0 && drawn.x[i] < 0.0) {
            const double part = drawn.y[i - 1] / (drawn.y[i - 1] - drawn.y[i]);
            cut = drawn.x[i - 1] + part * (drawn.x[i] - drawn.x[i - 1]);
        }
    }
    // 400 points on 3.7 decades stand 2 % of frequency apart: half of that beside the minimum, and squared.
    EXPECT_NEAR(nearest, loop->margins.modulusMargin, 2e-3);
    EXPECT_GE(nearest, loop->margins.modulusMargin - 1e-9);
    EXPECT_NEAR(-1.0 / cut, loop->margins.gainMargin_ratio, 2e-3 * loop->margins.gainMargin_ratio);
}

MotorEstimate published() {
    return {{{"c_over_J", 2.23636}, {"Kf_over_J", 37.27}, {"phi_over_J", 26.0}}, {}, {}};
}

control::PositionLaw recommended(double factor = 1.0) {
    control::PositionLaw law;
    law.gains.proportional = factor * 40.0;
    law.gains.integral = factor * 60.0;
    law.gains.derivative = factor * 1.4;
    return law;
}

// With integral action the phase begins below -180 degrees: the loop crosses that line twice.
TEST(LoopFigures, everyCrossingIsMarkedInBothPlotsTheDecidingOnesStrong) {
    const auto loop = runAnalysis(published(), recommended(), {});
    ASSERT_TRUE(loop);
    ASSERT_GT(loop->crossings.size(), 2U);
    const widgets::Figure bode = openLoopFigure(*loop, std::nullopt);
    for (const widgets::Panel& panel : bode.panels) {
        std::size_t vertical = 0;
        std::size_t faint = 0;
        for (const widgets::ReferenceLine& line : panel.lines) {
            vertical += line.direction == widgets::ReferenceLine::Direction::Vertical ? 1U : 0U;
            faint += line.isFaint ? 1U : 0U;
        }
        EXPECT_EQ(vertical, loop->crossings.size());
        EXPECT_EQ(vertical - faint, 2U); // one of gain, one of phase
    }
    const widgets::Figure plane = nyquistFigure(*loop, std::nullopt);
    const widgets::Curve& gain = curve(plane, 0, "gain margin");
    EXPECT_NEAR(gain.x.at(0), -1.0 / loop->margins.gainMargin_ratio, 1e-12);
    EXPECT_EQ(gain.y.at(0), 0.0);
    const widgets::Curve& phase = curve(plane, 0, "phase margin");
    const double beyond = degreesToRadians(loop->margins.phaseMargin_deg); // of the negative real axis
    EXPECT_NEAR(phase.x.at(0), -std::cos(beyond), 1e-12);
    EXPECT_NEAR(phase.y.at(0), -std::sin(beyond), 1e-12);
    EXPECT_EQ(curve(plane, 0, "other crossings").x.size(), loop->crossings.size() - 2);
}

// Second route: the criterion against the poles, on both sides of the limit and with delay.
TEST(LoopFigures, whatCirclesMinusOneIsWhatThePolesSay) {
    for (const double factor : {0.02, 1.0, 6.0, 40.0}) {
        for (const int delay_samples : {0, 2}) {
            LoopConditions conditions;
            conditions.timing.delay_samples = delay_samples;
            const auto loop = runAnalysis(published(), recommended(factor), conditions);
            ASSERT_TRUE(loop) << loop.error().message;
            const auto count = nyquistCount(*loop);
            ASSERT_TRUE(count) << factor << " " << delay_samples;
            const auto unstable = std::count_if(loop->roots.closedLoop.begin(), loop->roots.closedLoop.end(),
                                                [](Complex pole) { return std::abs(pole) >= 1.0; });
            EXPECT_EQ(count->unstableOpenLoopPoles, 0); // integrators lie on the circle
            EXPECT_EQ(count->encirclements, -unstable) << factor << " " << delay_samples;
        }
    }
    const auto loop = runAnalysis(published(), recommended(), {});
    EXPECT_EQ(criticalPoint(*loop), "−1, 0 encirclements; unstable poles of L: 0");
    EXPECT_EQ(criticalPoint(crossing()), "\u22121"); // no roots, no count
}

/// 0 dB at -90 degrees, coherent; -20 dB at -180 degrees, not.
MeasuredLoop measuredPoints() {
    return {{1.0, 10.0}, {0.0, -20.0}, {-90.0, -180.0}, {true, false}};
}

TEST(LoopFigures, measuredPointsLieInTheNyquistPlaneThoseThatAreNotCoherentHollow) {
    const widgets::Figure figure = nyquistFigure(crossing(), std::nullopt, {}, measuredPoints());
    const widgets::Curve& used = curve(figure, 0, "measured");
    const widgets::Curve& rest = curve(figure, 0, "measured, low coherence");
    for (const widgets::Curve* each : {&used, &rest}) {
        ASSERT_EQ(each->x.size(), 1U);
    }
    EXPECT_EQ(rest.style, widgets::CurveStyle::HollowPoints);
    EXPECT_NEAR(rest.x[0], -0.1, 1e-12); // 10^(-20/20) at -180 degrees
    EXPECT_NEAR(rest.y[0], 0.0, 1e-12);
    const auto& curves = figure.panels.at(0).curves;
    const auto points = std::find_if(curves.begin(), curves.end(),
                                     [](const widgets::Curve& each) { return each.label == "measured"; });
    ASSERT_NE(points, curves.end());
    EXPECT_EQ(points->style, widgets::CurveStyle::Points);
    EXPECT_NEAR(points->x[0], 0.0, 1e-12);
    EXPECT_NEAR(points->y[0], -1.0, 1e-12);
    EXPECT_EQ(nyquistFigure(crossing(), std::nullopt).panels.at(0).curves.size() + 2, curves.size());
}

TEST(LoopFigures, measuredPointsLieInTheNicholsPlotAndItsAxisReachesThem) {
    MeasuredLoop measured = measuredPoints();
    measured.phase_deg[0] = -300.0; // farther than any curve
    const widgets::Figure figure = nicholsFigure(crossing(), std::nullopt, {}, measured);
    const auto& curves = figure.panels.at(0).curves;
    const auto points = std::find_if(curves.begin(), curves.end(),
                                     [](const widgets::Curve& each) { return each.label == "measured"; });
    ASSERT_NE(points, curves.end());
    EXPECT_NEAR(points->x[0], -300.0, 1e-12);
    EXPECT_NEAR(points->y[0], 0.0, 1e-12);
    EXPECT_LE(*figure.x.min, -300.0);
    EXPECT_EQ(curve(figure, 0, "measured, low coherence").style, widgets::CurveStyle::HollowPoints);
}

TEST(LoopFigures, coherenceStandsBelowTheBodePlotWhenItWasMeasured) {
    EXPECT_EQ(openLoopFigure(crossing(), std::nullopt, {}, measuredPoints()).panels.size(), 2U); // not known
    MeasuredLoop measured = measuredPoints();
    measured.coherence = {0.99, 0.4};
    measured.leastCoherence = 0.9;
    const widgets::Figure figure = openLoopFigure(crossing(), std::nullopt, {}, measured);
    ASSERT_EQ(figure.panels.size(), 3U);
    EXPECT_TRUE(figure.isLinked);
    const widgets::Panel& coherence = figure.panels[2];
    ASSERT_EQ(coherence.curves.size(), 2U);
    EXPECT_EQ(coherence.curves[0].y, std::vector<double>{0.99});
    EXPECT_EQ(coherence.curves[1].style, widgets::CurveStyle::HollowPoints);
    EXPECT_EQ(coherence.curves[1].x, std::vector<double>{10.0});
    EXPECT_EQ(coherence.lines.at(0).at, 0.9);
}

TEST(LoopFigures, planesKnowTheFrequencyOfEachSample) {
    for (const auto& figure : {nyquistFigure(crossing(), std::nullopt, {}, measuredPoints()),
                               nicholsFigure(crossing(), std::nullopt, {}, measuredPoints())}) {
        ASSERT_TRUE(figure.parameter);
        EXPECT_EQ(figure.parameter->unit, "Hz");
        EXPECT_EQ(figure.panels.at(0).curves.at(0).parameter, crossing().bode.frequency_Hz);
        EXPECT_EQ(curve(figure, 0, "measured, low coherence").parameter, std::vector<double>{10.0});
    }
}

} // namespace
} // namespace halbench::app
