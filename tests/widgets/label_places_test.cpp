#include "widgets/label_places.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::widgets {
namespace {

const QRectF Canvas(100.0, 50.0, 300.0, 120.0);
const QSizeF Label(40.0, 14.0);

TEST(LabelPlaces, atARowAreAboveAndBelowItsEnds) {
    const auto places = placesAtRow(Canvas, 110.0, Label);
    ASSERT_EQ(places.size(), 4U);
    EXPECT_GT(places[0].left(), Canvas.center().x()) << "the right end first";
    EXPECT_LT(places[2].right(), Canvas.center().x());
    for (const QRectF& place : places) {
        EXPECT_TRUE(Canvas.contains(place));
        EXPECT_EQ(place.size(), Label);
        EXPECT_TRUE(place.bottom() < 110.0 || place.top() > 110.0) << "the line stays in sight";
    }
}

TEST(LabelPlaces, atAColumnFillItsSidesWithoutOverlap) {
    const auto places = placesAtColumn(Canvas, 200.0, Label);
    EXPECT_LT(places[0].bottom(), Canvas.center().y()) << "the top first";
    EXPECT_GT(places[2].top(), Canvas.center().y()) << "then the bottom";
    ASSERT_GT(places.size(), 8U);
    for (const QRectF& place : places) {
        EXPECT_TRUE(place.right() < 200.0 || place.left() > 200.0);
        EXPECT_GE(place.top(), Canvas.top());
    }
    for (std::size_t i = 6; i < places.size(); ++i) { // the rows between the first and the last
        EXPECT_FALSE(places[i].intersects(places[i - 2])) << "the row above";
        EXPECT_FALSE(places[i].intersects(places[0]) || places[i].intersects(places[1]));
    }
}

} // namespace
} // namespace halbench::widgets
