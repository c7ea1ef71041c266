#include "app/workspaces/tune/axis_loops.h"
#include "tests/app/workspaces/tune/axis_model_fixture.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace halbench::app
