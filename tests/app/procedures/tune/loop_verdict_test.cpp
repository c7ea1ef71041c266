#include "app/procedures/tune/loop_verdict.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(LoopVerdict, aGoodLoopOnAnAssumptionIsNotCalledGood) {
    for (const char* code : {"stray_field_not_calibrated", "model_without_covariance"}) {
        const std::vector<Finding> findings = {{"note", "", ""}, {code, "", ""}};
        EXPECT_TRUE(restsOnAssumption(findings));
        EXPECT_EQ(loopVerdict(Verdict::Good, findings, true), "Stable under the stated assumptions:");
        EXPECT_EQ(loopVerdict(Verdict::Good, findings, false), "Stable under the stated assumptions:");
    }
}

TEST(LoopVerdict, aStableLoopNearItsLimitIsNotCalledGood) {
    for (const char* code : {"delay_sensitive", "small_margin", "little_damping", "above_sampled_limit"}) {
        const std::vector<Finding> findings = {{"friction_band", "", ""}, {code, "", ""}};
        EXPECT_TRUE(isNearStabilityLimit(findings));
        for (const bool isRobustnessKnown : {false, true}) {
            EXPECT_EQ(loopVerdict(Verdict::Good, findings, isRobustnessKnown),
                      "Stable with little reserve: check the warnings");
        }
        EXPECT_EQ(loopVerdict(Verdict::Refused, findings, true).rfind("Rejected", 0), 0U);
    }
    EXPECT_FALSE(isNearStabilityLimit({{"friction_band", "", ""}}));
}

TEST(LoopVerdict, robustIsOnlyWhatWasJudgedWithItsUncertainty) {
    const std::vector<Finding> findings = {{"current_saturates", "", ""}};
    EXPECT_FALSE(restsOnAssumption(findings));
    EXPECT_EQ(loopVerdict(Verdict::Good, findings, true), "Good: robustly stable");
    EXPECT_EQ(loopVerdict(Verdict::Good, findings, false), "Good: stable");
}

TEST(LoopVerdict, anAssumptionMakesNoBadLoopBetter) {
    const std::vector<Finding> findings = {{"stray_field_not_calibrated", "", ""}};
    EXPECT_EQ(loopVerdict(Verdict::Doubtful, findings, true).rfind("Doubtful", 0), 0U);
    EXPECT_EQ(loopVerdict(Verdict::Refused, findings, true).rfind("Rejected", 0), 0U);
}

} // namespace
} // namespace halbench::app
