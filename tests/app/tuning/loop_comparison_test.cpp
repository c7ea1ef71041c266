#include "app/tuning/loop_comparison.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

ComparedLoop loop(const std::string& path, double phaseMargin_deg) {
    ComparedLoop result;
    result.path = path;
    result.gains.method = "lambda";
    result.result.isStable = true;
    result.result.margins.phaseMargin_deg = phaseMargin_deg;
    result.result.margins.gainMargin_ratio = std::numeric_limits<double>::infinity();
    return result;
}

TEST(LoopComparison, aColumnAFileUnderItsName) {
    const std::string table = comparisonTable({loop("a/fast.json", 41.5), loop("b/slow.json", 60.25)});
    const std::size_t row = table.find("phase margin [deg]");
    ASSERT_NE(row, std::string::npos) << table;
    const std::size_t first = table.find("41.5", row);
    EXPECT_LT(table.find("fast"), table.find("slow"));
    EXPECT_LT(first, table.find("60.25", row));
    EXPECT_LT(table.find("60.25", row), table.find('\n', row));
}

TEST(LoopComparison, filesOfTheSameNameAreToldApart) {
    const std::string table = comparisonTable({loop("a/gains.json", 1.0), loop("b/gains.json", 2.0)});
    EXPECT_NE(table.find("a/gains.json"), std::string::npos) << table;
    EXPECT_NE(table.find("b/gains.json"), std::string::npos);
}

TEST(LoopComparison, whatIsUnboundedIsNoNumber) {
    const std::string table = comparisonTable({loop("a.json", 1.0)});
    const std::size_t row = table.find("gain margin");
    ASSERT_NE(row, std::string::npos);
    EXPECT_LT(table.find("none", row), table.find('\n', row)) << table;
    const JsonValue list = comparedLoops({loop("a.json", 1.0)});
    ASSERT_EQ(list.items().size(), 1U);
    EXPECT_TRUE(list.items()[0].find("margins")->find("gain_margin_ratio")->isNull());
    EXPECT_EQ(list.items()[0].find("gains_file")->text(), "a.json");
    EXPECT_EQ(list.items()[0].find("data_quality")->find("verdict")->text(), "good");
}

} // namespace
} // namespace halbench::app
