#include "control/base/random.h"
#include "control/base/units.h"
#include "control/signals/plane_path.h"
#include "control/signals/pose_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

PoseMotion splineThrough(const std::vector<double>& time_s, const PoseRows& rows) {
    auto motion = PoseMotion::through(time_s, rows);
    EXPECT_TRUE(motion) << motion.error().message;
    return *motion;
}

/// Position, speed and acceleration do not jump from piece to piece, and are 0 at both ends.
void expectSmooth(const PoseMotion& motion) {
    for (std::size_t axis = 0; axis < motion.axisCount(); ++axis) {
        double largest = 0.0;
        for (const MotionPiece& piece : motion.pieces()) {
            largest = std::max(largest, piece.peaks(axis).acceleration);
        }
        TravelPoint before{};
        for (const MotionPiece& piece : motion.pieces()) {
            const TravelPoint begin = piece.at(axis, 0.0);
            EXPECT_NEAR(begin.value, before.value, 1e-12);
            EXPECT_NEAR(begin.speed, before.speed, 1e-9);
            EXPECT_NEAR(begin.acceleration, before.acceleration, 1e-9 * largest + 1e-12);
            before = piece.at(axis, piece.duration_s);
        }
        EXPECT_NEAR(before.value, motion.at(axis, motion.duration_s()).value, 1e-12);
        EXPECT_NEAR(before.speed, 0.0, 1e-9);
        EXPECT_NEAR(before.acceleration, 0.0, 1e-9 * largest + 1e-12);
    }
}

// One interval T over D with knots at T/3 and 2 T/3 and rest at both ends, by hand: the acceleration rises to
// 9 D/T^2 in the first third, falls through 0 to the opposite in the second; the speed at T/2 is 9/4 D/T.
TEST(PoseMotion, oneIntervalIsTheSplineByHand) {
    const PoseMotion motion = splineThrough({2.0}, {{0.03}});
    ASSERT_EQ(motion.pieces().size(), 3u);
    EXPECT_DOUBLE_EQ(motion.duration_s(), 2.0);
    EXPECT_NEAR(motion.at(0, 1.0).speed, 9.0 / 4.0 * 0.03 / 2.0, 1e-14);
    EXPECT_NEAR(motion.at(0, 2.0 / 3.0).acceleration, 9.0 * 0.03 / 4.0, 1e-13);
    EXPECT_NEAR(motion.at(0, 1.0).value, 0.015, 1e-15); // half way by symmetry
    EXPECT_NEAR(motion.pieces()[0].axes[0].jerk, 27.0 * 0.03 / 8.0, 1e-12);
    EXPECT_NEAR(motion.pieces()[1].axes[0].jerk, -54.0 * 0.03 / 8.0, 1e-12);
    EXPECT_EQ(motion.at(0, 3.0).value, 0.03);
    expectSmooth(motion);
}

TEST(PoseMotion, splineMeetsEveryPoseAtItsTimeWithoutJumps) {
    Random random(3);
    for (int run = 0; run < 50; ++run) {
        std::vector<double> time_s;
        PoseRows rows;
        double now_s = run % 2 == 0 ? 0.0 : 0.2;
        const int count = 2 + run % 9;
        for (int row = 0; row < count; ++row) {
            now_s += row == 0 ? 0.0 : 0.02 + random.uniform();
            time_s.push_back(now_s);
            const bool isStart = now_s == 0.0;
            rows.push_back(
                {isStart ? 0.0 : 0.02 * random.gaussian(), isStart ? 0.0 : 1e-3 * random.gaussian()});
        }
        const PoseMotion motion = splineThrough(time_s, rows);
        EXPECT_NEAR(motion.duration_s(), time_s.back(), 1e-12);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            EXPECT_EQ(motion.arrivals_s()[row], time_s[row]);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                EXPECT_NEAR(motion.at(axis, time_s[row]).value, rows[row][axis], 1e-12) << run << ' ' << row;
            }
        }
        expectSmooth(motion);
    }
}

// A cubic spline misses a sine of interval h by 5/384 h^4 w^4 of its amplitude; here w h = 0.157, and three
// intervals behind the start its end conditions have faded by 0.27 each.
TEST(PoseMotion, splineThroughASampledSineIsTheSine) {
    constexpr double Frequency_rad_s = 2.0 * Pi;
    std::vector<double> time_s;
    PoseRows rows;
    for (int i = 0; i <= 80; ++i) {
        time_s.push_back(0.025 * i);
        rows.push_back({0.01 * (1.0 - std::cos(Frequency_rad_s * time_s.back()))});
    }
    const PoseMotion motion = splineThrough(time_s, rows);
    for (double time = 0.5; time < 1.5; time += 0.0007) {
        EXPECT_NEAR(motion.at(0, time).value, 0.01 * (1.0 - std::cos(Frequency_rad_s * time)), 2e-7);
        EXPECT_NEAR(motion.at(0, time).speed, 0.01 * Frequency_rad_s * std::sin(Frequency_rad_s * time),
                    1e-4);
    }
}

TEST(PoseMotion, rowsWithTheSamePoseAreAPause) {
    const PoseMotion motion =
        splineThrough({0.5, 1.5, 2.0, 2.5}, {{1.0, 2.0}, {1.0, 2.0}, {1.0, 3.0}, {0.0, 3.0}});
    for (double time = 0.5; time <= 1.5; time += 0.01) {
        EXPECT_NEAR(motion.at(0, time).value, 1.0, 1e-15);
        EXPECT_NEAR(motion.at(1, time).value, 2.0, 1e-15);
        EXPECT_NEAR(motion.at(1, time).speed, 0.0, 1e-12);
    }
    EXPECT_EQ(motion.departures_s()[0], 1.5);
    EXPECT_EQ(motion.departures_s()[1], 1.5);
    EXPECT_EQ(motion.departures_s()[2], 2.0);
    expectSmooth(motion);
    // At time 0 it stands where it is anyway: no pause before the first way.
    EXPECT_EQ(splineThrough({0.0, 1.0}, {{0.0}, {1.0}}).pieces().size(), 3u);
    EXPECT_EQ(splineThrough({0.0, 1.0, 2.0}, {{0.0}, {0.0}, {1.0}}).pieces().size(), 4u);
}

// Second route: thousand samples of the piece.
TEST(PoseMotion, peaksOfAPieceAreTheLargestOfItsSamples) {
    Random random(8);
    for (int run = 0; run < 200; ++run) {
        MotionPiece piece{0.0, 0.1 + random.uniform(), 0, {}};
        const double jerk = run % 3 == 0 ? 0.0 : 20.0 * random.gaussian();
        piece.axes.push_back(
            {random.gaussian(), random.gaussian(), run % 5 == 0 ? 0.0 : 5.0 * random.gaussian(), jerk});
        const PiecePeaks peaks = piece.peaks(0);
        PiecePeaks seen;
        seen.least = seen.most = piece.at(0, 0.0).value;
        for (int i = 0; i <= 1000; ++i) {
            const TravelPoint point = piece.at(0, piece.duration_s * i / 1000.0);
            seen.least = std::min(seen.least, point.value);
            seen.most = std::max(seen.most, point.value);
            seen.speed = std::max(seen.speed, std::fabs(point.speed));
            seen.acceleration = std::max(seen.acceleration, std::fabs(point.acceleration));
        }
        // Between two samples a peak is flat: missed by its curvature times an eighth of the step squared.
        EXPECT_GE(peaks.most, seen.most - 1e-12);
        EXPECT_NEAR(peaks.most, seen.most, 1e-4);
        EXPECT_LE(peaks.least, seen.least + 1e-12);
        EXPECT_NEAR(peaks.least, seen.least, 1e-4);
        EXPECT_GE(peaks.speed, seen.speed - 1e-12);
        EXPECT_NEAR(peaks.speed, seen.speed, 1e-4);
        EXPECT_DOUBLE_EQ(peaks.acceleration, seen.acceleration);
        EXPECT_EQ(peaks.jerk, std::fabs(jerk));
    }
}

TEST(PoseMotion, visitsRowsAsTravelsOnStraightLines) {
    for (const bool hasJerk : {false, true}) {
        const TravelLimits limits{0.02, 0.5, hasJerk ? std::optional(20.0) : std::nullopt};
        const PoseRows rows = {{3e-3, 4e-3}, {0.0, 4e-3}};
        const AxisGroup group{{0, 1}, limits};
        const auto motion = PoseMotion::visiting(rows, {&group, 1}, 0.25);
        ASSERT_TRUE(motion) << motion.error().message;
        const auto first = TravelProfile::solve(5e-3, limits); // 3-4-5
        const auto second = TravelProfile::solve(3e-3, limits);
        ASSERT_TRUE(first && second);
        EXPECT_NEAR(motion->arrivals_s()[0], first->duration_s(), 1e-12);
        EXPECT_NEAR(motion->departures_s()[0], first->duration_s() + 0.25, 1e-12);
        EXPECT_NEAR(motion->duration_s(), first->duration_s() + 0.25 + second->duration_s(), 1e-12);
        for (double time = 0.0; time < first->duration_s(); time += 1e-3) {
            const TravelPoint along = first->at(time);
            EXPECT_NEAR(motion->at(0, time).value, 0.6 * along.value, 1e-14);
            EXPECT_NEAR(motion->at(1, time).value, 0.8 * along.value, 1e-14);
            EXPECT_NEAR(motion->at(0, time).speed, 0.6 * along.speed, 1e-12);
            EXPECT_NEAR(motion->at(1, time).acceleration, 0.8 * along.acceleration, 1e-9);
        }
        EXPECT_EQ(motion->at(0, 10.0).value, 0.0);
        EXPECT_EQ(motion->at(1, 10.0).value, 4e-3);
    }
}

TEST(PoseMotion, slowestGroupSetsTheTimeOfAVisit) {
    const AxisGroup groups[] = {{{0}, {0.02, 0.5, std::nullopt}}, {{1}, {0.01, 0.1, std::nullopt}}};
    const auto motion = PoseMotion::visiting({{1e-3, 5e-3}, {2e-3, 5e-3}}, groups, 0.0);
    ASSERT_TRUE(motion);
    // The turn of 5 mrad at 10 mrad/s and 0.1 rad/s^2: d/v + v/a; then 1 mm at 20 mm/s.
    EXPECT_NEAR(motion->arrivals_s()[0], 0.5 + 0.1, 1e-12);
    EXPECT_NEAR(motion->duration_s() - motion->arrivals_s()[0], 1e-3 / 0.02 + 0.02 / 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(motion->reach(0), 2e-3);
    EXPECT_NEAR(motion->reach(1), 5e-3, 1e-15);
}

TEST(PoseMotion, refusesImpossibleTables) {
    const auto codeOf = [](const Result<PoseMotion>& motion) {
        return motion ? ErrorCode::Internal : motion.error().code;
    };
    const auto through = [&](const std::vector<double>& time_s, const PoseRows& rows) {
        return codeOf(PoseMotion::through(time_s, rows));
    };
    EXPECT_EQ(through({}, {}), ErrorCode::InvalidInput);
    EXPECT_EQ(through({0.0, 1.0}, {{0.0}, {0.0}}), ErrorCode::InvalidInput); // nothing moves
    EXPECT_EQ(through({0.0, 1.0}, {{1.0}, {0.0}}), ErrorCode::InvalidInput); // elsewhere at the start
    EXPECT_EQ(through({0.0, 1.0}, {{0.0}, {1.0, 2.0}}), ErrorCode::InvalidInput);
    EXPECT_EQ(through({1.0, 1.0}, {{0.0}, {1.0}}), ErrorCode::OutOfRange);
    EXPECT_EQ(through({-1.0, 1.0}, {{0.0}, {1.0}}), ErrorCode::OutOfRange);
    EXPECT_EQ(through({0.5, NAN}, {{0.0}, {1.0}}), ErrorCode::NotFinite);
    EXPECT_EQ(through({0.5, 1.0}, {{0.0}, {INFINITY}}), ErrorCode::NotFinite);
    const AxisGroup withoutSpeed{{0}, {0.0, 1.0, std::nullopt}};
    EXPECT_EQ(codeOf(PoseMotion::visiting({{1.0}, {2.0}}, {&withoutSpeed, 1}, 0.0)), ErrorCode::OutOfRange);
}

TEST(PlaneTrace, tellsTheDistanceFromTheWay) {
    const AxisGroup group{{0, 1}, {0.02, 0.5, std::nullopt}};
    const auto motion = PoseMotion::visiting({{3e-3, 4e-3}, {0.0, 4e-3}}, {&group, 1}, 0.0);
    ASSERT_TRUE(motion);
    const PlaneTrace trace(*motion, {0, 1});
    const double half_s = 0.5 * motion->arrivals_s()[0];
    // 1 um across the direction (3, 4)/5, from the middle of the first line; along it nothing counts.
    EXPECT_NEAR(trace.distanceFrom(1.5e-3 - 0.8e-6, 2e-3 + 0.6e-6, half_s), 1e-6, 1e-12);
    EXPECT_NEAR(trace.distanceFrom(1.5e-3 + 6e-6, 2e-3 + 8e-6, half_s), 0.0, 1e-12);
    EXPECT_NEAR(trace.distanceFrom(-3e-3, 4e-3, 10.0), 3e-3, 1e-12); // beyond the end
    const PlaneTrace level(*motion, {0, 7});                         // an axis that does not move
    EXPECT_NEAR(level.distanceFrom(1.5e-3, -2e-6, half_s), 2e-6, 1e-12);
}

} // namespace
} // namespace halbench::control
