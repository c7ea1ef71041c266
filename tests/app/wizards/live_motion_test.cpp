#include "app/wizards/live_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

SampleBlock blockOf(const std::vector<std::string>& names, std::vector<double> time_s,
                    std::vector<double> values) {
    auto layout = std::make_shared<StreamLayout>();
    for (const std::string& name : names) {
        layout->columns.push_back({name, ""});
    }
    SampleBlock block;
    block.layout = layout;
    block.time_s = std::move(time_s);
    block.values = std::move(values);
    return block;
}

TEST(LiveMotionTest, keepsRowsWithFieldsAndTheirLatestValues) {
    LiveMotion motion;
    EXPECT_FALSE(motion.latest("field.0.r"));
    motion.take(blockOf({"hall.a"}, {0.0}, {0.1}));
    EXPECT_EQ(motion.rows().rows(), 0U);
    const std::vector<std::string> names = {"field.0.r", "orientation.w", "orientation.x", "orientation.y",
                                            "orientation.z"};
    // Upright, then a quarter turn about Z: w = z = sqrt(1/2).
    const double half = std::sqrt(0.5);
    motion.take(blockOf(names, {1.0, 3.5}, {0.1, 1.0, 0.0, 0.0, 0.0, 0.1, half, 0.0, 0.0, half}));
    EXPECT_EQ(motion.rows().rows(), 2U);
    EXPECT_DOUBLE_EQ(motion.elapsed_s(), 2.5);
    EXPECT_EQ(motion.latest("orientation.z"), half);
    EXPECT_FALSE(motion.latest("orientation.fresh")); // no such column
    motion.take(blockOf(names, {4.0}, {0.1, std::nan(""), 0.0, 0.0, 0.0}));
    EXPECT_FALSE(motion.latest("orientation.w")); // the board determined none
}

} // namespace
} // namespace halbench::app
