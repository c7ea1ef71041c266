#include "app/procedures/base/doubtful_source.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

DataQuality qualityOf(Verdict verdict) {
    return {verdict, {{"noisy", "the signal is noisy", "shield the cable"}}};
}

TEST(DoubtfulSource, onlyADoubtfulOneCastsADoubtThatNamesItsFindings) {
    for (const auto& [doubtsOf, code] : {std::pair(&doubtsOfModel, "doubtful_model"),
                                         std::pair(&doubtsOfCalibration, "doubtful_calibration"),
                                         std::pair(&doubtsOfRelay, "doubtful_relay")}) {
        EXPECT_TRUE(doubtsOf(qualityOf(Verdict::Good)).empty());
        const auto doubts = doubtsOf(qualityOf(Verdict::Doubtful));
        ASSERT_EQ(doubts.size(), 1U);
        EXPECT_EQ(doubts[0].code, code);
        EXPECT_NE(doubts[0].message.find("noisy"), std::string::npos);
        EXPECT_FALSE(doubts[0].hint.empty());
        EXPECT_EQ(doubtsOf({Verdict::Doubtful, {}}).size(), 1U) << "without findings too";
    }
}

TEST(DoubtfulSource, makesWhatRestsOnItDoubtfulAndNeverBetter) {
    DataQuality quality;
    addDoubts(quality, {});
    EXPECT_EQ(quality.verdict, Verdict::Good);
    addDoubts(quality, doubtsOfModel(qualityOf(Verdict::Doubtful)));
    EXPECT_EQ(quality.verdict, Verdict::Doubtful);
    EXPECT_EQ(quality.findings.size(), 1U);
    DataQuality refused{Verdict::Refused, {}};
    addDoubts(refused, doubtsOfModel(qualityOf(Verdict::Doubtful)));
    EXPECT_EQ(refused.verdict, Verdict::Refused);
}

TEST(DoubtfulSource, aVerificationThatWasNotGoodMakesTheDesignDoubtful) {
    DataQuality design{Verdict::Good, {{"small_step", "s", ""}}};
    addVerification(design, qualityOf(Verdict::Good));
    EXPECT_EQ(design.verdict, Verdict::Good);
    EXPECT_EQ(design.findings.size(), 1U);
    addVerification(design, qualityOf(Verdict::Refused));
    EXPECT_EQ(design.verdict, Verdict::Doubtful);
    ASSERT_EQ(design.findings.size(), 2U);
    EXPECT_EQ(design.findings[1].code, "noisy");
    addVerification(design, qualityOf(Verdict::Refused));
    EXPECT_EQ(design.findings.size(), 2U) << "said once";
}

} // namespace
} // namespace halbench::app
