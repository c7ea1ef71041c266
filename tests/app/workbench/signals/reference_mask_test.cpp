#include "app/workbench/signals/reference_mask.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

SampleBlock blockWith(std::vector<StreamLayout::Column> columns, std::vector<double> values) {
    SampleBlock block;
    block.layout = std::make_shared<StreamLayout>(StreamLayout{std::move(columns), 0.001});
    block.values = std::move(values);
    for (std::size_t row = 0; row < block.values.size() / block.layout->columns.size(); ++row) {
        block.time_s.push_back(0.001 * static_cast<double>(row));
    }
    return block;
}

BlockColumns shownOf(const SampleBlock& block, bool isAngle) {
    devices::Catalogue catalogue;
    catalogue.signals.resize(2);
    catalogue.signals[0].name = "ref";
    catalogue.signals[0].role = "reference";
    catalogue.signals[1].name = "state";
    catalogue.signals[1].role = "status";
    BlockColumns columns;
    hideReferenceMask(columns, block, catalogue, isAngle);
    return columns;
}

TEST(ReferenceMask, isAGapWhileTheBoardIsNotArmedAndNothingElseChanges) {
    // idle, armed, stopped
    const SampleBlock block =
        blockWith({{"ref", "rad"}, {"speed", "rad/s"}, {"state", ""}}, {0, 5, 0, 1.5, 6, 1, 0, 7, 2});
    const BlockColumns shown = shownOf(block, true);
    EXPECT_TRUE(std::isnan(shown.value(block, 0, 0)));
    EXPECT_EQ(shown.value(block, 1, 0), 1.5);
    EXPECT_TRUE(std::isnan(shown.value(block, 2, 0)));
    EXPECT_EQ(shown.value(block, 0, 1), 5.0);
    EXPECT_EQ(block.value(0, 0), 0.0); // recordings get what the board sent
}

TEST(ReferenceMask, isAGapUntilTheModeUsesItAndWhereItIsNoAngle) {
    // The board arms, and computes its first reference in the next cycle of its position loop.
    const SampleBlock block = blockWith({{"ref", "rad"}, {"state", ""}}, {0, 0, 0, 1, 62.5, 1});
    const BlockColumns shown = shownOf(block, true);
    EXPECT_TRUE(std::isnan(shown.value(block, 1, 0)));
    EXPECT_EQ(shown.value(block, 2, 0), 62.5);
    EXPECT_TRUE(std::isnan(shownOf(block, false).value(block, 2, 0))); // ampere
}

TEST(ReferenceMask, staysWhereTheBoardsStateIsNotKnown) {
    const SampleBlock block = blockWith({{"ref", "rad"}}, {0.0, 1.0});
    EXPECT_TRUE(shownOf(block, true).replaced.empty());
    BlockColumns columns;
    hideReferenceMask(columns, blockWith({{"ref", "rad"}, {"state", ""}}, {0, 0}), {}, true);
    EXPECT_TRUE(columns.replaced.empty());
}

} // namespace
} // namespace halbench::app
