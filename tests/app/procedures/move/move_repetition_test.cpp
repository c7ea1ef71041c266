#include "app/procedures/move/move_repetition.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

TEST(MoveRepetition, countsTheRunsThatStayBelowTheLimit) {
    MoveRepetition repetition;
    repetition.maxError_rad = {0.01, 0.05, 0.02, 0.03};
    EXPECT_FALSE(repetition.settled_ratio().has_value());
    repetition.config.settled_rad = 0.03;
    EXPECT_EQ(repetition.settled_ratio(), 0.75); // the limit itself counts
}

TEST(MoveRepetition, startsEachRunWhereTheOneBeforeCameToRest) {
    const auto device = openMotor("imperfections=off");
    const MoveConfig config = move("step,amplitude_deg=100", 1.5);
    const auto repeated = runRepeatedMove(*device, config, {3, degreesToRadians(10.0)}, {});
    ASSERT_TRUE(repeated.has_value()) << repeated.error().message;
    const std::vector<double>& start_rad = repeated->repetition.start_rad;
    ASSERT_EQ(start_rad.size(), 3U);
    for (std::size_t run = 1; run < start_rad.size(); ++run) {
        // 100 degrees, short of the end by what friction holds: at most 8.21 degrees (section 6.7)
        EXPECT_NEAR(radiansToDegrees(start_rad[run] - start_rad[run - 1]), 100.0, 8.3);
    }
    EXPECT_EQ(repeated->repetition.settled_ratio(), 1.0);
    EXPECT_EQ(repeated->repetition.maxError_rad.back(), repeated->last.figures().maxError);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(MoveRepetition, endsWithTheErrorOfItsRun) {
    const auto device = openMotor("imperfections=off");
    EXPECT_EQ(runRepeatedMove(*device, move("step,amplitude_deg=100", 1e6), {3, {}}, {}).error().code,
              ErrorCode::OutOfRange);
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
