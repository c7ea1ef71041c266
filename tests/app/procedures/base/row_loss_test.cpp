#include "app/procedures/base/row_loss.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

devices::LinkStatistics counted(std::uint64_t received, std::uint64_t lost, std::uint64_t damaged) {
    devices::LinkStatistics link;
    link.packetsReceived = received;
    link.packetsLost = lost;
    link.packetsDamaged = damaged;
    return link;
}

TEST(RowLoss, itsCauseIsWhatTheLinkCountedMeanwhile) {
    const auto before = counted(1000, 50, 7);
    EXPECT_EQ(causeOfRowLoss(before, counted(1980, 70, 27)).words,
              "2 % of the frames were damaged on the line");
    EXPECT_EQ(causeOfRowLoss(before, counted(1900, 150, 7)).words,
              "10 % of the packets were lost, none was damaged");
    EXPECT_EQ(causeOfRowLoss(before, counted(2000, 50, 7)).words,
              "no packet was lost or damaged: the device skipped or delayed rows");
    EXPECT_EQ(causeOfRowLoss(before, before).words, "") << "a recording that is replayed has no link";
}

TEST(RowLoss, packetsThatWereOvertakenAreNoLossOfTheLink) {
    const auto before = counted(1000, 50, 0);
    auto after = counted(1950, 100, 0);
    after.packetsLate = 50;
    EXPECT_EQ(causeOfRowLoss(before, after).words, "5 % of the packets arrived out of order");
    after.packetsLate = 10; // the others did not come at all
    EXPECT_EQ(causeOfRowLoss(before, after).words, "5 % of the packets were lost, none was damaged");
}

TEST(RowLoss, aLinkThatCameBackMeanwhileCountsAnew) {
    EXPECT_EQ(causeOfRowLoss(counted(1000, 50, 7), counted(98, 2, 2)).words,
              "2 % of the frames were damaged on the line");
    EXPECT_EQ(causeOfRowLoss(counted(1000, 50, 7), counted(90, 10, 0)).words,
              "10 % of the packets were lost, none was damaged");
}

TEST(RowLoss, anOutageIsNamedBeforeWhatTheLinkCounted) {
    auto after = counted(1960, 70, 27);
    after.returns = 1;
    EXPECT_EQ(causeOfRowLoss(counted(1000, 50, 7), after).words,
              "the connection was lost once and came back");
    after.returns = 3;
    const RowLossCause several = causeOfRowLoss(counted(1000, 50, 7), after);
    EXPECT_EQ(several.words, "the connection was lost 3 times and came back");
    EXPECT_NE(several.remedy.find("plug"), std::string::npos);
    auto before = counted(1000, 50, 7);
    before.returns = 3; // all of them earlier
    EXPECT_EQ(causeOfRowLoss(before, after).words, "2 % of the frames were damaged on the line");
}

TEST(RowLoss, isNamedInAnErrorWithItsRemedy) {
    const Error torn{ErrorCode::Refused, "rows are missing", "measure again"};
    const Error named = withCause(torn, {"2 % of the frames were damaged on the line", "shorten the cable"});
    EXPECT_EQ(named.message, "rows are missing: 2 % of the frames were damaged on the line");
    EXPECT_EQ(named.hint, "shorten the cable");
    EXPECT_EQ(withCause(torn, {"no packet was lost", ""}).hint, "measure again");
    EXPECT_EQ(withCause(torn, {}).message, torn.message);
}

TEST(RowLoss, isNamedInItsFindingAlone) {
    DataQuality quality;
    quality.findings = {{"rows_lost", "3 of 100 rows are missing", ""}, {"noisy", "noisy", "wait"}};
    nameRowLoss(quality, {"2 % of the frames were damaged on the line", "shorten the cable"});
    EXPECT_EQ(quality.findings[0].message,
              "3 of 100 rows are missing: 2 % of the frames were damaged on the line");
    EXPECT_EQ(quality.findings[0].hint, "shorten the cable");
    EXPECT_EQ(quality.findings[1].message, "noisy");
    nameRowLoss(quality, {});
    EXPECT_EQ(quality.findings[0].hint, "shorten the cable") << "nothing is known of another cause";
}

} // namespace
} // namespace halbench::app
