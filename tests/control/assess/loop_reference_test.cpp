#include "control/assess/loop_reference.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

namespace halbench::control {
namespace {

TEST(LoopReference, derivativesMatchTheValue) {
    const LoopReference reference{LoopReference::Shape::Sine, 2.0 * Pi, 0, 0.2, 1, 1};
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

TEST(LoopReference, rampHoldsAtItsAmplitude) {
    const LoopReference reference{
        LoopReference::Shape::Ramp, degreesToRadians(150), degreesToRadians(-100), 0, 1, 1};
    EXPECT_DOUBLE_EQ(evaluateReference(reference, 1.0).value_rad, degreesToRadians(-100));
    EXPECT_DOUBLE_EQ(evaluateReference(reference, 2.0).value_rad, degreesToRadians(-150));
    EXPECT_EQ(evaluateReference(reference, 2.0).speed_rad_s, 0.0);
}

} // namespace
} // namespace halbench::control
