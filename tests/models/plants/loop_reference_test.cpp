#include "tests/models/htm/ideal_loop_cases.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

TEST(HtmReference, derivativesMatchTheValue) {
    const LoopReference reference = sine(360, 0.2);
    const double h = 1e-5;
    for (const double t : {0.3, 1.1, 2.7}) {
        const double before = evaluateReference(reference, t - h).value_rad;
        const double here = evaluateReference(reference, t).value_rad;
        const double after = evaluateReference(reference, t + h).value_rad;
        // central differences: error of the order omega^2 h^2
        EXPECT_NEAR(evaluateReference(reference, t).speed_rad_s, (after - before) / (2.0 * h), 1e-8);
        EXPECT_NEAR(evaluateReference(reference, t).acceleration_rad_s2,
                    (after - 2 * here + before) / (h * h), 1e-4);
    }
}

TEST(HtmReference, rampHoldsAtItsAmplitude) {
    LoopReference reference = ramp(-100);
    reference.amplitude_rad = degreesToRadians(150);
    EXPECT_DOUBLE_EQ(evaluateReference(reference, 1.0).value_rad, degreesToRadians(-100));
    EXPECT_DOUBLE_EQ(evaluateReference(reference, 2.0).value_rad, degreesToRadians(-150));
    EXPECT_EQ(evaluateReference(reference, 2.0).speed_rad_s, 0.0);
}

} // namespace
} // namespace halbench::models
