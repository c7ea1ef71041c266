#include "app/procedures/move/recorded_move.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

/// Position t^2 from rest, its reference 1 rad before it, 0.5 A; rows of so many milliseconds.
Recording recording(int period_ms, int rows, const std::string& suffix = {}) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"position" + (suffix.empty() ? suffix : "_rad"), "rad"},
                       {"reference" + (suffix.empty() ? suffix : "_rad"), "rad"},
                       {"current_command" + suffix, "A"}};
    Recording result;
    result.layout = layout;
    for (int row = 0; row < rows; ++row) {
        const double time_s = 1e-3 * period_ms * row;
        result.time_s.push_back(time_s);
        result.values.insert(result.values.end(), {3.0 + time_s * time_s, 4.0, 0.5});
    }
    return result;
}

TEST(RecordedMove, countsFromWhereTheRotorWas) {
    const auto move = recordedMove(recording(1, 1001));
    ASSERT_TRUE(move) << move.error().message;
    EXPECT_EQ(move->rows(), 1001U);
    EXPECT_NEAR(move->reference_rad[0], 1.0, 1e-12);
    EXPECT_NEAR(move->position_rad[500], 0.25, 1e-9);
    EXPECT_EQ(move->current_A[500], 0.5);
}

TEST(RecordedMove, isPutOnMilliseconds) {
    const auto move = recordedMove(recording(10, 101));
    ASSERT_TRUE(move) << move.error().message;
    EXPECT_EQ(move->rows(), 1001U);
    EXPECT_NEAR(move->position_rad[500], 0.25, 1e-9);
    EXPECT_NEAR(move->position_rad[505], 0.255025, 3e-5); // a chord of 10 ms: t^2 sags by (5 ms)^2
}

TEST(RecordedMove, knowsColumnsWithoutTheirSidecar) {
    EXPECT_TRUE(recordedMove(recording(1, 1001, "_A")));
}

TEST(RecordedMove, refusesWhatIsNoWholeMove) {
    EXPECT_EQ(recordedMove(recording(1, 100)).error().code, ErrorCode::InvalidInput) << "too short";
    EXPECT_EQ(recordedMove(recording(50, 100)).error().code, ErrorCode::InvalidInput) << "20 Hz";
    EXPECT_EQ(recordedMove(Recording{}).error().code, ErrorCode::InvalidInput) << "nothing";
    Recording gap = recording(1, 1001);
    for (std::size_t row = 500; row < gap.rows(); ++row) {
        gap.time_s[row] += 0.05;
    }
    EXPECT_NE(recordedMove(gap).error().message.find("0.499 s"), std::string::npos);
    Recording spoiled = recording(1, 1001);
    spoiled.values[300] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(recordedMove(spoiled).error().code, ErrorCode::NotFinite);
    Recording running = recording(1, 1001);
    for (std::size_t row = 0; row < running.rows(); ++row) {
        running.values[3 * row] += 2.0 * running.time_s[row]; // 10 mrad in 5 ms
    }
    EXPECT_EQ(recordedMove(running).error().code, ErrorCode::Refused);
}

TEST(RecordedMove, beginsWithItsReference) {
    Recording both = recording(1, 1001);
    auto layout = std::make_shared<StreamLayout>(*both.layout);
    layout->columns.push_back({"reference.running", ""});
    Recording marked;
    marked.layout = layout;
    marked.time_s = both.time_s;
    for (std::size_t row = 0; row < both.rows(); ++row) {
        marked.values.insert(marked.values.end(), {row < 400 ? 3.0 : 3.5, 4.0, 0.5, row < 400 ? 0.0 : 1.0});
    }
    const auto move = recordedMove(marked);
    ASSERT_TRUE(move) << move.error().message;
    EXPECT_EQ(move->rows(), 601U);
    EXPECT_NEAR(move->reference_rad[0], 0.5, 1e-12);
}

// Between its ends the acceleration of t^2 is 2, its speed 2 t, and it goes one way; smoothing by a kernel of
// even weights changes none of them.
TEST(MotionRemainder, isOfTheMotionItself) {
    const auto move = recordedMove(recording(1, 1001));
    ASSERT_TRUE(move);
    const MotionRemainder remainder = remainderOf(*move);
    EXPECT_NEAR(remainder.acceleration_rad_s2[700], 2.0, 1e-6);
    EXPECT_NEAR(remainder.speed_rad_s[700], 1.4, 1e-6);
    EXPECT_NEAR(remainder.direction_ratio[700], 1.0, 1e-9);
    EXPECT_NEAR(remainder.current_A[700], 0.5, 1e-9);
    EXPECT_NEAR(remainder.moving_ratio[700], 1.0, 1e-9);
}

// Friction and current count from where the motion began, not from where it is seen: 30 t^2 leaves the
// flicker of a count only after 10 ms.
TEST(MotionRemainder, movesFromItsBeginningOn) {
    RecordedMove move{std::vector<double>(600, 1.0), std::vector<double>(600), std::vector<double>(600, 4.0)};
    for (std::size_t row = 200; row < move.rows(); ++row) {
        move.position_rad[row] = 30e-6 * std::pow(static_cast<double>(row) - 200.0, 2);
    }
    const MotionRemainder remainder = remainderOf(move);
    EXPECT_NEAR(remainder.moving_ratio[200], 0.5, 0.1); // half of the kernel; a row more or less is 0.04
    EXPECT_NEAR(remainder.acceleration_rad_s2[200] / 60.0, 0.5, 0.05);
    EXPECT_NEAR(remainder.current_A[200] / 4.0, 0.5, 0.1);
}

TEST(MotionRemainder, atRestThereIsNone) {
    RecordedMove still{std::vector<double>(1000, 0.1), std::vector<double>(1000),
                       std::vector<double>(1000, 1.2)};
    for (std::size_t row = 0; row < still.rows(); ++row) {
        still.position_rad[row] = row % 7 == 0 ? 0.0025 : 0.0; // one count flickers
    }
    const MotionRemainder remainder = remainderOf(still);
    for (std::size_t row = 0; row < still.rows(); ++row) {
        EXPECT_EQ(remainder.moving_ratio[row], 0.0);
        EXPECT_EQ(remainder.current_A[row], 0.0);
    }
    EXPECT_GT(remainder.resolution_rad, 7e-4 - 1e-12);
    EXPECT_LT(remainder.resolution_rad, 2e-3);
}

} // namespace
} // namespace halbench::app
