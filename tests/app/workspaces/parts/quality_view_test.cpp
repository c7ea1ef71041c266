#include "app/workspaces/parts/quality_view.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(QualityView, eachVerdictHasItsLevelAndEachFindingItsHint) {
    EXPECT_EQ(verdictLevel(Verdict::Good), widgets::VerdictLevel::Good);
    EXPECT_EQ(verdictLevel(Verdict::Doubtful), widgets::VerdictLevel::Doubtful);
    EXPECT_EQ(verdictLevel(Verdict::Refused), widgets::VerdictLevel::Refused);
    const std::vector<widgets::Remark> remarks =
        remarksOf({{"a", "no such phrase", "do that"}, {"b", "x", ""}});
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_EQ(remarks[0].message, QStringLiteral("no such phrase"));
    EXPECT_EQ(remarks[0].hint, QStringLiteral("do that"));
    EXPECT_EQ(remarks[1].hint, QString());
}

} // namespace
} // namespace halbench::app
