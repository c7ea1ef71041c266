#include "control/design/direct_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

using Point = DirectSearch::Point;

double distance(const Point& one, const Point& other) {
    return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

// A valley that is bent and a hundred times longer than wide (Rosenbrock's, in three dimensions): 1, 1, 1.
TEST(DirectSearch, findsTheEndOfABentValley) {
    const auto valley = [](const Point& p) {
        const auto part = [](double x, double y) {
            return 100.0 * std::pow(y - x * x, 2) + std::pow(1.0 - x, 2);
        };
        return 1.0 + part(p[0], p[1]) + part(p[1], p[2]);
    };
    DirectSearch search(valley);
    Point point = {-1.2, 1.0, 0.5};
    for (int i = 0; i < 10; ++i) {
        point = search.from(point, 0.5);
    }
    EXPECT_LT(distance(point, {1.0, 1.0, 1.0}), 0.01); // where a relative 1e-6 of the value is left
    EXPECT_EQ(search.best(), valley(point));
}

TEST(DirectSearch, staysOutsideOfWhatIsInfinite) {
    DirectSearch search(
        [](const Point& p) { return p[0] < 2.0 ? HUGE_VAL : 1.0 + p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; });
    Point point = {4.0, 1.0, 1.0};
    for (int i = 0; i < 10; ++i) {
        point = search.from(point, 0.5);
    }
    EXPECT_GE(point[0], 2.0);
    EXPECT_LT(distance(point, {2.0, 0.0, 0.0}), 0.1);
}

// |x + y - 1| steep, the rest flat: a simplex collapses on that kink, the steps go along it to 0.5, 0.5, 0.
TEST(DirectSearch, goesOnAlongAKink) {
    const auto kinked = [](const Point& p) {
        return 1.0 + 1e3 * std::abs(p[0] + p[1] - 1.0) + std::pow(p[0] - p[1], 2) + std::abs(p[2]);
    };
    const Point point = polished(kinked, {1.0, 0.0, 0.25}, 0.125, 1e-4);
    EXPECT_LT(distance(point, {0.5, 0.5, 0.0}), 1e-3);
}

} // namespace
} // namespace halbench::control
