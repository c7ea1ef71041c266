#include "control/base/sample_block.h"

#include <gtest/gtest.h>

namespace halbench {
namespace {

std::shared_ptr<const StreamLayout> twoColumns() {
    return std::make_shared<StreamLayout>(StreamLayout{{{"position", "rad"}, {"hall.a", "T"}}, 0.01});
}

SampleBlock block(double start_s, std::vector<double> values, std::uint64_t lost = 0) {
    SampleBlock result;
    result.layout = twoColumns();
    result.values = std::move(values);
    for (std::size_t row = 0; row < result.values.size() / 2; ++row) {
        result.time_s.push_back(start_s + 0.01 * static_cast<double>(row));
    }
    result.lostRows = lost;
    return result;
}

TEST(SampleBlock, valuesAreRowAfterRow) {
    const SampleBlock sample = block(0.0, {1.0, 2.0, 3.0, 4.0});
    EXPECT_EQ(sample.rows(), 2U);
    EXPECT_EQ(sample.value(1, 0), 3.0);
    EXPECT_EQ(sample.value(0, 1), 2.0);
}

TEST(StreamLayout, findsColumnsByName) {
    EXPECT_EQ(twoColumns()->indexOf("hall.a"), 1);
    EXPECT_EQ(twoColumns()->indexOf("hall.b"), -1);
}

TEST(Recording, joinsBlocksAndAddsUpWhatWasLost) {
    Recording recording;
    recording.append(block(0.0, {1.0, 2.0, 3.0, 4.0}));
    recording.append(block(0.05, {5.0, 6.0}, 3));
    EXPECT_EQ(recording.rows(), 3U);
    EXPECT_EQ(recording.lostRows, 3U);
    EXPECT_EQ(recording.column("position"), (std::vector<double>{1.0, 3.0, 5.0}));
    EXPECT_EQ(recording.column("hall.a"), (std::vector<double>{2.0, 4.0, 6.0}));
}

TEST(Recording, columnThatIsNotThereIsEmpty) {
    Recording recording;
    EXPECT_TRUE(recording.column("position").empty()); // nothing recorded, not even a layout
    recording.append(block(0.0, {1.0, 2.0}));
    EXPECT_TRUE(recording.column("speed").empty());
}

} // namespace
} // namespace halbench
