#include "devices/open/open_device.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/conformance/actuator/toy_model.h"

#include <gtest/gtest.h>

#include <cmath>

// An actuator that only this program knows, through the code that opens every device.

namespace halbench::devices {
namespace {

class ToyDevice : public ::testing::Test {
protected:
    static void SetUpTestSuite() { addSimulatedModel(toyModel()); }

    std::unique_ptr<Device> open(const std::string& address) {
        auto device = openDevice(address, {});
        EXPECT_TRUE(device) << device.error().message;
        return device ? std::move(*device) : nullptr;
    }
    static void set(Device& device, const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        const auto written = device.writeParameters(change);
        ASSERT_TRUE(written) << written.error().message;
    }
    static double signal(Device& device, const std::string& name) {
        const std::string names[] = {name};
        const auto values = device.readSignals(names);
        EXPECT_TRUE(values) << name;
        return values ? values->front() : NAN;
    }
};

TEST_F(ToyDevice, isListedAndDescribesItself) {
    bool isListed = false;
    for (const DeviceListing& listing : listDevices()) {
        isListed = isListed || listing.uri == "sim:toy";
    }
    EXPECT_TRUE(isListed);
    const auto device = open("sim:toy?m=0.5&seed=4");
    ASSERT_TRUE(device);
    EXPECT_EQ(device->info().model, "toy");
    EXPECT_EQ(device->info().id, "sim-toy-4");
    EXPECT_TRUE(device->info().isSimulated);
    ASSERT_NE(device->catalogue().findSignal("position.x"), nullptr);
    EXPECT_EQ(device->catalogue().findSignal("position.x")->unit, "m");
    EXPECT_NE(device->catalogue().findSignal("truth.position.y"), nullptr);
    EXPECT_NE(device->catalogue().findParameter("gain.y.kp"), nullptr);
}

TEST_F(ToyDevice, movesByNewtonsLawAndShowsEveryTick) {
    const auto device = open("sim:toy?m=0.5");
    ASSERT_TRUE(device);
    set(*device, "hb.mode", 1.0); // effort
    ASSERT_TRUE(device->arm());
    std::vector<double> times_s;
    std::vector<double> positions_m;
    ASSERT_TRUE(device->startStream({{"position.x", "position.y"}, 1000.0}, [&](const SampleBlockPtr& block) {
        times_s.insert(times_s.end(), block->time_s.begin(), block->time_s.end());
        positions_m.insert(positions_m.end(), block->values.begin(), block->values.end());
    }));
    set(*device, "hb.setpoint.x", 0.2);
    set(*device, "hb.setpoint.y", 0.2);
    ASSERT_TRUE(device->clock().waitFor(0.2));
    device->stopStream();
    ASSERT_GE(times_s.size(), 190U);
    ASSERT_EQ(positions_m.size(), 2 * times_s.size());
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        ASSERT_NEAR(times_s[i] - times_s[i - 1], 0.001, 1e-9) << i;
    }
    // 5 N/A 0.2 A = 1 N on 0.5 kg and 1 N s/m: v = 1 m/s (1 - exp(-2 t)), x = t - (1 - exp(-2 t))/2. On y
    // 0.3 N of friction leave 0.7 N. The current of x starts up to two ticks and a sub-step late, 2 x 1.2 %
    // of a motion that grows with t^2.
    const double t_s = times_s.back() - times_s.front();
    const double expected_m = t_s - 0.5 * (1.0 - std::exp(-2.0 * t_s));
    EXPECT_NEAR(positions_m[positions_m.size() - 2], expected_m, 0.03 * expected_m);
    EXPECT_NEAR(positions_m.back(), 0.7 * expected_m, 0.03 * expected_m);
}

TEST_F(ToyDevice, staysWhereFrictionHoldsIt) {
    const auto device = open("sim:toy");
    ASSERT_TRUE(device);
    set(*device, "hb.mode", 1.0); // effort
    ASSERT_TRUE(device->arm());
    set(*device, "hb.setpoint.y", 0.05); // 0.25 N of 0.3 N
    ASSERT_TRUE(device->clock().waitFor(0.5));
    EXPECT_EQ(signal(*device, "truth.position.y"), 0.0);
}

TEST_F(ToyDevice, holdsTwoPositionsAndIsStopped) {
    const auto device = open("sim:toy");
    ASSERT_TRUE(device);
    set(*device, "hb.mode", 2.0); // position
    ASSERT_TRUE(device->arm());
    set(*device, "hb.setpoint.x", 0.003);
    set(*device, "hb.setpoint.y", -0.003);
    ASSERT_TRUE(device->clock().waitFor(1.0));
    // m x'' = 5 (100 (r - x) - 5 x') - x': 50 rad/s, damping ratio 1.3: settled to 1e-6 within 1 s. Friction
    // of 0.3 N stops y up to 0.3 N/(500 N/m) = 0.6 mm before.
    EXPECT_NEAR(signal(*device, "truth.position.x"), 0.003, 1e-6);
    EXPECT_NEAR(signal(*device, "truth.position.y"), -0.003, 0.6e-3);
    device->stop();
    EXPECT_TRUE(device->state().isStopLatched);
    EXPECT_EQ(signal(*device, "effort.x"), 0.0);
    EXPECT_EQ(signal(*device, "effort.y"), 0.0);
    EXPECT_FALSE(device->arm());
}

TEST_F(ToyDevice, refusesWhatItsOwnTableDoesNotKnow) {
    const auto unknown = openDevice("sim:toy?c=2e-3", {});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::UnknownName);
    EXPECT_EQ(unknown.error().message, "sim:toy has no override 'c'");
    EXPECT_NE(unknown.error().hint.find("m, seed"), std::string::npos);
    EXPECT_EQ(openDevice("sim:toy?m=0", {}).error().code, ErrorCode::OutOfRange);
    const auto nothing = openDevice("sim:nothing", {});
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().code, ErrorCode::UnknownName);
    EXPECT_NE(nothing.error().hint.find("sim:htm"), std::string::npos);
    EXPECT_NE(nothing.error().hint.find("sim:toy"), std::string::npos);
}

} // namespace
} // namespace halbench::devices
