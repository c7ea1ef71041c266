#include "app/workspaces/tune/axes/axis_loops.h"
#include "control/base/units.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"

#include <gtest/gtest.h>

#include <complex>
#include <string>
#include <vector>

namespace halbench::app {
namespace {

AxisLoops loopsOf(double mass_kg = 0.64) {
    AxisLoops loops;
    loops.setModel(platenModelFile(mass_kg));
    return loops;
}

void answerAll(AxisLoops& loops) {
    for (const std::string& axis : loops.axes()) {
        loops.setAnswer(axis, answerAxis(*loops.question(axis)));
    }
}

// resources/help/planar-theory.md section 9: poles -2.2/s and twice -30/s of a free mass,
// k K_P = w^2 + 2 w p, k K_I = p w^2, k K_D = 2 w + p - a.
TEST(AxisLoops, recommendedGainsOfEachAxisArePlacedPoles) {
    AxisLoops loops = loopsOf();
    answerAll(loops);
    ASSERT_TRUE(*loops.answer("x")) << loops.answer("x")->error().message;
    const TuneResult& x = (*loops.answer("x"))->proposed;
    EXPECT_NEAR(x.law.gains.proportional, 0.64 * (900.0 + 2.0 * 30.0 * 2.2),
                1e-3); // single precision of the board
    EXPECT_NEAR(x.law.gains.integral, 0.64 * 2.2 * 900.0, 1e-3);
    EXPECT_NEAR(x.law.gains.derivative, 0.64 * (60.0 + 2.2) - 0.1, 1e-3);
    EXPECT_EQ(x.conditions.axis->effortUnit, "N");
    EXPECT_EQ((*loops.answer("phi"))->proposed.conditions.axis->effortUnit, "N*m");
}

TEST(AxisLoops, resultNeedsEveryAxisAndTakesTheWorstVerdict) {
    AxisLoops loops = loopsOf();
    EXPECT_FALSE(loops.result({"x"})); // not computed yet
    answerAll(loops);
    const auto all = loops.result(loops.axes());
    ASSERT_TRUE(all);
    ASSERT_EQ(all->axes.size(), 3U);
    // Gains without damping let the free mass swing up: that axis alone is refused.
    AxisChoice& y = loops.choice("y");
    y.method = "edited";
    y.law = LoopLaw{};
    y.law->law.gains.proportional = 1000.0;
    loops.setAnswer("y", answerAxis(*loops.question("y")));
    const auto bad = loops.result(loops.axes());
    EXPECT_TRUE(!bad || bad->quality.verdict == Verdict::Refused);
    const auto good = loops.result({"x"});
    ASSERT_TRUE(good);
    EXPECT_NE(good->quality.verdict, Verdict::Refused);
}

TEST(AxisLoops, aCrossoverIsReachedWithItsMargin) {
    AxisLoops loops = loopsOf();
    answerAll(loops);
    auto aim = loops.aim("x");
    ASSERT_TRUE(aim);
    aim->crossover_rad_s *= 1.2;
    const auto design = loops.filtered("x", *aim, control::CrossoverPriority::Margin);
    ASSERT_TRUE(design);
    EXPECT_EQ(design->limit, control::CrossoverLimit::None);
    EXPECT_NEAR(design->reached.crossover_rad_s, aim->crossover_rad_s, 1e-6 * aim->crossover_rad_s);
    EXPECT_FALSE(AxisLoops().filtered("x", *aim, control::CrossoverPriority::Margin));
}

AxisGainsFile fileOf(const AxisLoops& loops, const std::vector<std::string>& axes,
                     const char* model = "planar") {
    ResultHeader header;
    header.schema = "halbench.gains/1";
    header.device.emplace();
    header.device->model = model;
    const auto result = loops.result(axes);
    EXPECT_TRUE(result) << result.error().message;
    const auto text = toJsonText(axisGainsDocument(header, result.value()));
    auto file = parseAxisGains(*text, "gains.json");
    EXPECT_TRUE(file) << file.error().message;
    return file ? *file : AxisGainsFile{};
}

TEST(AxisLoops, gainsThatWereSavedAreProposedAgain) {
    AxisLoops loops = loopsOf();
    loops.choice("y").method = "pole-placement";
    loops.choice("y").targets.omega_rad_s = 25.0;
    loops.choice("y").targets.zeta = 1.0;
    answerAll(loops);
    AxisLoops others = loopsOf();
    const auto missing = others.takeGains(fileOf(loops, loops.axes()));
    ASSERT_TRUE(missing) << missing.error().message;
    EXPECT_TRUE(missing->empty());
    answerAll(others);
    for (const std::string& axis : loops.axes()) {
        const TuneResult& saved = (*loops.answer(axis))->proposed;
        const TuneResult& opened = (*others.answer(axis))->proposed;
        EXPECT_EQ(others.choice(axis).method, "edited");
        EXPECT_NEAR(opened.law.gains.proportional / saved.law.gains.proportional, 1.0, 1e-9) << axis;
        EXPECT_NEAR(opened.law.gains.integral / saved.law.gains.integral, 1.0, 1e-9) << axis;
        EXPECT_NEAR(opened.law.gains.derivative / saved.law.gains.derivative, 1.0, 1e-9) << axis;
        ASSERT_TRUE(saved.filtered && opened.filtered) << axis;
        EXPECT_NEAR(opened.filtered->proportionalWeight, saved.filtered->proportionalWeight, 1e-9) << axis;
        EXPECT_NEAR(opened.filtered->gains.filter_s.value_or(0.0),
                    saved.filtered->gains.filter_s.value_or(0.0), 1e-12)
            << axis;
    }
}

TEST(AxisLoops, gainsOfOneAxisLeaveTheOthersTheirOwn) {
    AxisLoops loops = loopsOf();
    answerAll(loops);
    AxisLoops others = loopsOf();
    const auto missing = others.takeGains(fileOf(loops, {"y"}));
    ASSERT_TRUE(missing);
    EXPECT_EQ(*missing, (std::vector<std::string>{"x", "phi"}));
    EXPECT_EQ(others.choice("y").method, "edited");
    EXPECT_EQ(others.choice("x").method, "recommended");
}

TEST(AxisLoops, gainsOfAnotherActuatorOrOtherAxesAreRefused) {
    AxisLoops loops = loopsOf();
    answerAll(loops);
    const auto foreign = loops.takeGains(fileOf(loops, {"x"}, "other"));
    ASSERT_FALSE(foreign);
    EXPECT_EQ(foreign.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(foreign.error().message.find("'other'"), std::string::npos);
    AxisGainsFile elsewhere = fileOf(loops, {"x"});
    elsewhere.axes = {"z"};
    EXPECT_FALSE(loops.takeGains(elsewhere));
    AxisGainsFile slower = fileOf(loops, {"x"});
    slower.gains.front().timing.period_s = 2e-3;
    const auto refused = loops.takeGains(slower);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_NE(refused.error().message.find("axis x: the gains are for a sampling period of 0.002 s"),
              std::string::npos)
        << refused.error().message;
    EXPECT_EQ(loops.choice("x").method, "recommended");
}

// The sampled double integrator k T^2/2 (z + 1)/(z - 1)^2 is the free mass but for its damping of 0.16/s,
// 0.2 % of a radian at the crossover: there the measured loop is 0 dB and shows the predicted margin.
TEST(AxisLoops, aMeasuredMassHasTheCrossoverAndMarginOfThePrediction) {
    AxisLoops loops = loopsOf();
    answerAll(loops);
    const AnalysisResult& predicted = (*loops.answer("x"))->proposed.predicted;
    ASSERT_TRUE(predicted.margins.gainCrossover_rad_s);
    const double w = *predicted.margins.gainCrossover_rad_s;
    const std::complex<double> z = std::polar(1.0, 1e-3 * w);
    MeasuredPlant plant;
    plant.period_s = 1e-3;
    plant.points.push_back({w / (2.0 * Pi), 0.5e-6 / 0.64 * (z + 1.0) / ((z - 1.0) * (z - 1.0)), true});
    EXPECT_FALSE(loops.measured("x"));
    loops.setMeasured({{"x", plant}});
    EXPECT_FALSE(loops.measured("y"));
    const auto measured = loops.measured("x");
    ASSERT_TRUE(measured);
    EXPECT_NEAR(measured->magnitude_dB.front(), 0.0, 0.02);
    EXPECT_NEAR(measured->phase_deg.front(), predicted.margins.phaseMargin_deg - 180.0, 0.3);
    loops.forgetMeasured("x");
    EXPECT_FALSE(loops.isMeasured("x"));
}

} // namespace
} // namespace halbench::app
