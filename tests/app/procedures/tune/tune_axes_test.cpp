#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/tune_axes.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

Estimate known(double value, const std::string& unit) {
    return {value, {}, EstimateSource::Identified, unit};
}

/// The six-coil positioner's x and phi (resources/help/planar-theory.md sections 3 and 9), the mass known to
/// 2 % and the inertia to 20 % (one standard deviation).
AxisModel platen() {
    AxisModel model;
    model.axes.push_back({"x", "m", "N", known(0.0, "1/s"), known(1.0 / 0.64, "m/(s^2*N)"), {}, {1e-3, 1}});
    model.axes.push_back(
        {"phi", "rad", "N*m", known(0.0, "1/s"), known(1e3, "rad/(s^2*N*m)"), {}, {1e-3, 1}});
    model.covarianceNames = {"x.acceleration_gain", "phi.acceleration_gain"};
    model.covariance = {{std::pow(0.02 / 0.64, 2), 0.0}, {0.0, 200.0 * 200.0}};
    return model;
}

AxisConditions conditions() {
    LoopConditions x;
    x.timing = {1e-3, 1};
    x.currentLimit_A = 3.098;
    x.axis = LoopAxis{"x", "m", "N", 30.0, 1e-3};
    LoopConditions phi = x;
    phi.currentLimit_A = 0.236;
    phi.axis = LoopAxis{"phi", "rad", "N*m", 60.0, 5e-3};
    return {x, phi};
}

bool hasFinding(const DataQuality& quality, const std::string& code) {
    return std::any_of(quality.findings.begin(), quality.findings.end(),
                       [&](const Finding& finding) { return finding.code == code; });
}

TEST(TuneAxes, recommendedLoopsAreThoseOfThePublishedDesign) {
    const auto result = tuneAxes(platen(), conditions(), {});
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->axes.size(), 2u);
    const TuneResult& x = result->axes[0];
    EXPECT_NEAR(x.law.gains.proportional, 660.48, 0.01); // all printed digits of section 9
    EXPECT_NEAR(x.law.gains.integral, 1267.2, 0.1);
    EXPECT_NEAR(x.law.gains.derivative, 39.808, 1e-3);
    EXPECT_NEAR(x.law.inertia_A_s2_rad, 0.64, 1e-12);
    ASSERT_TRUE(x.filtered);
    EXPECT_EQ(x.filtered->proportionalWeight, 0.745);
    const AnalysisResult& predicted = x.predicted;
    EXPECT_NEAR(predicted.margins.phaseMargin_deg, 62.8, 1.0); // tolerances of section 11
    EXPECT_NEAR(*predicted.margins.gainCrossover_rad_s / (2.0 * Pi), 10.38, 0.21);
    EXPECT_NEAR(*predicted.step->riseTime_s, 0.245, 0.02);
    EXPECT_NEAR(*predicted.step->settlingTime_s, 0.968, 0.05);
    ASSERT_TRUE(predicted.largeStep);
    EXPECT_EQ(predicted.largeStep->amplitude_rad, 1e-3);
    // Without friction and far from the limit the test step is the linear one.
    EXPECT_NEAR(*predicted.largeStep->metrics.riseTime_s, 0.245, 0.02);
    EXPECT_LT(*predicted.largeStep->overshoot_percent(), 0.5);
    const TuneResult& phi = result->axes[1];
    EXPECT_NEAR(phi.law.gains.proportional, 3.864, 1e-6);
    EXPECT_NEAR(phi.predicted.margins.phaseMargin_deg, 51.0, 1.0);
    EXPECT_EQ(result->quality.verdict, Verdict::Good);
}

TEST(TuneAxes, uncertaintyOfEachAxisWidensItsOwnMargins) {
    const auto result = tuneAxes(platen(), conditions(), {});
    ASSERT_TRUE(result);
    const auto spread_deg = [&](std::size_t i) {
        const auto& interval = *result->axes[i].robust.phaseMargin_deg;
        return interval.p95 - interval.p5;
    };
    EXPECT_GT(spread_deg(1), 3.0 * spread_deg(0)); // ten times the relative uncertainty
    EXPECT_EQ(result->axes[0].robust.unstable_fraction, 0.0);
    ASSERT_TRUE(result->joint);
    EXPECT_EQ(result->joint->draws, 1000);
    EXPECT_EQ(result->joint->unstable_fraction, 0.0);
}

TEST(TuneAxes, aDrawIsUnstableWithAnyOfItsAxes) {
    AxisModel model = platen();
    // A gain known to its own size: 15.9 % of the draws of each axis are not positive and no axis at all
    // (normal distribution below minus one sigma), so that 1 - 0.841^2 = 29.2 % lack one of the two.
    model.covariance = {{std::pow(1.0 / 0.64, 2), 0.0}, {0.0, 1e6}};
    const auto result = tuneAxes(model, conditions(), {});
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->joint->unstable_fraction, 0.292, 0.045); // three sigma of 1000 draws
    // Fully correlated, both fail in the same draws.
    model.covariance = {{std::pow(1.0 / 0.64, 2), 1e3 / 0.64}, {1e3 / 0.64, 1e6}};
    const auto correlated = tuneAxes(model, conditions(), {});
    ASSERT_TRUE(correlated) << correlated.error().message;
    EXPECT_NEAR(correlated->joint->unstable_fraction, 0.159, 0.036);
    EXPECT_EQ(correlated->quality.verdict, Verdict::Doubtful);
    EXPECT_TRUE(hasFinding(correlated->quality, "not_robust"));
    EXPECT_EQ(correlated->quality.findings.front().message.find("axis x: "), 0u);
}

TEST(TuneAxes, aModelWithoutCovarianceHasNoJointRobustness) {
    AxisModel model = platen();
    model.covarianceNames.clear();
    model.covariance.clear();
    const auto result = tuneAxes(model, conditions(), {});
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->joint);
    EXPECT_TRUE(hasFinding(result->quality, "model_without_covariance"));
}

TEST(TuneAxes, gainsFromElsewhereAreJudgedForTheirAxis) {
    const auto designed = tuneAxes(platen(), conditions(), {});
    ASSERT_TRUE(designed);
    const TuneResult& x = designed->axes[0];
    LoopLaw wild(x.law, x.filtered);
    wild.law.gains.proportional *= 40.0; // twice beyond the upper gain margin of 20.6 dB
    wild.filtered->gains.proportional *= 40.0;
    wild.filtered->gains.derivative *= 40.0;
    wild.filtered->gains.integral *= 40.0;
    const auto judged = judgeAxes(platen(), {conditions()[0]}, {wild}, {"file"}, {});
    ASSERT_TRUE(judged) << judged.error().message;
    EXPECT_FALSE(judged->axes[0].predicted.isStable);
    EXPECT_EQ(judged->quality.verdict, Verdict::Refused);
    EXPECT_TRUE(hasFinding(judged->quality, "unstable"));
}

TEST(TuneAxes, errorsNameTheAxis) {
    TuneAxesConfig config;
    config.method = "bandwidth";
    config.targets.bandwidth_Hz = 300.0;
    const auto result = tuneAxes(platen(), conditions(), config);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(result.error().message.find("axis x: "), 0u) << result.error().message;
    AxisConditions other = conditions();
    other[1].axis->id = "y";
    const auto unknown = tuneAxes(platen(), other, {});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::UnknownName);
    EXPECT_NE(unknown.error().hint.find("x, phi"), std::string::npos);
}

TEST(TuneAxes, oneAxisOrAllAreChosenByName) {
    EXPECT_EQ(*chosenAxesOf(platen(), ""), (std::vector<std::string>{"x", "phi"}));
    EXPECT_EQ(*chosenAxesOf(platen(), "all"), (std::vector<std::string>{"x", "phi"}));
    EXPECT_EQ(*chosenAxesOf(platen(), "phi"), (std::vector<std::string>{"phi"}));
    EXPECT_EQ(chosenAxesOf(platen(), "z").error().code, ErrorCode::UnknownName);
}

TEST(LoopAxis, estimateOfAnAxisHoldsItsPartOfTheCovariance) {
    AxisModel model = platen();
    model.covarianceNames = {"phi.acceleration_gain", "x.acceleration_gain", "x.damping_rate"};
    model.covariance = {{9.0, 0.5, 0.1}, {0.5, 4.0, 0.2}, {0.1, 0.2, 1.0}};
    const MotorEstimate x = estimateOfAxis(model, model.axes[0]);
    EXPECT_EQ(x.covarianceNames, (std::vector<std::string>{"phi_over_J", "c_over_J"}));
    EXPECT_EQ(x.covariance, (std::vector<std::vector<double>>{{4.0, 0.2}, {0.2, 1.0}}));
    const auto plant = plantFromEstimate(x);
    ASSERT_TRUE(plant);
    EXPECT_DOUBLE_EQ(plant->accelerationGain_rad_s2_A, 1.0 / 0.64);
}

TEST(LoopAxis, positionsAreWrittenWithTheirPrefix) {
    const LoopAxis along{"x", "m", "N", 0.0, 1e-3};
    EXPECT_EQ(positionText(along, 12.3e-6), "12.3 µm");
    EXPECT_EQ(positionText(along, 0.0015), "1.5 mm");
    EXPECT_EQ(positionText(along, 0.0), "0 m");
    EXPECT_EQ(positionText({"phi", "rad", "N*m", 0.0, 1.0}, -5e-3), "-5 mrad");
}

TEST(LoopAxis, frictionThatHoldsAPartOfTheTestStepIsSaid) {
    AxisModel model = platen();
    model.axes[0].breakawayEffort = known(0.1, "N"); // over K_P of 660 N/m: 151 µm of 1 mm
    const auto result = tuneAxes(model, {conditions()[0]}, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(hasFinding(result->quality, "friction_band"));
    EXPECT_NEAR(result->axes[0].predicted.frictionBand_rad, 0.1 / 660.48, 1e-6);
}

} // namespace
} // namespace halbench::app
