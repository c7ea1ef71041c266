#include "control/base/random.h"
#include "control/base/units.h"
#include "control/identify/angle_column.h"
#include "tests/control/identify/motion_records.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

RecordMaker runUps(double noise_rad) {
    RecordErrors errors;
    errors.noise_rad = noise_rad;
    RecordMaker record({}, errors, 3);
    record.run(0.0, 0.5);
    for (const double current : {2.0, 4.0, 3.0, 0.0}) {
        record.run(current, 3.0);
    }
    return record;
}

std::vector<double> wrapped(const std::vector<double>& angle_rad, double low_rad, double period_rad) {
    std::vector<double> result;
    for (const double angle : angle_rad) {
        result.push_back(angle - period_rad * std::floor((angle - low_rad) / period_rad));
    }
    return result;
}

TEST(AngleColumn, continuesAnAngleThatWrapsAfterAnySpan) {
    // a turn from zero, a turn around zero, half a turn, two turns, a counter of 65536/1000 rad
    struct Case {
        double low_rad, period_rad;
    };
    for (const Case& one :
         {Case{0.0, 2.0 * Pi}, {-Pi, 2.0 * Pi}, {0.0, Pi}, {0.0, 4.0 * Pi}, {-32.768, 65.536}}) {
        const RecordMaker record = runUps(1e-3);
        const UnwrappedAngle result = unwrapAngle(wrapped(record.angle_rad, one.low_rad, one.period_rad));
        ASSERT_TRUE(result.period_rad) << one.period_rad;
        EXPECT_NEAR(*result.period_rad / one.period_rad, 1.0, 1e-3);
        for (std::size_t i = 0; i < record.angle_rad.size(); ++i) {
            // the span is known to the noise of its jumps, 1e-3 rad, unless it is a whole number of half
            // turns
            const double turned = result.angle_rad[i] - result.angle_rad[0];
            ASSERT_NEAR(turned, record.angle_rad[i] - record.angle_rad[0], 0.02) << one.period_rad;
        }
    }
}

TEST(AngleColumn, noiseOnTheSeamIsNoTurn) {
    const RecordMaker record = runUps(1e-3);
    const double seam_rad = record.angle_rad.front(); // at rest exactly where the angle starts anew
    const UnwrappedAngle result = unwrapAngle(wrapped(record.angle_rad, seam_rad, 2.0 * Pi));
    ASSERT_TRUE(result.period_rad);
    EXPECT_NEAR(result.angle_rad.back() - result.angle_rad.front(),
                record.angle_rad.back() - record.angle_rad.front(), 1e-9);
}

TEST(AngleColumn, leavesAnAngleThatDoesNotWrapAsItIs) {
    const RecordMaker record = runUps(1e-3);
    EXPECT_FALSE(unwrapAngle(record.angle_rad).period_rad);
    std::vector<double> glitch = record.angle_rad;
    glitch[400] += 2.0 * Pi; // one damaged row
    EXPECT_FALSE(unwrapAngle(glitch).period_rad);
    EXPECT_EQ(unwrapAngle(glitch).angle_rad, glitch);
    EXPECT_FALSE(unwrapAngle(std::vector<double>(500, 1.0)).period_rad);
}

std::vector<double> speedOf(const RecordMaker& record) {
    std::vector<double> speed{0.0};
    for (std::size_t i = 1; i < record.angle_rad.size(); ++i) {
        speed.push_back((record.angle_rad[i] - record.angle_rad[i - 1]) / 0.01);
    }
    return speed;
}

TEST(AngleColumn, tellsASpeedFromAnAngle) {
    for (const double dwell_s : {1.0, 2.0, 5.0}) {
        RecordMaker steps({}, {}, 5);
        for (const double current : {2.0, 4.0, 2.5, 3.5, 0.0, 3.0}) {
            steps.run(current, dwell_s);
        }
        RecordMaker rising({}, {}, 5);
        for (const double current : {1.6, 2.0, 2.4, 2.8, 3.2, 3.6, 4.0}) {
            rising.run(current, dwell_s);
        }
        for (const RecordMaker& record : {steps, rising}) {
            const auto plateaus = findPlateaus(record.time_s, record.current_column_A, {}, {});
            ASSERT_TRUE(plateaus);
            EXPECT_TRUE(looksLikeSpeed(speedOf(record), *plateaus)) << dwell_s;
            EXPECT_FALSE(looksLikeSpeed(record.angle_rad, *plateaus)) << dwell_s;
        }
    }
}

} // namespace
} // namespace halbench::control
