#include "app/procedures/calibrate/ellipse_shape.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

TEST(EllipseShapeTest, withoutAPhaseErrorTheRadiiAreTheAmplitudes) {
    const EllipseAxes axes = ellipseAxes({0.1, 0.2, 0.5, 0.0, 3.0});
    EXPECT_NEAR(axes.large, 3.0, 1e-12);
    EXPECT_NEAR(axes.small, 1.5, 1e-12);
}

TEST(EllipseShapeTest, theRadiiAreTheFarthestAndTheNearestPointOfTheCurve) {
    const control::HallEllipse ellipse{-0.3, 0.7, 0.8, 0.4, 2.0};
    const EllipseAxes axes = ellipseAxes(ellipse);
    const EllipseCurve curve = ellipseCurve(ellipse, 100000);
    double farthest = 0.0;
    double nearest = 1e9;
    for (std::size_t i = 0; i < curve.a.size(); ++i) {
        const double radius = std::hypot(curve.a[i] + 0.3, curve.b[i] - 0.7);
        farthest = std::max(farthest, radius);
        nearest = std::min(nearest, radius);
    }
    // A step of 6e-5 rad misses an extreme by the square of that.
    EXPECT_NEAR(axes.large, farthest, 1e-8);
    EXPECT_NEAR(axes.small, nearest, 1e-8);
    EXPECT_NEAR(curve.a.front(), curve.a.back(), 1e-12); // closed
    EXPECT_NEAR(curve.b.front(), curve.b.back(), 1e-12);
}

} // namespace
} // namespace halbench::app
