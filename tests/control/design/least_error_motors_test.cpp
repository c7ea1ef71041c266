// The least error of motors of every damping, against a search of its own (least_error_search.h).
#include "control/design/optimal_designs.h"
#include "tests/control/design/least_error_search.h"

#include <gtest/gtest.h>

namespace halbench::control {
namespace {

struct Motor {
    double dampingRate_1_s;
    double accelerationGain_rad_s2_A;
    int delay_samples;
    ErrorMeasure measure;
    double mostMs_ratio;
};

// The motor of c/J 38.1 per second once got 8.7 times the least error; its recommended gains have no K_D.
TEST(LeastErrorOfMotorsSeeds, isReachedFromLivelyToDampedOnes) {
    const Motor motors[] = {
        {0.1, 12.0, 0, ErrorMeasure::Iae, 1.7},    {1.0, 3000.0, 2, ErrorMeasure::Itae, 1.4},
        {38.1, 645.0, 0, ErrorMeasure::Iae, 1.7},  {38.1, 645.0, 1, ErrorMeasure::Itae, 2.0},
        {75.0, 90.0, 2, ErrorMeasure::Iae, 2.4},   {200.0, 1000.0, 0, ErrorMeasure::Itae, 1.7},
        {200.0, 5000.0, 1, ErrorMeasure::Iae, 1.3}};
    for (const Motor& motor : motors) {
        const PositionPlant plant{motor.dampingRate_1_s, motor.accelerationGain_rad_s2_A, 0.1};
        const LoopTiming timing{0.01, motor.delay_samples};
        const LeastErrorTargets targets{motor.measure, motor.mostMs_ratio, {}};
        const auto design = designLeastError(plant, timing, targets, 4.0);
        ASSERT_TRUE(design) << motor.dampingRate_1_s << ": " << design.error().message;
        const LeastErrorSearch search(plant, timing, targets);
        // 1 %: what the design says that it finds the least to.
        EXPECT_LE(search.errorOf(design->gains), 1.01 * search.least(4, 1))
            << motor.dampingRate_1_s << " per second, " << motor.delay_samples << " samples";
    }
}

// Without damping at all, and with a period that is long beside the motor's own time: the start of the search
// follows from both.
TEST(LeastErrorOfMotorsSeeds, isFoundAtTheEndsOfTheRange) {
    for (const LoopTiming timing : {LoopTiming{0.01, 0}, LoopTiming{0.05, 2}, LoopTiming{0.001, 1}}) {
        for (const double damping : {0.0, 1e-3, 500.0}) {
            for (const double mostMs : {least_error::LeastMs_ratio, least_error::MostMs_ratio}) {
                const PositionPlant plant{damping, 26.0, 1.4};
                const auto design = designLeastError(plant, timing, {ErrorMeasure::Iae, mostMs, {}}, 4.0);
                ASSERT_TRUE(design) << damping << " " << mostMs << ": " << design.error().message;
                EXPECT_LE(design->assessment.peaks.Ms_ratio, 1.001 * mostMs);
                EXPECT_GT(design->assessment.peaks.Ms_ratio, 0.99 * mostMs)
                    << damping; // a linear loop uses it
            }
        }
    }
}

} // namespace
} // namespace halbench::control
