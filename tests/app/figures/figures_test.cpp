#include "app/figures/calibration_figures.h"
#include "app/figures/identification_figures.h"
#include "app/figures/tuning_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace halbench::app {
namespace {

control::Estimate identified(double value, double half, const std::string& unit) {
    return {value, std::pair(value - half, value + half), control::EstimateSource::Identified, unit};
}

TEST(IdentificationFigures, withoutAbsoluteValuesTheRegionIsThatOfTheRatios) {
    IdentifyResult result;
    result.ratios["c_over_phi"] = identified(0.1, 0.003, "A*s/rad");
    result.ratios["Kf_over_phi"] = identified(1.4, 0.05, "A");
    result.covarianceNames = {"c_over_phi", "Kf_over_phi"};
    result.covariance = {{4e-6, -3.2e-5}, {-3.2e-5, 4e-4}};
    const auto region = jointRegion(result);
    ASSERT_TRUE(region);
    EXPECT_EQ(region->figure.panels.at(0).y.unit, "A");
    EXPECT_NEAR(region->correlation, -3.2e-5 / std::sqrt(4e-6 * 4e-4), 1e-12); // of its definition
    result.covariance[0][1] = result.covariance[1][0] = -4e-5;                 // singular: no region
    EXPECT_FALSE(jointRegion(result));
}

TEST(IdentificationFigures, aLineThatWasNotDecidedIsNotDrawn) {
    IdentifyResult result;
    result.points = {{2.0, 5.0, true, 1.0, {}}};
    EXPECT_FALSE(steadySpeedFigure(result));
}

TEST(CalibrationFigures, staticFrictionLiesAtThePlaceOnTheRotorWithoutSign) {
    const auto figure = staticFrictionFigure({{0.5 * M_PI, 1.6}, {-0.5 * M_PI, -1.7}});
    const auto& curves = figure.panels.at(0).curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_NEAR(curves[0].x.front(), 90.0, 1e-9);
    EXPECT_NEAR(curves[1].x.front(), 270.0, 1e-9); // -90 degrees
    EXPECT_EQ(curves[1].y.front(), 1.7);
    const auto radians = staticFrictionFigure({{0.5 * M_PI, 1.6}}, widgets::AngleUnit::Radian);
    EXPECT_EQ(radians.x.unit, "rad");
    EXPECT_NEAR(radians.panels.at(0).curves.at(0).x.front(), 0.5 * M_PI, 1e-12);
}

CalibrateResult hallResult() {
    CalibrateResult result;
    result.figures = {{"hall.offset_a", "T", identified(2e-3, 1e-5, "T")},
                      {"hall.offset_b", "T", identified(-1e-3, 1e-5, "T")},
                      {"hall.gain_ratio", "", identified(1.1, 1e-4, "")},
                      {"hall.quadrature", "rad", identified(0.05, 1e-4, "rad")},
                      {"hall.amplitude", "T", identified(0.15, 1e-5, "T")}};
    return result;
}

/// The ellipse of control/identify/ellipse_fit.h, written down a second time.
HallPoint reading(double angle_rad, double scale_ratio) {
    return {2e-3 + scale_ratio * 0.15 * std::cos(angle_rad),
            -1e-3 + scale_ratio * 0.15 * 1.1 * std::sin(angle_rad + 0.05)};
}

TEST(CalibrationFigures, theHallReadingsLieOnTheirEllipseWhereTheFitIsRight) {
    CalibrateResult result = hallResult();
    EXPECT_FALSE(hallEllipseFigure(result)); // no readings: a file of an older version
    result.hallPoints = {reading(0.3, 1.0), reading(2.0, 1.0), reading(-2.0, 1.0)};
    const auto ellipse = hallEllipseFigure(result);
    ASSERT_TRUE(ellipse);
    const auto& curves = ellipse->panels.at(0).curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_NEAR(curves[1].x.front(), 152.0, 1e-9); // (2 + 150) mT at the angle 0
    EXPECT_NEAR(curves[1].y.front(), -1.0 + 165.0 * std::sin(0.05), 1e-9);
    const auto residual = hallResidualFigure(result);
    ASSERT_TRUE(residual);
    for (const double left_mT : residual->panels.at(0).curves.at(0).y) {
        EXPECT_NEAR(left_mT, 0.0, 1e-9);
    }
    result.figures.pop_back();
    EXPECT_FALSE(hallEllipseFigure(result));
    EXPECT_FALSE(hallResidualFigure(result));
}

TEST(CalibrationFigures, aReadingOutsideOfTheEllipseIsLeftOverAtItsAngle) {
    CalibrateResult result = hallResult();
    result.hallPoints = {reading(0.0, 1.02)};
    const auto residual = hallResidualFigure(result);
    ASSERT_TRUE(residual);
    const auto& curve = residual->panels.at(0).curves.at(0);
    EXPECT_NEAR(curve.x.front(), 0.0, 1e-9);
    // 2 % of the ray from the centre, which is hypot(150, 165 sin 0.05) mT long there
    EXPECT_NEAR(curve.y.front(), 0.02 * std::hypot(150.0, 165.0 * std::sin(0.05)), 1e-9);
    EXPECT_NEAR(hallResidualFigure(result, widgets::AngleUnit::Radian)->x.max.value(), M_PI, 1e-12);
}

bool hasLine(const widgets::Panel& panel, double at, const std::string& part) {
    return std::any_of(panel.lines.begin(), panel.lines.end(), [&](const widgets::ReferenceLine& line) {
        return std::abs(line.at - at) < 1e-9 && line.label.find(part) != std::string::npos;
    });
}

TEST(TuningFigures, marginsAreWrittenWhereTheyAreReadOff) {
    AnalysisResult loop;
    loop.bode = {{1.0, 10.0}, {20.0, -20.0}, {-90.0, -200.0}};
    loop.margins.gainCrossover_rad_s = 2.0 * M_PI * 3.0;
    loop.margins.phaseMargin_deg = 37.9;
    loop.margins.phaseCrossover_rad_s = 2.0 * M_PI * 8.0;
    loop.margins.gainMargin_ratio = 4.2;
    loop.isStable = true;
    const widgets::Figure figure = openLoopFigure(loop, std::nullopt);
    EXPECT_TRUE(hasLine(figure.panels.at(1), 3.0, "38"));
    EXPECT_TRUE(hasLine(figure.panels.at(0), 8.0, "12.5 dB"));
    AnalysisResult unstable = loop;
    unstable.isStable = false; // has no margin, whatever the curve's crossings give
    for (const widgets::Panel& panel : openLoopFigure(unstable, std::nullopt).panels) {
        EXPECT_EQ(panel.lines.size(), 1U);
    }
    loop.margins = {}; // no crossing: nothing to mark
    EXPECT_EQ(openLoopFigure(loop, std::nullopt).panels.at(1).lines.size(), 1U);
    EXPECT_EQ(openLoopFigure(loop, loop).panels.at(0).curves.size(), 2U);
}

TEST(TuningFigures, theLargeStepIsInDegreesWithItsFrictionBand) {
    AnalysisResult loop;
    EXPECT_FALSE(largeStepFigure(loop, std::nullopt));
    loop.frictionBand_rad = 0.01;
    loop.largeStep = LargeStep{0.5, {}, {{0.0, 1.0}, {0.0, 0.5}, {}, {}, {4.0, 0.0}}};
    const auto figure = largeStepFigure(loop, loop);
    ASSERT_TRUE(figure);
    EXPECT_NEAR(figure->panels.at(0).curves.at(1).y.back(), 0.5 * 180.0 / M_PI, 1e-12);
    EXPECT_TRUE(hasLine(figure->panels.at(0), 0.51 * 180.0 / M_PI, "band"));
    EXPECT_EQ(figure->panels.at(1).curves.size(), 2U);
}

Recording verification() {
    Recording measured;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"position", "rad"}, {"current_command", "A"}};
    measured.layout = layout;
    measured.time_s = {0.0, 0.001};
    measured.values = {3.0, 1.0, 3.5, 2.0};
    return measured;
}

VerificationBand verificationBand() {
    VerificationBand band;
    band.predicted.time_s = {0.0, 0.001};
    band.predicted.angle_rad = {0.0, 0.45};
    band.predicted.reference_rad = {0.5, 0.5};
    band.predicted.current_A = {4.0, 0.0};
    band.friction_rad = 0.01;
    band.allowed_rad = 0.03;
    return band;
}

const widgets::Curve& curveNamed(const widgets::Panel& panel, const std::string& part) {
    const auto found =
        std::find_if(panel.curves.begin(), panel.curves.end(), [&](const widgets::Curve& curve) {
            return curve.label.find(part) != std::string::npos;
        });
    EXPECT_NE(found, panel.curves.end()) << part;
    return *found;
}

TEST(TuningFigures, aVerificationCountsTheAngleFromItsStart) {
    const auto figure = verificationFigure(verificationBand(), verification());
    EXPECT_EQ(curveNamed(figure.panels.at(0), "measured").y.front(), 0.0);
    EXPECT_NEAR(curveNamed(figure.panels.at(0), "measured").y.back(), 0.5 * 180.0 / M_PI, 1e-12);
    EXPECT_NEAR(curveNamed(figure.panels.at(0), "set-point").y.back(), 0.5 * 180.0 / M_PI, 1e-12);
    EXPECT_EQ(curveNamed(figure.panels.at(2), "measured").y, (std::vector<double>{1.0, 2.0}));
}

TEST(TuningFigures, aVerificationShowsWhatIsAllowedAndWhatFrictionHoldsByName) {
    const auto figure = verificationFigure(verificationBand(), verification(), widgets::AngleUnit::Radian);
    const widgets::Panel& rest = figure.panels.at(1);
    EXPECT_EQ(rest.y.unit, "rad");
    EXPECT_EQ(curveNamed(rest, "allowed \u00b10.03 rad").y.front(), 0.03);
    EXPECT_EQ(curveNamed(rest, "friction band \u00b10.01 rad").y.front(), 0.01);
    EXPECT_NEAR(curveNamed(rest, "predicted").y.back(), 0.05, 1e-12);
    EXPECT_NEAR(curveNamed(rest, "measured").y.back(), 0.0, 1e-12);
    EXPECT_GT(*rest.y.max, 0.03); // the bands are always in view
    // both sides of a band are one entry of the legend
    const auto count = std::count_if(rest.curves.begin(), rest.curves.end(), [](const widgets::Curve& curve) {
        return curve.label.find("allowed") != std::string::npos;
    });
    EXPECT_EQ(count, 2);
}

TEST(TuningFigures, angleUnitsScaleTheCurvesNotTheMotion) {
    AnalysisResult loop;
    loop.stepCurve = {{0.0, 1.0}, {0.0, 1.1}, {40.0, 0.0}};
    const auto degrees = linearStepFigure(loop, std::nullopt, widgets::AngleUnit::Degree);
    EXPECT_EQ(degrees->panels.at(0).y.unit, "deg");
    EXPECT_EQ(degrees->panels.at(0).curves.at(0).y.back(), 1.1); // of a step of 1 degree
    EXPECT_NEAR(degrees->panels.at(1).curves.at(0).y.front(), 40.0 * M_PI / 180.0, 1e-12);
    loop.largeStep = LargeStep{0.5, {}, {{0.0, 1.0}, {0.0, 0.5}, {}, {}, {4.0, 0.0}}};
    const auto large = largeStepFigure(loop, std::nullopt, widgets::AngleUnit::Radian);
    EXPECT_EQ(large->panels.at(0).curves.at(0).y.back(), 0.5);
    EXPECT_NE(large->title.find("0.5 rad"), std::string::npos);
}

TEST(TuningFigures, savedDesignsAreDrawnUnderTheirNamesInColoursOfTheirOwn) {
    AnalysisResult loop;
    loop.bode = {{1.0, 10.0}, {20.0, -20.0}, {-90.0, -200.0}};
    loop.stepCurve = {{0.0, 1.0}, {0.0, 1.1}, {40.0, 0.0}};
    loop.largeStep = LargeStep{0.5, {}, {{0.0, 1.0}, {0.0, 0.5}, {}, {}, {4.0, 0.0}}};
    AnalysisResult unstable;
    unstable.bode = loop.bode;
    const std::vector<NamedLoop> others = {{"calm", &loop}, {"wild", &unstable}};
    const auto bode = openLoopFigure(loop, std::nullopt, others);
    ASSERT_EQ(bode.panels.at(0).curves.size(), 3U);
    EXPECT_EQ(bode.panels.at(0).curves.at(0).label, "proposed"); // alone it needs no name
    EXPECT_EQ(bode.panels.at(0).curves.at(1).label, "calm");
    EXPECT_EQ(bode.panels.at(0).curves.at(2).label, "wild");
    const auto linear = linearStepFigure(loop, loop, widgets::AngleUnit::Radian, others);
    ASSERT_EQ(linear->panels.at(0).curves.size(), 3U); // an unstable loop has no step
    EXPECT_EQ(linear->panels.at(0).curves.at(1).label, "calm");
    EXPECT_EQ(linear->panels.at(0).curves.at(1).colour, 2);
    EXPECT_EQ(
        largeStepFigure(loop, std::nullopt, widgets::AngleUnit::Degree, others)->panels.at(0).curves.size(),
        2U);
}

TEST(TuningFigures, aMeasuredLoopIsPointsAndThoseThatAreNotCoherentAreHollow) {
    AnalysisResult loop;
    loop.bode = {{1.0, 10.0}, {20.0, -20.0}, {-90.0, -200.0}};
    const MeasuredLoop measured{
        {1.0, 5.0, 9.0}, {19.0, 1.0, -15.0}, {-95.0, -150.0, -10.0}, {true, true, false}};
    const auto figure = openLoopFigure(loop, std::nullopt, {}, measured);
    for (const widgets::Panel& panel : figure.panels) {
        ASSERT_EQ(panel.curves.size(), 3U);
        EXPECT_EQ(panel.curves.at(0).label, "proposed"); // not alone any more
        EXPECT_EQ(panel.curves.at(1).style, widgets::CurveStyle::Points);
        EXPECT_EQ(panel.curves.at(2).style, widgets::CurveStyle::HollowPoints);
    }
    EXPECT_EQ(figure.panels.at(0).curves.at(1).y, (std::vector<double>{19.0, 1.0}));
    EXPECT_EQ(figure.panels.at(1).curves.at(2).y, (std::vector<double>{-10.0}));
    const MeasuredLoop coherent{{1.0}, {19.0}, {-95.0}, {true}};
    EXPECT_EQ(openLoopFigure(loop, std::nullopt, {}, coherent).panels.at(0).curves.size(), 2U);
}

TEST(TuningFigures, anUnstableLoopHasNoPredictedStep) {
    EXPECT_FALSE(linearStepFigure(AnalysisResult{}, std::nullopt));
}

TEST(TuningFigures, theLinearStepHasTheOneBeforeBesideIt) {
    AnalysisResult loop;
    loop.stepCurve = {{0.0, 1.0}, {0.0, 1.1}, {40.0, 0.0}};
    AnalysisResult before;
    before.stepCurve = {{0.0, 1.0}, {0.0, 0.9}, {10.0, 0.0}};
    const auto figure = linearStepFigure(loop, before);
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->panels.at(0).curves.size(), 2U);
    EXPECT_EQ(figure->panels.at(0).curves.at(0).label, "before");
    EXPECT_EQ(figure->panels.at(0).curves.at(0).y.back(), 0.9);
    EXPECT_EQ(figure->panels.at(1).curves.at(1).y.front(), 40.0);
    // an unstable loop before has no step, nor a place beside the proposed one
    EXPECT_EQ(linearStepFigure(loop, AnalysisResult{})->panels.at(0).curves.size(), 1U);
}

} // namespace
} // namespace halbench::app
