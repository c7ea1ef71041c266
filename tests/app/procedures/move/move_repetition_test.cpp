#include "app/procedures/move/move_repetition.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

TEST(MoveRepetition, countsTheRunsThatStayBelowTheLimit) {
    MoveRepetition repetition;
    repetition.maxError = {0.01, 0.05, 0.02, 0.03};
    EXPECT_FALSE(repetition.settled_ratio().has_value());
    repetition.config.settled = 0.03;
    EXPECT_EQ(repetition.settled_ratio(), 0.75); // the limit itself counts
}

TEST(MoveRepetition, settlesAfterTheWayOfATravel) {
    MoveRepetition repetition;
    repetition.config.settled = 1e-6;
    repetition.settlesAfterWay = true;
    repetition.maxError = {1e-4, 1e-4, 1e-4, 1e-4}; // on the way
    repetition.windowTime_s = {0.1, std::nullopt, 0.4, 0.2};
    EXPECT_EQ(repetition.settled_ratio(), 0.75);
}

TEST(MoveRepetition, hasStatisticsOfTheRunsThatSettled) {
    MoveRepetition repetition;
    EXPECT_FALSE(repetition.settlingTimes().has_value());
    repetition.windowTime_s = {0.1, std::nullopt, 0.4, 0.2};
    const auto times = repetition.settlingTimes();
    ASSERT_TRUE(times);
    EXPECT_EQ(times->count, 3);
    EXPECT_EQ(times->least_s, 0.1);
    EXPECT_EQ(times->median_s, 0.2);
    EXPECT_EQ(times->largest_s, 0.4);
    EXPECT_NEAR(times->mean_s, 0.7 / 3.0, 1e-15);
    // Squares from the mean: (16 + 1 + 25)/900, over two degrees of freedom.
    EXPECT_NEAR(times->deviation_s, std::sqrt(42.0 / 900.0 / 2.0), 1e-15);
    repetition.windowTime_s = {0.3, 0.1};
    EXPECT_NEAR(repetition.settlingTimes()->median_s, 0.2, 1e-15);
    repetition.windowTime_s = {0.3};
    EXPECT_EQ(repetition.settlingTimes()->deviation_s, 0.0);
}

TEST(MoveRepetition, startsEachRunWhereTheOneBeforeCameToRest) {
    const auto device = openMotor("imperfections=off");
    const MoveConfig config = move("step,amplitude_deg=100", 1.5);
    const auto repeated = runRepeatedMove(*device, config, {3, degreesToRadians(10.0)}, {});
    ASSERT_TRUE(repeated.has_value()) << repeated.error().message;
    const std::vector<double>& start = repeated->repetition.start;
    ASSERT_EQ(start.size(), 3U);
    for (std::size_t run = 1; run < start.size(); ++run) {
        // 100 degrees, short of the end by what friction holds: at most 8.21 degrees (section 6.7)
        EXPECT_NEAR(radiansToDegrees(start[run] - start[run - 1]), 100.0, 8.3);
    }
    EXPECT_EQ(repeated->repetition.settled_ratio(), 1.0);
    EXPECT_EQ(repeated->repetition.maxError.back(), repeated->last.figures().maxError);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(MoveRepetition, goesBackInEverySecondRun) {
    const auto device = openMotor("imperfections=off");
    RepeatConfig repeat{4, {}};
    repeat.alternates = true;
    const auto repeated = runRepeatedMove(*device, move("step,amplitude_deg=100", 1.5), repeat, {});
    ASSERT_TRUE(repeated.has_value()) << repeated.error().message;
    const std::vector<double>& start = repeated->repetition.start;
    for (std::size_t run = 1; run < start.size(); ++run) {
        const double moved_deg = radiansToDegrees(start[run] - start[run - 1]);
        EXPECT_NEAR(moved_deg, run % 2 == 1 ? 100.0 : -100.0, 8.3) << run;
    }
}

TEST(MoveRepetition, endsWithTheErrorOfItsRun) {
    const auto device = openMotor("imperfections=off");
    EXPECT_EQ(runRepeatedMove(*device, move("step,amplitude_deg=100", 1e6), {3, {}}, {}).error().code,
              ErrorCode::OutOfRange);
}

/// A step of one that is approached as 1 - exp(-t/tau), a row each millisecond.
MoveResponse approach(double tau_s, double duration_s) {
    MoveResponse response;
    for (int i = 0; i <= static_cast<int>(duration_s * 1e3); ++i) {
        const double time_s = 1e-3 * i;
        response.time_s.push_back(time_s);
        response.reference.push_back(1.0);
        response.position.push_back(1.0 - std::exp(-time_s / tau_s));
    }
    return response;
}

TEST(WindowTime, isWhereThePositionStaysInTheWindow) {
    MoveConfig config = move("step,amplitude_rad=1", 2);
    EXPECT_FALSE(measureMove(approach(0.1, 2.0), config)->windowTime_s.has_value());
    config.settlingWindow = 0.02;
    const auto time_s = measureMove(approach(0.1, 2.0), config)->windowTime_s;
    ASSERT_TRUE(time_s);
    EXPECT_NEAR(*time_s, 0.1 * std::log(1.0 / 0.02), 1e-3); // a row
}

TEST(WindowTime, isAbsentWithoutATenthOfASecondInTheWindow) {
    MoveConfig config = move("step,amplitude_rad=1", 2);
    config.settlingWindow = std::exp(-19.5); // entered at 1.95 s of 2 s
    EXPECT_FALSE(measureMove(approach(0.1, 2.0), config)->windowTime_s.has_value());
    config.settlingWindow = std::exp(-18.5);
    EXPECT_TRUE(measureMove(approach(0.1, 2.0), config)->windowTime_s.has_value());
}

TEST(WindowTime, isAbsentWhereTheReferenceGoesOn) {
    MoveConfig config = move("ramp,rate_deg_s=500", 2);
    config.settlingWindow = 10.0;
    EXPECT_FALSE(measureMove(approach(0.1, 2.0), config)->windowTime_s.has_value());
}

MoveResponse responseWithError(double error_rad, double until_s, double again_s) {
    MoveResponse response;
    for (int i = 0; i <= 10000; ++i) {
        const double time_s = 1e-3 * i;
        response.time_s.push_back(time_s);
        response.reference.push_back(time_s < until_s || time_s >= again_s ? error_rad : 0.0);
        response.position.push_back(0.0);
    }
    return response;
}

TEST(LockTime, isWhereTheErrorStaysBelowTheThreshold) {
    MoveConfig config = move("ramp,rate_deg_s=500", 10);
    EXPECT_FALSE(measureMove(responseWithError(0.2, 2.0, 99), config)->lockTime_s.has_value());
    config.lockThreshold = 0.1;
    // One row in ten counts, so the first good one after 1.99 s is that at 2 s.
    EXPECT_NEAR(measureMove(responseWithError(0.2, 2.0, 99), config)->lockTime_s.value_or(-1), 2.0, 1e-9);
    EXPECT_EQ(measureMove(responseWithError(0.05, 2.0, 99), config)->lockTime_s, 0.0); // never above
}

TEST(LockTime, isAbsentWhenTheErrorComesBackOrMight) {
    MoveConfig config = move("ramp,rate_deg_s=500", 10);
    config.lockThreshold = 0.1;
    EXPECT_FALSE(measureMove(responseWithError(0.2, 2.0, 9.5), config)->lockTime_s.has_value());
    config.reference = move("sine,amplitude_deg=360,period_s=5", 10).reference;
    EXPECT_TRUE(measureMove(responseWithError(0.2, 7.4, 99), config)->lockTime_s.has_value());
    EXPECT_FALSE(measureMove(responseWithError(0.2, 7.6, 99), config)->lockTime_s.has_value());
}

} // namespace
} // namespace halbench::app
