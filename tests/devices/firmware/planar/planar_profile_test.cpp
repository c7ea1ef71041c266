#include "control/base/random.h"
#include "control/signals/plane_path.h"
#include "devices/firmware/planar/hb_planar_path.h"
#include "tests/devices/firmware/planar/random_board_travels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::firmware {
namespace {

constexpr float NoJerkLimit = INFINITY;

TEST(PlanarProfile, keepsItsLimitsAndArrivesAtRest) {
    struct Case {
        float distance, speed, acceleration;
        double duration_s; ///< d/v + v/a, or 2 sqrt(d/a) for a triangle
    };
    const Case cases[] = {{0.05F, 0.10512F, 0.438F, 0.05 / 0.10512 + 0.24},
                          {-0.05F, 0.16252F, 0.956F, 0.05 / 0.16252 + 0.17},
                          {0.002F, 1.0F, 0.5F, 2.0 * std::sqrt(0.002 / 0.5)}};
    for (const Case& c : cases) {
        hb_profile profile;
        const hb_profile_limits limits = {c.speed, c.acceleration, NoJerkLimit};
        hb_profile_start(&profile, 0.01F, c.distance, &limits);
        EXPECT_NEAR(static_cast<double>(hb_profile_duration_s(&profile)), c.duration_s, 1e-6);
        hb_reference_point previous = hb_profile_point(&profile);
        EXPECT_FLOAT_EQ(previous.value, 0.01F);
        int ticks = 0;
        for (; profile.running != 0 && ticks < 10000; ++ticks) {
            hb_profile_advance(&profile);
            const hb_reference_point point = hb_profile_point(&profile);
            // Trapezoid rule over a tick: exact but for the tick that a corner of the speed falls into.
            const float step = 0.0005F * (previous.speed + point.speed);
            ASSERT_NEAR(point.value - previous.value, step, c.acceleration * 0.3e-6F + 1e-8F) << ticks;
            ASSERT_LE(std::fabs(point.speed), c.speed * 1.00001F);
            ASSERT_LE(std::fabs(point.acceleration), c.acceleration * 1.00001F);
            previous = point;
        }
        EXPECT_NEAR(1e-3 * ticks, c.duration_s, 1e-3);
        EXPECT_FLOAT_EQ(previous.value, 0.01F + c.distance);
        EXPECT_EQ(previous.speed, 0.0F);
    }
}

// Second route: the solution in double precision (control/signals/travel_profile.h), tick by tick. Single
// precision resolves a position by 6e-8 of the distance; two dozen operations with it stay within 2e-6, and
// so do the limits.
TEST(PlanarProfile, isTheOneOfDoublePrecision) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const auto decades = [&random](double from, double to) {
            return std::pow(10.0, from + (to - from) * random.uniform());
        };
        const auto distance = static_cast<float>((i % 2 == 0 ? 1.0 : -1.0) * decades(-5.0, -1.0));
        hb_profile_limits limits = {static_cast<float>(decades(-2.0, 0.0)),
                                    static_cast<float>(decades(-1.0, 1.0)), NoJerkLimit};
        control::TravelLimits exact{
            static_cast<double>(limits.speed), static_cast<double>(limits.acceleration), {}};
        if (i % 3 != 0) {
            limits.jerk = static_cast<float>(decades(0.0, 3.0));
            exact.jerk = static_cast<double>(limits.jerk);
        }
        const auto wanted = control::TravelProfile::solve(static_cast<double>(distance), exact);
        ASSERT_TRUE(wanted);
        hb_profile profile;
        hb_profile_start(&profile, 0.0F, distance, &limits);
        ASSERT_NEAR(static_cast<double>(hb_profile_duration_s(&profile)) / wanted->duration_s(), 1.0, 2e-6);
        for (int tick = 0; profile.running != 0; ++tick, hb_profile_advance(&profile)) {
            const hb_reference_point point = hb_profile_point(&profile);
            const control::TravelPoint expected = wanted->at(1e-3 * tick);
            ASSERT_NEAR(static_cast<double>(point.value), expected.value,
                        4e-6 * std::fabs(static_cast<double>(distance)))
                << i << " at tick " << tick;
            ASSERT_LE(std::fabs(point.speed), limits.speed * 1.000002F);
            ASSERT_LE(std::fabs(point.acceleration), limits.acceleration * 1.000002F);
        }
        EXPECT_EQ(hb_profile_point(&profile).value, distance);
    }
}

TEST(PlanarProfile, keepsItsLimitsWithoutJumpsAndArrivesOverManyRandomMoves) {
    expectBoardTravels(1, 20000);
}

TEST(PlanarProfile, withoutLimitsDoesNotMove) {
    for (const hb_profile_limits limits :
         {hb_profile_limits{0.0F, 1.0F, 1.0F}, hb_profile_limits{1.0F, 0.0F, 1.0F},
          hb_profile_limits{1.0F, 1.0F, 0.0F}}) {
        hb_profile profile;
        hb_profile_start(&profile, 0.01F, 0.05F, &limits);
        EXPECT_EQ(profile.running, 0);
        EXPECT_FLOAT_EQ(hb_profile_point(&profile).value, 0.01F);
    }
}

/// Follows both ways tick by tick; 4e-6 of the size as above.
void expectSamePath(const hb_path_config& config, const control::PlanePathConfig& exact, double size) {
    const auto wanted = control::PlanePath::make(exact, 1e-3);
    ASSERT_TRUE(wanted) << wanted.error().message;
    const float from[] = {0.0F, 0.0F};
    hb_path path;
    hb_path_start(&path, &config, from);
    ASSERT_EQ(path.running, 1);
    int tick = 0;
    for (; path.running != 0 && tick < 100000; ++tick, hb_path_advance(&path)) {
        hb_reference_point point[HB_PATH_AXES];
        hb_path_point(&path, point);
        const control::PlanePoint expected = wanted->at(1e-3 * tick);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            ASSERT_NEAR(static_cast<double>(point[axis].value), expected[axis].value, 4e-6 * size) << tick;
            ASSERT_NEAR(static_cast<double>(point[axis].speed), expected[axis].speed,
                        1e-5 * static_cast<double>(config.speed))
                << tick;
            ASSERT_NEAR(static_cast<double>(point[axis].acceleration), expected[axis].acceleration,
                        1e-3 * static_cast<double>(config.acceleration))
                << tick;
        }
    }
    EXPECT_NEAR(1e-3 * tick, wanted->duration_s(), 1.5e-3);
}

TEST(PlanarPath, followsACircle) {
    for (const float radius : {0.005F, -0.005F}) {
        hb_path_config config{};
        config.shape = HB_PATH_CIRCLE;
        config.radius = radius;
        config.turns = 2;
        config.speed = 0.02F;
        config.acceleration = 0.5F;
        config.jerk = 20.0F;
        config.is_s_curve = 1;
        control::PlanePathConfig exact;
        exact.radius = static_cast<double>(radius);
        exact.turns = 2;
        exact.limits = {static_cast<double>(0.02F), 0.5, 20.0};
        expectSamePath(config, exact, 4.0 * 3.1416 * 0.005); // the length of the path
    }
}

TEST(PlanarPath, followsAnArc) {
    for (const auto& [angle, heading] :
         {std::pair{1.25F, 0.0F}, {-1.25F, 0.7F}, {4.0F, -2.0F}, {-7.5F, 3.1F}}) {
        hb_path_config config{};
        config.shape = HB_PATH_ARC;
        config.radius = 0.004F;
        config.angle = angle;
        config.heading = heading;
        config.speed = 0.02F;
        config.acceleration = 0.5F;
        config.jerk = 20.0F;
        config.is_s_curve = 1;
        control::PlanePathConfig exact;
        exact.shape = control::PlanePathConfig::Shape::Arc;
        exact.radius = static_cast<double>(config.radius);
        exact.angle_rad = static_cast<double>(angle);
        exact.heading_rad = static_cast<double>(heading);
        exact.limits = {static_cast<double>(0.02F), 0.5, 20.0};
        expectSamePath(config, exact, 0.004 * (1.0 + std::fabs(exact.angle_rad)));
    }
}

TEST(PlanarPath, followsALine) {
    hb_path_config config{};
    config.shape = HB_PATH_LINE;
    config.length = 5e-3F;
    config.heading = -2.2F;
    config.speed = 0.02F;
    config.acceleration = 0.5F;
    control::PlanePathConfig exact;
    exact.shape = control::PlanePathConfig::Shape::Line;
    exact.length = static_cast<double>(5e-3F);
    exact.heading_rad = static_cast<double>(-2.2F);
    exact.limits = {static_cast<double>(0.02F), 0.5, {}};
    expectSamePath(config, exact, 5e-3);
}

TEST(PlanarPath, followsARaster) {
    hb_path_config config{};
    config.shape = HB_PATH_RASTER;
    config.width = 2e-3F;
    config.pitch = -1e-4F;
    config.lines = 4;
    config.speed = 0.0123F;
    config.acceleration = 0.7F;
    control::PlanePathConfig exact;
    exact.shape = control::PlanePathConfig::Shape::Raster;
    exact.width = static_cast<double>(2e-3F);
    exact.pitch = static_cast<double>(-1e-4F);
    exact.lines = 4;
    exact.limits = {static_cast<double>(0.0123F), static_cast<double>(0.7F), {}};
    expectSamePath(config, exact, 2e-3);
}

TEST(PlanarPath, doesNotRunWithoutShapeOrLength) {
    const float from[] = {1e-3F, -2e-3F};
    hb_path_config config{};
    config.radius = 1e-3F;
    config.turns = 1;
    config.speed = config.acceleration = 1.0F;
    hb_path path;
    hb_path_start(&path, &config, from); // no shape
    EXPECT_EQ(path.running, 0);
    config.shape = HB_PATH_CIRCLE;
    config.radius = 0.0F;
    hb_path_start(&path, &config, from);
    EXPECT_EQ(path.running, 0);
    hb_reference_point point[HB_PATH_AXES];
    hb_path_point(&path, point);
    EXPECT_EQ(point[0].value, 1e-3F);
    EXPECT_EQ(point[1].value, -2e-3F);
}

} // namespace
} // namespace halbench::devices::firmware
