#include "control/base/random.h"
#include "widgets/figure/label_places.h"

#include <qwt_scale_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// Second route: each segment's own rectangle, made for each question.
TEST(LabelPlaces, aPlaceIsOnACurveWhereTheBoxOfOneOfItsSegmentsIs) {
    QwtScaleMap x;
    x.setScaleInterval(0.0, 10.0);
    x.setPaintInterval(100.0, 400.0);
    QwtScaleMap y;
    y.setScaleInterval(-1.0, 1.0);
    y.setPaintInterval(170.0, 50.0);
    std::vector<Curve> curves(3);
    for (int i = 0; i <= 40; ++i) {
        curves[0].x.push_back(0.25 * i);
        curves[0].y.push_back(std::sin(0.25 * i));
        curves[1].x.push_back(5.0 + 0.1 * i);
        curves[1].y.push_back(0.9 - 0.01 * i);
    }
    curves[2] = {{}, {0.0, 10.0, 10.0, 0.0}, {-1.0, -1.0, 1.0, 1.0}, CurveStyle::Band, {}};
    const std::vector<QRectF> boxes = boxesWithin({0.0, 0.0, 500.0, 500.0}, curves, x, y);
    EXPECT_EQ(boxes.size(), 80U); // a band does not keep a label away
    Random random(5);
    int on = 0;
    for (int round = 0; round < 500; ++round) {
        const QRectF place(QPointF(100.0 + 300.0 * random.uniform(), 50.0 + 120.0 * random.uniform()),
                           QSizeF(20.0, 8.0));
        bool isOn = false;
        for (std::size_t curve = 0; curve < 2; ++curve) {
            for (std::size_t i = 0; i + 1 < curves[curve].x.size(); ++i) {
                const QPointF from(x.transform(curves[curve].x[i]), y.transform(curves[curve].y[i]));
                const QPointF to(x.transform(curves[curve].x[i + 1]), y.transform(curves[curve].y[i + 1]));
                isOn = isOn || QRectF(from, to).normalized().adjusted(-1.0, -1.0, 1.0, 1.0).intersects(place);
            }
        }
        EXPECT_EQ(isOnCurve(place, boxes), isOn) << round;
        const QRectF around = place.adjusted(-30.0, -10.0, 5.0, 20.0);
        EXPECT_EQ(isOnCurve(place, boxesWithin(around, curves, x, y)), isOn) << round;
        on += isOn ? 1 : 0;
    }
    EXPECT_GT(on, 50);
    EXPECT_LT(on, 450);
}

} // namespace
} // namespace halbench::widgets
