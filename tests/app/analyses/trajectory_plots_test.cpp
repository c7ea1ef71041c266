#include "app/analyses/spherical/trajectory_plots.h"
#include "tests/app/analyses/recorded_poses.h"

#include <gmock/gmock.h>

namespace halbench::app {
namespace {

// resources/help/spherical-theory.md section 9: trajectory 3 is a circle of the shaft at theta = 45 degrees.
TEST(TrajectoryPlotsTest, showTrueAndEstimatedPoses) {
    const auto result = run("estimators", {{"poses", "trajectory3"}, {"spin_deg", "20"}});
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->plots.size(), 3U);
    const AnalysisPlot& angles = result->plots[0];
    ASSERT_EQ(angles.panels.size(), 3U);
    const AnalysisPanel& gamma = angles.panels[2];
    ASSERT_EQ(gamma.curves.size(), 3U); // the truth, 'refined' and 'swarm'
    EXPECT_EQ(gamma.curves[0].name, "true");
    ASSERT_EQ(gamma.curves[0].y.size(), 25U);
    EXPECT_NEAR(gamma.curves[0].y[7], 20.0, 1e-9);
    EXPECT_EQ(gamma.curves[1].name, "refined");
    EXPECT_NEAR(gamma.curves[1].y[7], 20.0, 1e-9); // no noise: section 9
    const AnalysisPlot& path = result->plots[2];
    EXPECT_TRUE(path.isEqualScale);
    const AnalysisCurve& truth = path.panels[0].curves[0];
    for (std::size_t i = 0; i < truth.x.size(); ++i) {
        EXPECT_NEAR(std::hypot(truth.x[i], truth.y[i]), std::sqrt(0.5), 1e-12);
    }
}

// Section 5.3: on the additive model its own inverse is the one that is right.
TEST(TrajectoryPlotsTest, ofTheAdditiveModelItsClosedFormIsShown) {
    const auto result = run("estimators", {{"poses", "trajectory1"}, {"device", "paper"}});
    ASSERT_TRUE(result) << result.error().message;
    const AnalysisPanel& alpha = result->plots[0].panels[0];
    ASSERT_EQ(alpha.curves.size(), 3U);
    EXPECT_EQ(alpha.curves[1].name, "closed");
    EXPECT_EQ(alpha.curves[2].name, "swarm");
    EXPECT_NEAR(alpha.curves[1].y[24], alpha.curves[0].y[24], 1e-9);
}

// Section 5.1: first harmonics that are ignored cost 0.487 degrees rms over the workspace, 1.1 at most.
TEST(TrajectoryPlotsTest, errorsAreThoseOfTheHarmonicsThatAreIgnored) {
    const auto result =
        run("estimators", {{"poses", "trajectory3"}, {"harmonics", "h1"}, {"only", "refined"}});
    ASSERT_TRUE(result) << result.error().message;
    const AnalysisPanel& errors = result->plots[1].panels.front();
    EXPECT_TRUE(errors.y.isLogarithmic);
    ASSERT_EQ(errors.curves.size(), 1U);
    const double worst = *std::max_element(errors.curves[0].y.begin(), errors.curves[0].y.end());
    EXPECT_GT(worst, 0.1);
    EXPECT_LT(worst, 1.2);
}

TEST(TrajectoryPlotsTest, randomPosesHaveNone) {
    const auto result = run("estimators", {{"count", "10"}, {"only", "tensor"}});
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->plots.empty());
}

// What equal seeds repeat has no time of this machine in it; a clock that is given is told beside it.
TEST(TrajectoryPlotsTest, timeIsSaidBesideTheResult) {
    double now_s = 0.0;
    AnalysisControl control;
    control.now_s = [&now_s] { return now_s += 1.0; };
    const std::map<std::string, std::string> texts = {{"count", "10"}, {"only", "tensor"}};
    const auto timed = run("estimators", texts, {}, nullptr, control);
    const auto plain = run("estimators", texts);
    ASSERT_TRUE(timed);
    ASSERT_TRUE(plain);
    // A second for ten poses.
    EXPECT_THAT(timed->timing, testing::StartsWith("time per pose: tensor 1e+05 us; the publication's"));
    EXPECT_EQ(plain->timing, "");
    EXPECT_EQ(toJsonText(timed->body).value(), toJsonText(plain->body).value());
    EXPECT_EQ(timed->summary, plain->summary);
}

} // namespace
} // namespace halbench::app
