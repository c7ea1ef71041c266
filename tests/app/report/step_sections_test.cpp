#include "app/actuators/htm/motor_geometry_analysis.h"
#include "app/report/step_sections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace halbench::app {
namespace {

control::Estimate identified(double value, double half, const std::string& unit) {
    return {value, std::pair(value - half, value + half), control::EstimateSource::Identified, unit};
}

Recording recordingOf(const std::vector<StreamLayout::Column>& columns, int rows, double period_s) {
    Recording recording;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = columns;
    recording.layout = layout;
    for (int i = 0; i < rows; ++i) {
        recording.time_s.push_back(period_s * i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            recording.values.push_back(0.5 + 0.1 * static_cast<double>(k) * i);
        }
    }
    return recording;
}

/// Five plateaus each way exactly on s omega = (|I| - 1.4 -+ 0.1)/0.1; the last one is left out.
IdentifyResult sweep() {
    IdentifyResult result;
    result.viscousDamping = identified(1.2e-3, 4e-5, "N*m*s/rad");
    result.coulombFriction = identified(2.0e-2, 8e-4, "N*m");
    result.torqueConstant = identified(1.43e-2, 2e-4, "N*m/A");
    result.inertia = {5.5e-4, {}, control::EstimateSource::Given, "kg*m^2"};
    result.ratios["c_over_phi"] = identified(0.1, 0.003, "A*s/rad");
    result.ratios["Kf_over_phi"] = identified(1.4, 0.05, "A");
    result.asymmetry = identified(0.1 / 1.4, 0.01, "");
    result.rSquared = 0.9967;
    result.residualRms_rad_s = 0.41;
    for (int i = 0; i < 5; ++i) {
        const double current_A = 2.0 + 0.5 * i;
        result.points.push_back({current_A, (current_A - 1.5) / 0.1, true, 1.0, {}});
        result.points.push_back({-current_A, -(current_A - 1.3) / 0.1, true, 1.0, {}});
    }
    result.points.back().isUsed = false;
    result.points.back().note = "the rotor stopped";
    result.covarianceNames = {"viscous_damping", "coulomb_friction"};
    result.covariance = {{4e-10, -7e-9}, {-7e-9, 1.6e-7}};
    result.recording = recordingOf({{"speed", "rad/s"}, {"current_command", "A"}}, 50, 0.01);
    return result;
}

template <typename Block>
std::vector<const Block*> blocks(const ReportSection& section) {
    std::vector<const Block*> found;
    for (const ReportBlock& block : section.blocks) {
        if (const auto* match = std::get_if<Block>(&block)) {
            found.push_back(match);
        }
    }
    return found;
}

std::string textOf(const ReportSection& section) {
    ReportContent content;
    content.sections = {section};
    return renderReport(content).value();
}

TEST(IdentificationSection, drawsTheFitOfEachDirectionWithItsOwnFriction) {
    const ReportSection section = identificationSection("Sweep", sweep());
    const auto plots = blocks<ReportPlot>(section);
    ASSERT_EQ(plots.size(), 3U); // regression, ellipse, excitation
    // The points lie on the lines, so every residual is zero.
    const widgets::Figure& regression = plots[0]->figure;
    for (const widgets::Curve& curve : regression.panels.at(1).curves) {
        for (const double residual : curve.y) {
            EXPECT_NEAR(residual, 0.0, 1e-12);
        }
    }
    EXPECT_NE(plots[0]->caption.find("0.9967"), std::string::npos);
    EXPECT_NE(plots[0]->caption.find("-4 A: the rotor stopped"), std::string::npos);
}

TEST(IdentificationSection, jointRegionTakesItsFreedomFromTheInterval) {
    IdentifyResult result = sweep();
    // 95 % half-width of 2.201 standard errors: 11 degrees of freedom, 2 F(0.95; 2, 11) = 2 * 3.982.
    result.viscousDamping = identified(1.2e-3, 2.201 * 2e-5, "N*m*s/rad");
    const auto section = identificationSection("Sweep", result);
    const widgets::Curve& ellipse = blocks<ReportPlot>(section).at(1)->figure.panels.at(0).curves.at(0);
    double widest = 0.0;
    for (const double x : ellipse.x) {
        widest = std::fmax(widest, x - 1.2e-3);
    }
    EXPECT_NEAR(widest, std::sqrt(2.0 * 3.982) * 2e-5, 1e-3 * widest);
}

TEST(IdentificationSection, showsNoFitAndNoRegionWhenTheEstimateWasRefused) {
    IdentifyResult refused;
    refused.quality = {Verdict::Refused, {{"no_motion", "The rotor did not turn.", "Raise the current."}}};
    refused.points = {{1.0, 0.0, false, 0.0, "not moving"}};
    const ReportSection section = identificationSection("Sweep", refused);
    EXPECT_TRUE(blocks<ReportPlot>(section).empty());
    const std::string html = textOf(section);
    EXPECT_NE(html.find("Data quality: refused"), std::string::npos);
    EXPECT_NE(html.find("not identifiable"), std::string::npos);
}

TEST(CalibrationSection, tellsAppliedFromProposed) {
    CalibrateResult result;
    result.figures = {{"stray.coefficient", "T/A", identified(2.5e-3, 3e-5, "T/A")}};
    result.before = {{"stray.coefficient", 0.0}};
    result.proposed = {{"stray.coefficient", 2.5e-3}};
    result.staticFriction = {{0.1, 1.6}, {-0.5 * M_PI, -1.7}};
    EXPECT_NE(textOf(calibrationSection("Calibration", result)).find("Proposed, not applied"),
              std::string::npos);
    result.isApplied = true;
    const ReportSection section = calibrationSection("Calibration", result);
    EXPECT_NE(textOf(section).find("Applied to the board"), std::string::npos);
    const auto plots = blocks<ReportPlot>(section);
    ASSERT_EQ(plots.size(), 1U);
    EXPECT_EQ(plots[0]->figure.panels[0].curves[1].y, (std::vector<double>{1.7}));
    EXPECT_NEAR(plots[0]->figure.panels[0].curves[1].x.front(), 270.0, 1e-12);
}

TEST(TuningSection, namesInfiniteMarginsAndInstabilityInWords) {
    TuneResult result;
    result.method = "recommended";
    result.law.gains.proportional = 40.0;
    result.predicted.isStable = true;
    result.predicted.margins.phaseMargin_deg = 37.9;
    result.predicted.bode = {{1.0, 10.0}, {20.0, -20.0}, {-100.0, -200.0}};
    AnalysisResult present = result.predicted;
    present.isStable = false;
    const ReportSection section = tuningSection("Tuning", result, present);
    const std::string html = textOf(section);
    EXPECT_NE(html.find("infinite"), std::string::npos);
    EXPECT_NE(html.find("37.9°"), std::string::npos);
    EXPECT_NE(html.find(">stable<"), std::string::npos);
    EXPECT_NE(html.find(">unstable<"), std::string::npos);
    EXPECT_EQ(blocks<ReportPlot>(section).at(0)->figure.panels[0].curves.size(), 2U);
}

TEST(TuningSection, drawsTheBandOfTheMotorsThatTheDataAllow) {
    TuneResult result;
    result.predicted.isStable = true;
    result.predicted.bode = {{1.0, 10.0}, {20.0, -20.0}, {-100.0, -200.0}};
    LoopUncertainty uncertainty;
    uncertainty.loop = {{6.28, 62.8}, {{19.0, -21.0}, {21.0, -19.0}}, {{-101.0, -201.0}, {-99.0, -199.0}}};
    const ReportSection section = tuningSection("Tuning", result, std::nullopt, uncertainty);
    const auto& curves = blocks<ReportPlot>(section).at(0)->figure.panels[0].curves;
    EXPECT_TRUE(std::any_of(curves.begin(), curves.end(),
                            [](const auto& curve) { return curve.style == widgets::CurveStyle::Band; }));
    EXPECT_NE(textOf(section).find("5-95 % band (motor uncertainty)"), std::string::npos);
}

TEST(MoveSection, showsAnglesInDegreesFromTheStart) {
    MoveResult result;
    result.recording = recordingOf(
        {{"reference", "rad"}, {"position", "rad"}, {"truth.position", "rad"}, {"current_command", "A"}}, 20,
        1e-3);
    result.measured.overshoot_percent = 7.5;
    result.measured.finalError = 0.01;
    models::IdealTrace predicted;
    predicted.time_s = {0.0, 0.019};
    predicted.angle_rad = {0.0, 1.0};
    const ReportSection section = moveSection("Step", result, predicted);
    const widgets::Figure& figure = blocks<ReportPlot>(section).at(0)->figure;
    ASSERT_EQ(figure.panels.size(), 3U);
    const auto& positions = figure.panels[0].curves;
    ASSERT_EQ(positions.size(), 3U);
    EXPECT_EQ(positions[2].label, "measured");
    EXPECT_DOUBLE_EQ(positions[2].y.front(), 0.0);
    EXPECT_NEAR(positions[2].y.back(), 1.9 * 180.0 / M_PI, 1e-9);
    EXPECT_NEAR(positions[1].y.back(), 180.0 / M_PI, 1e-9);
    const ReportTable& figures = *blocks<ReportTable>(section).at(0);
    EXPECT_EQ(figures.rows.at(0).at(0).text, "overshoot"); // a rise time that nobody has is not a row
    EXPECT_EQ(figures.rows.at(1).at(1).text, "0.573");
}

TEST(MoveSection, survivesAnEmptyRecording) {
    EXPECT_TRUE(blocks<ReportPlot>(moveSection("Step", MoveResult{})).empty());
}

TEST(ApplySection, listsOnlyWhatChanged) {
    ApplyResult result;
    result.before = {{"gain.kp", 10.0}, {"gain.ki", 0.1}};
    result.after = {{"gain.kp", 40.0}, {"gain.ki", 0.1}};
    const ReportSection section = applySection("Apply", result);
    const ReportTable& table = *blocks<ReportTable>(section).at(0);
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(table.rows[0][0].text, "gain.kp");
    EXPECT_EQ(table.rows[0][3].text, "A/rad");
    result.after = result.before;
    EXPECT_NE(textOf(applySection("Apply", result)).find("All 2 values were already on the device."),
              std::string::npos);
}

TEST(ApplySection, saysWhetherTheValuesStayed) {
    ApplyResult result;
    result.before = {{"gain.kp", 10.0}};
    result.after = {{"gain.kp", 40.0}};
    EXPECT_NE(textOf(applySection("Apply", result)).find("Old values restored."), std::string::npos);
    result.isKept = true;
    result.verification = MoveResult{};
    result.predicted = MoveFigures{};
    const std::string html = textOf(applySection("Apply", result));
    EXPECT_NE(html.find("New values active on the device."), std::string::npos);
    EXPECT_NE(html.find("predicted"), std::string::npos);
}

TEST(MotorSection, showsEveryFigureInWordsWithItsUnitAndWhatIsDoubtful) {
    const std::string html = textOf(motorSection("analyse: ring", analyseField({}, {})));
    for (const char* words : {"their field at the sensors", "mT", "1.74", "remanence that would reach it",
                              "Data quality: doubtful", "magnets end near 1.5 T"}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
}

TEST(MoveSection, listsTheRunsOfARepeatedMoveAndSaysWhatLockedMeans) {
    MoveResult result;
    result.lockThreshold = 20.0 * M_PI / 180.0;
    result.measured.lockTime_s = 0.73;
    MoveRepetition repetition;
    repetition.config = {2, 0.28 * M_PI / 180.0};
    repetition.start = {0.0, M_PI / 2.0};
    repetition.maxError = {0.1 * M_PI / 180.0, 1.25 * M_PI / 180.0};
    repetition.peakToPeak = {0.0, 2.5 * M_PI / 180.0};
    repetition.windowTime_s = {0.4128, std::nullopt};
    const std::string html = textOf(moveSection("move: micro", result, std::nullopt, repetition));
    for (const char* words : {"50 % of 2 runs settled within 0.28\u00b0", "90.00", "1.250", "2.500", "0.730",
                              "error below 20\u00b0 to the end", "start \u00b0", "0.413",
                              "Settling time, 1 of 2 runs: 0.413 to 0.413 s"}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
}

TEST(TuningSection, showsTheLargeStepThatFrictionAndCurrentLimitAllow) {
    AnalysisResult loop;
    const double height_rad = 100.0 * M_PI / 180.0;
    loop.largeStep = LargeStep{height_rad, {}};
    loop.largeStep->metrics.overshoot_percent = 33.3;
    loop.largeStep->trace.time_s = {0.0, 1.0, 2.0};
    loop.largeStep->trace.angle_rad = {0.0, 1.333 * height_rad, height_rad};
    EXPECT_NE(textOf(analysisSection("analyse: loop", loop)).find("33.3 % of 100\u00b0"), std::string::npos);
}

TEST(TuningSection, tellsNoOvershootOfALargeStepThatHasNotArrived) {
    AnalysisResult loop;
    const double height_rad = 100.0 * M_PI / 180.0;
    loop.largeStep = LargeStep{height_rad, {}};
    loop.largeStep->trace.time_s = {0.0, 1.0, 2.0};
    loop.largeStep->trace.angle_rad = {0.0, 0.5 * height_rad, 0.97 * height_rad};
    const std::string html = textOf(analysisSection("analyse: loop", loop));
    EXPECT_EQ(html.find("% of 100\u00b0"), std::string::npos);
}

TEST(ContradictionsSection, belongsToTheMotorOnly) {
    EXPECT_FALSE(contradictionsSection("planar").has_value());
    ASSERT_TRUE(contradictionsSection("htm").has_value());
    EXPECT_NE(textOf(*contradictionsSection("htm")).find("0.0572 N·m"), std::string::npos);
}

/// One coherent point with its phase margin; no gain margin.
FrequencyResult response() {
    FrequencyResult result;
    FrequencyResultPoint point;
    point.measured.frequency_rad_s = 2.0 * M_PI;
    point.measured.value = {0.02, 0.0};
    point.measured.coherence = 0.99;
    point.openLoop = {0.0, -1.0};
    point.isUsed = true;
    result.points = {point};
    result.margins.phase_deg = {control::MeasuredMargin::Withheld::No, 2.0 * M_PI, 90.0,
                                std::pair(89.0, 91.0)};
    return result;
}

TEST(FrequencySection, tellsMarginsWithIntervalsOrThatTheyAreWithheld) {
    FrequencyResult result = response();
    result.bands = {{0.5, 2.0, 14, M_PI / 180.0}};
    const ReportSection section = frequencySection("frequency: loop", result);
    std::string words;
    for (const ReportBlock& block : section.blocks) {
        if (const auto* table = std::get_if<ReportTable>(&block)) {
            for (const auto& row : table->rows) {
                for (const auto& cell : row) {
                    words += cell.text + "|";
                }
            }
        }
    }
    EXPECT_NE(words.find("phase margin|90.00\u00b0|89.00 to 91.00\u00b0|1.00 Hz|"), std::string::npos)
        << words;
    EXPECT_NE(words.find("gain margin|not given"), std::string::npos) << words;
    EXPECT_NE(words.find("0.5|2|14|1|"), std::string::npos) << words; // the amplitude in degrees
}

} // namespace
} // namespace halbench::app
