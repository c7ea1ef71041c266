#include "app/workbench/signals/last_rows.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace halbench::app {
namespace {

/// Ten seconds at 100 Hz; the second signal is missing in every second row.
control::SampleHistory counted() {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"count", "A"}, {"half", "V"}};
    layout->period_s = 0.01;
    SampleBlock block;
    block.layout = layout;
    for (int row = 0; row < 1000; ++row) {
        block.time_s.push_back(0.01 * row);
        block.values.push_back(row);
        block.values.push_back(row % 2 == 0 ? -row : std::numeric_limits<double>::quiet_NaN());
    }
    control::SampleHistory history(std::size_t{1} << 24);
    history.append(block);
    return history;
}

TEST(LastRowsTest, takesRowsInWhichAllSignalsHaveAValue) {
    const Recording rows = lastRows(counted(), {"half", "count"}, 1.0, 100000);
    ASSERT_EQ(rows.layout->columns.size(), 2U);
    EXPECT_EQ(rows.layout->columns[0].name, "half");
    EXPECT_EQ(rows.layout->columns[0].unit, "V");
    ASSERT_EQ(rows.rows(), 50U); // rows 900 to 998, the even ones
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        EXPECT_EQ(rows.values[2 * row + 1], 900.0 + 2.0 * static_cast<double>(row));
        EXPECT_EQ(rows.values[2 * row], -rows.values[2 * row + 1]);
    }
}

TEST(LastRowsTest, withoutOneOfTheSignalsThereAreNoRows) {
    EXPECT_EQ(lastRows(counted(), {"count", "nobody"}, 1.0, 100).rows(), 0U);
    EXPECT_EQ(lastRows(counted(), {}, 1.0, 100).rows(), 0U);
}

TEST(LastRowsTest, takesNoMoreRowsThanItMay) {
    const Recording rows = lastRows(counted(), {"count"}, 1e6, 50);
    EXPECT_LE(rows.rows(), 52U);
    EXPECT_GE(rows.rows(), 48U);
    EXPECT_EQ(rows.values.back(), 999.0);
}

} // namespace
} // namespace halbench::app
