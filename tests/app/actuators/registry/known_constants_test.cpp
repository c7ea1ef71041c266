#include "app/actuators/actuator.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// A form has a field for each constant of the row: setGiven must take every one of them, and no other symbol.
TEST(KnownConstants, identificationTakesEveryConstantOfItsRow) {
    for (const Actuator& actuator : actuators()) {
        for (const KnownConstant& constant : actuator.knownConstants) {
            IdentifyConfig config;
            EXPECT_TRUE(actuator.identify.setGiven(config, constant.symbol, 0.5)) << constant.symbol;
        }
        IdentifyConfig config;
        EXPECT_FALSE(actuator.identify.setGiven(config, "no such constant", 0.5)) << actuator.model;
    }
}

TEST(KnownConstants, actuatorsThatAreIdentifiedNameTheirs) {
    EXPECT_EQ(actuatorOf("htm").knownConstants.size(), 4U);    // J, c, Kf, phi
    EXPECT_EQ(actuatorOf("planar").knownConstants.size(), 2U); // m, Iz
}

} // namespace
} // namespace halbench::app
