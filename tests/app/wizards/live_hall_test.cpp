#include "app/wizards/live_hall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

SampleBlock blockOf(std::vector<StreamLayout::Column> columns, double first_s, int rows) {
    SampleBlock block;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = std::move(columns);
    for (int i = 0; i < rows; ++i) {
        block.time_s.push_back(first_s + 0.01 * i);
        for (std::size_t column = 0; column < layout->columns.size(); ++column) {
            block.values.push_back(0.1 + static_cast<double>(column));
        }
    }
    block.layout = layout;
    return block;
}

TEST(LiveHall, keepsTheNewestReadingsAndTheTimeOfEveryStream) {
    LiveHall live;
    live.take(blockOf({{"position", "rad"}}, 0.0, 100)); // time, but no point
    EXPECT_TRUE(live.points().empty());
    EXPECT_NEAR(live.elapsed_s(), 0.99, 1e-9);
    live.take(blockOf({{"hall.a", "T"}, {"hall.b", "T"}}, 5.0, 3000));
    ASSERT_EQ(live.points().size(), LiveHall::MostPoints);
    EXPECT_EQ(live.points().front().hall_a_T, 0.1);
    EXPECT_EQ(live.points().front().hall_b_T, 1.1);
    EXPECT_NEAR(live.elapsed_s(), 34.99, 1e-9);
}

TEST(LiveHall, theAxesOfItsPictureStayWhatTheyAre) {
    const widgets::Figure none = liveHallFigure({}, 0.2);
    const widgets::Figure some = liveHallFigure({{0.1, -0.1}}, 0.2);
    EXPECT_EQ(none.x.max, some.x.max);
    EXPECT_TRUE(none.isEqualScale);
    EXPECT_TRUE(some.isEqualScale);
    EXPECT_EQ(some.panels.front().y.min, -200.0); // mT
    EXPECT_NEAR(some.panels.front().curves.front().x.front(), 100.0, 1e-9);
}

} // namespace
} // namespace halbench::app
