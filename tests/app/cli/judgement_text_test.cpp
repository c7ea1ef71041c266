#include "app/cli/judgement_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

TEST(JudgementText, saysNothingOfAProofThatThereIsNot) {
    EXPECT_EQ(proofLines(TuneResult()), "");
}

TEST(JudgementText, leavesOutTheStepOfALoopThatIsNotStable) {
    TuneResult result;
    result.assessment.emplace();
    result.assessment->peaks.Ms_ratio = 1.5;
    result.assessment->largestStep_rad = 0.1;
    result.assessment->noiseGain_A_per_rad = std::numeric_limits<double>::infinity();
    const std::string unstable = proofLines(result);
    EXPECT_TRUE(contains(unstable, "Ms    1.5\n")) << unstable;
    EXPECT_FALSE(contains(unstable, "noise gain") || contains(unstable, "step within")) << unstable;
    result.assessment->isStable = true;
    EXPECT_TRUE(contains(proofLines(result), "step within the limit      5.73 deg")); // 0.1 rad
}

TEST(JudgementText, namesTheThresholdAndTheCycleBehindIt) {
    TuneResult result;
    result.predicted.frictionBand_rad = 0.1;
    result.release_s = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(contains(cycleLines(result), "not predicted"));
    EXPECT_FALSE(contains(cycleLines(result), "the integral"));
    result.cycles.emplace();
    EXPECT_TRUE(contains(cycleLines(result), "none"));
    result.cycles->push_back({0.01, 12.0, false, 0.1});
    result.cycles->push_back({0.02, 11.0, true, 0.35});
    result.release_s = 100.0;
    const std::string text = cycleLines(result);
    EXPECT_TRUE(contains(text, "+-5.73 deg\n")) << text;
    EXPECT_TRUE(contains(text, "100 s, from half of it")) << text;
    EXPECT_LT(text.find("threshold of the next      +-0.573 deg at 12 Hz, to 10 %"),
              text.find("limit cycle                +-1.15 deg at 11 Hz, to 35 %"))
        << text;
}

TEST(JudgementText, saysWhatALoadDoesAndOfHowManyMotors) {
    TuneResult result;
    EXPECT_EQ(disturbanceLines(result), ""); // unstable
    result.disturbance.emplace();
    result.disturbance->step.peak_rad = 0.1;
    EXPECT_TRUE(contains(disturbanceLines(result), "load worth 0.5 A\n"));
    EXPECT_TRUE(contains(disturbanceLines(result), "5.73 deg\n"));
    EXPECT_TRUE(contains(disturbanceLines(result), "not in the time"));
    result.disturbance->step.recoveryTime_s = 0.25;
    result.disturbance->band.emplace();
    result.disturbance->band->peak_rad = {0.09, 0.11};
    result.disturbance->band->recoveryTime_s = {0.2, 0.3};
    const std::string text = disturbanceLines(result);
    EXPECT_TRUE(contains(text, "5.73 deg, 5.157 to 6.303 of 5 % to 95 %")) << text;
    EXPECT_TRUE(contains(text, "0.25 s, 0.2 to 0.3 of 5 % to 95 %")) << text;
}

TEST(JudgementText, saysThatNoIntervalIsKnown) {
    EXPECT_TRUE(contains(intervalLines(control::Robustness()), "no interval is known"));
}

TEST(JudgementText, showsNoMarginsOfMotorsThatAreAllUnstable) {
    control::Robustness robust{1000, 1.0, true};
    EXPECT_EQ(intervalLines(robust), "unstable with all 1000 motors that the data allow\n");
}

TEST(JudgementText, saysHowManyMotorsAreLeftOutOfTheMarginsAsUnstable) {
    control::Robustness robust{1000, 0.0, true};
    robust.modulusMargin = control::Robustness::Interval{0.1, 0.3};
    EXPECT_TRUE(contains(intervalLines(robust), "of 1000 motors that the data allow\n"));
    robust.unstable_fraction = 0.125;
    const std::string text = intervalLines(robust);
    EXPECT_TRUE(contains(text, "that the data allow, without the 12.5 % that are unstable\n")) << text;
    EXPECT_TRUE(contains(text, "modulus margin             0.1 to 0.3\n")) << text;
}

} // namespace
} // namespace halbench::app
