#include "control/signals/plane_path.h"
#include "tests/control/signals/random_travels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace halbench::control {
namespace {

TEST(TravelProfile, keepsItsLimitsWithoutJumpsAndArrivesOverManyRandomMoves) {
    expectTravels(1, 20000);
}

// Second route to position, speed and acceleration: the jerk integrated by its definition, in small steps.
TEST(TravelProfile, isTheIntegralOfItsJerk) {
    Random random(2);
    int tried = 0;
    while (tried < 40) {
        const RandomMove move = randomMove(random);
        const auto profile = TravelProfile::solve(move.distance, move.limits);
        ASSERT_TRUE(profile);
        if (profile->ramp_s() < 0.1 * profile->duration_s()) {
            continue; // too few steps would fall into the ramps
        }
        ++tried;
        constexpr int Steps = 20000;
        const double step_s = profile->duration_s() / Steps;
        TravelPoint sum;
        for (int k = 0; k < Steps; ++k) {
            // Acceleration is linear but for steps in which a corner lies, Simpson's rule is exact elsewhere.
            const double time_s = k * step_s;
            const double before = profile->at(time_s + 1e-9 * step_s).acceleration;
            const double middle = profile->at(time_s + 0.5 * step_s).acceleration;
            const double after = profile->at(time_s + (1.0 - 1e-9) * step_s).acceleration;
            sum.value += sum.speed * step_s + step_s * step_s * (before + 2.0 * middle) / 6.0;
            sum.speed += step_s * (before + 4.0 * middle + after) / 6.0;
        }
        // At each of six corners up to a step of the ramp's at least 2000 is wrong.
        constexpr double Slack = 6.0 / 2000.0;
        EXPECT_NEAR(sum.value / move.distance, 1.0, Slack);
        EXPECT_NEAR(sum.speed, 0.0, Slack * std::fabs(profile->peakSpeed()));
    }
}

TEST(TravelProfile, hasTheDurationsOfTheBook) {
    // Trapezoid: d/v + v/a; the travels of figures 19 and 20 (resources/help/planar-theory.md section 10).
    EXPECT_NEAR(TravelProfile::solve(0.05, {0.10512, 0.438, {}})->duration_s(), 0.05 / 0.10512 + 0.24, 1e-12);
    EXPECT_NEAR(TravelProfile::solve(0.05, {0.10512, 0.438, {}})->ramp_s(), 0.24, 1e-12);
    // All seven pieces: d/v + v/a + a/j.
    EXPECT_NEAR(TravelProfile::solve(-1.0, {0.5, 2.0, 10.0})->duration_s(), 2.0 + 0.25 + 0.2, 1e-12);
    // Jerks alone: 4 (d/2j)^(1/3).
    EXPECT_NEAR(TravelProfile::solve(2e-6, {1.0, 10.0, 1.0})->duration_s(), 4.0 * 0.01, 1e-12);
}

TEST(TravelProfile, refusesLimitsThatNothingCanMoveBy) {
    EXPECT_EQ(TravelProfile::solve(0.0, {1.0, 1.0, 1.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TravelProfile::solve(1.0, {0.0, 1.0, 1.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TravelProfile::solve(1.0, {1.0, -1.0, 1.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TravelProfile::solve(1.0, {1.0, 1.0, 0.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TravelProfile::solve(std::nan(""), {1.0, 1.0, 1.0}).error().code, ErrorCode::NotFinite);
}

PlanePathConfig circle(double radius, const TravelLimits& limits, int turns = 2) {
    PlanePathConfig config;
    config.radius = radius;
    config.turns = turns;
    config.limits = limits;
    return config;
}

// Differences over h instead of the path's own derivatives; their error is h^2/24 of the next derivative, and
// at a corner of the profile half a step's change: 1 % covers both at 1/2000 of the travel.
TEST(PlanePath, keepsItsLimitsOnACircleAsVectors) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        TravelLimits limits{decades(random, -3.0, 0.0), decades(random, -1.0, 1.0), {}};
        if (i % 2 == 0) {
            limits.jerk = decades(random, 0.0, 3.0);
        }
        const auto path = PlanePath::make(circle(decades(random, -5.0, -1.5), limits, 1), 1e-3);
        ASSERT_TRUE(path);
        constexpr int Steps = 2000;
        const double h = path->duration_s() / Steps;
        for (int k = 0; k <= Steps; ++k) {
            const PlanePoint point = path->at(k * h);
            ASSERT_LE(std::hypot(point[0].speed, point[1].speed), limits.speed * (1.0 + 1e-10));
            ASSERT_LE(std::hypot(point[0].acceleration, point[1].acceleration),
                      limits.acceleration * (1.0 + 1e-10));
            const PlanePoint next = path->at((k + 1) * h);
            const double jerk = std::hypot(next[0].acceleration - point[0].acceleration,
                                           next[1].acceleration - point[1].acceleration) /
                                h;
            if (limits.jerk) {
                ASSERT_LE(jerk, *limits.jerk * 1.01) << i;
            }
            ASSERT_NEAR((next[0].value - point[0].value) / h, 0.5 * (point[0].speed + next[0].speed),
                        0.01 * limits.speed + 0.5 * h * limits.acceleration);
        }
        EXPECT_NEAR(path->at(path->duration_s()).front().value, 0.0, 1e-12);
        EXPECT_NEAR(path->at(path->duration_s()).back().value, 0.0, 1e-12);
    }
}

TEST(PlanePath, circleTurnsCounterClockwiseAroundItsCentre) {
    for (const double radius : {0.01, -0.01}) {
        const auto path = PlanePath::make(circle(radius, {0.05, 1.0, 100.0}), 1e-3);
        ASSERT_TRUE(path);
        double turned = 0.0;
        PlanePoint before = path->at(0.0);
        for (double time_s = 0.0; time_s < path->duration_s(); time_s += 1e-3) {
            const PlanePoint point = path->at(time_s);
            EXPECT_NEAR(std::hypot(point[0].value - radius, point[1].value), 0.01, 1e-15);
            // Angle by the cross product of the two arms: positive is counter-clockwise.
            turned += std::asin(
                ((before[0].value - radius) * point[1].value - before[1].value * (point[0].value - radius)) /
                (0.01 * 0.01));
            before = point;
        }
        EXPECT_NEAR(turned, 4.0 * 3.14159265358979, 1e-3);
    }
}

TEST(PlanePath, rasterGoesForthAndBackFromLineToLine) {
    PlanePathConfig config;
    config.shape = PlanePathConfig::Shape::Raster;
    config.width = 2e-3;
    config.pitch = -1e-4;
    config.lines = 3;
    config.limits = {0.01, 1.0, {}};
    const auto path = PlanePath::make(config, 1e-3);
    ASSERT_TRUE(path);
    // A line: 2e-3/0.01 + 0.01/1 = 0.21 s; a step of 1e-4 is just the triangle, 2 sqrt(1e-4) = 0.02 s.
    EXPECT_NEAR(path->duration_s(), 3 * 0.21 + 2 * 0.02, 1e-9);
    const std::array<std::array<double, 3>, 6> corners = {{{0.0, 0.0, 0.0},
                                                           {0.21, 2e-3, 0.0},
                                                           {0.23, 2e-3, -1e-4},
                                                           {0.44, 0.0, -1e-4},
                                                           {0.46, 0.0, -2e-4},
                                                           {0.67, 2e-3, -2e-4}}};
    for (const auto& [time_s, x, y] : corners) {
        EXPECT_NEAR(path->at(time_s)[0].value, x, 1e-12) << time_s;
        EXPECT_NEAR(path->at(time_s)[1].value, y, 1e-12) << time_s;
        EXPECT_NEAR(path->at(time_s)[0].speed, 0.0, 1e-9) << time_s;
    }
    EXPECT_NEAR(path->span()[0].reach(), 2e-3, 1e-15);
    EXPECT_NEAR(path->span()[1].reach(), 2e-4, 1e-15);
}

PlanePathConfig arc(double radius, double angle_rad, double heading_rad) {
    PlanePathConfig config;
    config.shape = PlanePathConfig::Shape::Arc;
    config.radius = radius;
    config.angle_rad = angle_rad;
    config.heading_rad = heading_rad;
    config.limits = {0.05, 1.0, 100.0};
    return config;
}

// Second route: a wheel that rolls by its speed and is steered by speed over radius, by the midpoint rule;
// its error is h^2/24 of the third derivative, below 1e-6 of the radius at 20 000 steps.
TEST(PlanePath, arcIsWhatAWheelRollsThatIsSteeredByItsRadius) {
    Random random(5);
    for (int i = 0; i < 60; ++i) {
        const double radius = decades(random, -4.0, -1.5);
        const double angle = (i % 2 == 0 ? 1.0 : -1.0) * decades(random, -1.0, 1.0);
        const double heading = 0.5 * i;
        const auto path = PlanePath::make(arc(radius, angle, heading), 1e-3);
        ASSERT_TRUE(path) << path.error().message;
        const double h = path->duration_s() / 20000.0;
        double direction = heading;
        double x = 0.0;
        double y = 0.0;
        std::array<double, 2> reach = {0.0, 0.0};
        for (int k = 0; k < 20000; ++k) {
            const PlanePoint middle = path->at((k + 0.5) * h);
            const double way = std::hypot(middle[0].speed, middle[1].speed) * h;
            const double turn = (angle > 0.0 ? 1.0 : -1.0) * way / radius;
            x += way * std::cos(direction + 0.5 * turn);
            y += way * std::sin(direction + 0.5 * turn);
            direction += turn;
            reach = {std::max(reach[0], std::fabs(x)), std::max(reach[1], std::fabs(y))};
            if (k % 2000 == 0) {
                const PlanePoint point = path->at((k + 1.0) * h);
                ASSERT_NEAR(point[0].value, x, 1e-5 * radius) << i;
                ASSERT_NEAR(point[1].value, y, 1e-5 * radius) << i;
                ASSERT_LE(std::hypot(point[0].acceleration, point[1].acceleration), 1.0 + 1e-10);
            }
        }
        EXPECT_NEAR(direction - heading, angle, 1e-5);
        EXPECT_NEAR(path->span()[0].reach(), reach[0], 1e-5 * radius) << i;
        EXPECT_NEAR(path->span()[1].reach(), reach[1], 1e-5 * radius) << i;
    }
}

// Second route: the nearest of 4000 points of the path, which lie at most 10 rad/4000 of a radius apart.
TEST(PlanePath, contourErrorOfAnArcIsTheDistanceFromItsNearestPoint) {
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        const double angle = (i % 2 == 0 ? 1.0 : -1.0) * decades(random, -1.0, 1.0);
        const double radius = 0.01;
        const auto path = PlanePath::make(arc(radius, angle, 0.7 * i), 1e-3);
        ASSERT_TRUE(path);
        const double x = 0.03 * (random.uniform() - 0.5);
        const double y = 0.03 * (random.uniform() - 0.5);
        double nearest = 1.0;
        for (int k = 0; k <= 4000; ++k) {
            const PlanePoint point = path->at(path->duration_s() * k / 4000.0);
            nearest = std::min(nearest, std::hypot(point[0].value - x, point[1].value - y));
        }
        EXPECT_NEAR(path->distanceFrom(x, y), nearest, 1e-4 * radius) << i;
    }
}

TEST(PlanePath, lineGoesInItsDirection) {
    PlanePathConfig config;
    config.shape = PlanePathConfig::Shape::Line;
    config.length = 5e-3;
    config.heading_rad = std::atan2(-4.0, 3.0);
    config.limits = {0.01, 1.0, {}};
    const auto path = PlanePath::make(config, 1e-3);
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->duration_s(), 0.51, 1e-9); // 5e-3/0.01 + 0.01/1 s
    const PlanePoint end = path->at(0.51);
    EXPECT_NEAR(end[0].value, 3e-3, 1e-12); // 3, 4, 5
    EXPECT_NEAR(end[1].value, -4e-3, 1e-12);
    EXPECT_NEAR(path->at(0.25)[1].speed, -0.008, 1e-12);
    EXPECT_NEAR(path->span()[1].reach(), 4e-3, 1e-15);
    EXPECT_NEAR(path->distanceFrom(3e-3 + 4e-5, -4e-3 + 3e-5), 5e-5, 1e-12); // across its end
    EXPECT_NEAR(path->distanceFrom(6e-3, -8e-3), 5e-3, 1e-12);               // as far again beyond it
}

TEST(PlanePath, contourErrorIsTheDistanceFromTheNearestPointOfThePath) {
    const auto round = PlanePath::make(circle(0.01, {0.05, 1.0, {}}), 1e-3);
    ASSERT_TRUE(round);
    EXPECT_NEAR(round->distanceFrom(0.01, 0.0), 0.01, 1e-15);
    EXPECT_NEAR(round->distanceFrom(0.023, 0.0), 3e-3, 1e-15);
    EXPECT_NEAR(round->distanceFrom(0.0, 0.0), 0.0, 1e-15);
    PlanePathConfig config;
    config.shape = PlanePathConfig::Shape::Raster;
    config.width = 2e-3;
    config.pitch = 1e-4;
    config.lines = 2;
    config.limits = {0.01, 1.0, {}};
    const auto raster = PlanePath::make(config, 1e-3);
    ASSERT_TRUE(raster);
    EXPECT_NEAR(raster->distanceFrom(1e-3, 2e-5), 2e-5, 1e-15);    // above the first line
    EXPECT_NEAR(raster->distanceFrom(1e-3, 7e-5), 3e-5, 1e-15);    // below the second
    EXPECT_NEAR(raster->distanceFrom(2.03e-3, 5e-5), 3e-5, 1e-15); // beside the step between them
    EXPECT_NEAR(raster->distanceFrom(-3e-5, -4e-5), 5e-5, 1e-15);  // off the start: 3, 4, 5
}

TEST(PlanePath, refusesAPathWithoutASize) {
    EXPECT_EQ(PlanePath::make(circle(0.0, {1.0, 1.0, {}}), 1e-3).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(PlanePath::make(circle(0.1, {1.0, 1.0, {}}, 0), 1e-3).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(PlanePath::make(circle(0.1, {1.0, 0.0, {}}), 1e-3).error().code, ErrorCode::OutOfRange);
    PlanePathConfig raster;
    raster.shape = PlanePathConfig::Shape::Raster;
    raster.width = 1e-3;
    raster.lines = 2;
    raster.limits = {1.0, 1.0, {}};
    EXPECT_EQ(PlanePath::make(raster, 1e-3).error().code, ErrorCode::OutOfRange); // no pitch
    EXPECT_EQ(PlanePath::make(arc(0.01, 0.0, 0.0), 1e-3).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(PlanePath::make(arc(0.01, std::nan(""), 0.0), 1e-3).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(PlanePath::make(arc(0.01, 1.0, std::nan("")), 1e-3).error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::control
