#include "app/figures/parameter_units.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(ParameterUnits, areThoseOfTheTableOfUnits) {
    for (const char* name : {"gain.kp", "gain.ki", "gain.kd", "feedforward.inertia", "stiction.threshold",
                             "limit.temperature", "stray.coefficient", "hall.offset_b"}) {
        EXPECT_FALSE(parameterUnit(name).empty()) << name;
        EXPECT_TRUE(findUnit(parameterUnit(name)).has_value()) << name;
    }
    EXPECT_EQ(parameterUnit("gain.kp"), "A/rad");
    EXPECT_EQ(parameterUnit("decode.method"), "");
}

} // namespace
} // namespace halbench::app
