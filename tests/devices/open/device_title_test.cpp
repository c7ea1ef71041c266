#include "devices/open/device_title.h"
#include "devices/simulated/registry/simulated_models.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(DeviceTitle, isThatOfTheRegistryWhateverOptionsTheAddressHas) {
    for (const SimulatedModel& model : simulatedModels()) {
        ASSERT_FALSE(model.title.empty()) << model.name;
        EXPECT_EQ(simulatedTitle("sim:" + model.name), model.title);
        EXPECT_EQ(simulatedTitle("sim:" + model.name + "?seed=7"), model.title);
    }
}

TEST(DeviceTitle, otherDevicesHaveNone) {
    for (const char* address : {"", "banana", "sim:", "sim:banana", "tcp:localhost:5555", "replay:sim.csv"}) {
        EXPECT_EQ(simulatedTitle(address), "") << address;
    }
}

} // namespace
} // namespace halbench::devices
