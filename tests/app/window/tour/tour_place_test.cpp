#include "app/window/tour/tour_place.h"

#include <QSize>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

constexpr QRect Room(0, 60, 952, 410);
constexpr QSize Card(340, 150);
constexpr QRect StopInBar(860, 20, 88, 40); // above the room

TEST(TourPlace, standsInTheLowerLeftCornerOfATargetThatFillsTheRoom) {
    const QRect card = cardPlace(Room, Room, StopInBar, Card);
    EXPECT_EQ(card.size(), Card);
    EXPECT_TRUE(Room.contains(card));
    EXPECT_LT(card.center().x(), Room.center().x());
    EXPECT_GT(card.center().y(), Room.center().y());
}

TEST(TourPlace, standsBelowATargetThatLeavesRoomForIt) {
    const QRect list(8, 70, 300, 150);
    const QRect card = cardPlace(Room, list, StopInBar, Card);
    EXPECT_GT(card.top(), list.bottom());
    EXPECT_LT(card.top(), list.bottom() + 20);
    EXPECT_TRUE(Room.contains(card));
    const QRect title(90, 2, 40, 20); // of a menu, above the room
    EXPECT_LT(cardPlace(Room, title, StopInBar, Card).top(), Room.top() + 20);
    EXPECT_TRUE(Room.contains(cardPlace(Room, title, StopInBar, Card)));
}

TEST(TourPlace, leavesATargetFreeWhereThereIsACornerBesideIt) {
    const QRect left(0, 60, 400, 410);
    EXPECT_FALSE(cardPlace(Room, left, StopInBar, Card).intersects(left));
    const QRect bottom(0, 260, 952, 210);
    EXPECT_FALSE(cardPlace(Room, bottom, StopInBar, Card).intersects(bottom));
}

TEST(TourPlace, neverCoversStopWhereverItIs) {
    for (int x = 0; x + 88 <= Room.right(); x += 24) {
        for (int y = Room.top(); y + 40 <= Room.bottom(); y += 24) {
            const QRect stop(x, y, 88, 40);
            const QRect card = cardPlace(Room, Room, stop, Card);
            EXPECT_FALSE(card.intersects(stop)) << x << ", " << y;
            EXPECT_TRUE(Room.contains(card)) << x << ", " << y;
        }
    }
}

TEST(TourPlace, staysInARoomThatIsSmallerThanTheCard) {
    const QRect small(10, 60, 200, 100);
    EXPECT_TRUE(small.contains(cardPlace(small, small, StopInBar, Card)));
}

TEST(TourPlace, movesAsideOfAStopThatNoCornerAvoids) {
    const QRect narrow(0, 0, 350, 160);
    const QRect stop(250, 60, 88, 40); // in every corner's way
    EXPECT_FALSE(cardPlace(narrow, narrow, stop, Card).intersects(stop));
}

} // namespace
} // namespace halbench::app
