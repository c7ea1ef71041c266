#include "control/base/block_columns.h"

#include <gtest/gtest.h>

namespace halbench {
namespace {

SampleBlock twoColumns() {
    SampleBlock block;
    block.layout = std::make_shared<StreamLayout>(StreamLayout{{{"a", "A"}, {"b", "A"}}, 0.001});
    block.time_s = {0.0, 0.001};
    block.values = {1.0, 2.0, 3.0, 4.0};
    return block;
}

std::vector<double> rowsOf(const BlockColumns& columns, const SampleBlock& block) {
    std::vector<double> rows;
    for (std::size_t row = 0; row < block.rows(); ++row) {
        for (const ColumnSource& source : columns.sources(block)) {
            rows.push_back(source.values[row * source.stride]);
        }
    }
    return rows;
}

TEST(BlockColumns, areTheBlocksOwnUnlessSomethingElseIsSaid) {
    const SampleBlock block = twoColumns();
    EXPECT_EQ(rowsOf({}, block), block.values);
    EXPECT_EQ(BlockColumns().value(block, 1, 0), 3.0);
}

TEST(BlockColumns, replacedOnesStandInTheirPlaceAndAddedOnesBehind) {
    const SampleBlock block = twoColumns();
    BlockColumns columns;
    columns.replaced[0] = {-1.0, -3.0};
    columns.added = {{10.0, 30.0}};
    EXPECT_EQ(rowsOf(columns, block), (std::vector<double>{-1.0, 2.0, 10.0, -3.0, 4.0, 30.0}));
    EXPECT_EQ(columns.value(block, 1, 0), -3.0);
    EXPECT_EQ(columns.value(block, 1, 1), 4.0);
}

} // namespace
} // namespace halbench
