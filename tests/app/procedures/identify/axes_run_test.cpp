#include "app/procedures/identify/axes_run.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

constexpr const char* Gain = "gain.x.kp";

std::unique_ptr<devices::Device> openPositioner() {
    auto device = devices::openDevice("sim:planar", {});
    EXPECT_TRUE(device) << (device ? "" : device.error().message);
    return device ? std::move(*device) : nullptr;
}

double gainOf(devices::Device& device) {
    const std::string names[] = {Gain};
    const auto values = device.readParameters(names);
    EXPECT_TRUE(values);
    return values ? values->front() : NAN;
}

Result<void> fits(const devices::Catalogue&, const IdentifyConfig&) {
    return {};
}

Result<void> fitsNot(const devices::Catalogue&, const IdentifyConfig&) {
    return failure(ErrorCode::Usage, "not like this", "");
}

std::vector<std::string> theGain(const devices::Catalogue&) {
    return {Gain};
}

Result<void> changeGain(devices::Device& device) {
    const ParameterValue other{Gain, 1.5 * gainOf(device)};
    return device.writeParameters(std::span(&other, 1));
}

Result<AxesIdentifyResult> measureOne(devices::Device& device, const IdentifyConfig&,
                                      const ProcedureObserver&, const std::vector<devices::AxisSpec>& axes,
                                      const MeasuredTiming&) {
    EXPECT_EQ(axes.size(), 3U) << "no axis named: all";
    EXPECT_TRUE(changeGain(device));
    return AxesIdentifyResult{};
}

Result<AxesIdentifyResult> fail(devices::Device& device, const IdentifyConfig&, const ProcedureObserver&,
                                const std::vector<devices::AxisSpec>&, const MeasuredTiming&) {
    EXPECT_TRUE(changeGain(device));
    return failure(ErrorCode::SafetyStop, "a limit", "");
}

TEST(AxesRun, restoresOnEveryWayOut) {
    const auto device = openPositioner();
    ASSERT_TRUE(device);
    const double before = gainOf(*device);
    std::vector<ProcedureState> states;
    ProcedureObserver observer;
    observer.onState = [&states](ProcedureState state) { states.push_back(state); };
    EXPECT_TRUE(runAxes({fits, theGain, measureOne}, *device, {}, observer));
    EXPECT_EQ(gainOf(*device), before);
    EXPECT_EQ(states, (std::vector{ProcedureState::Prepare, ProcedureState::Done}));
    states.clear();
    const auto failed = runAxes({fits, theGain, fail}, *device, {}, observer);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, ErrorCode::SafetyStop);
    EXPECT_EQ(gainOf(*device), before);
    EXPECT_EQ(states, (std::vector{ProcedureState::Prepare, ProcedureState::Restored}));
}

TEST(AxesRun, measuresNothingThatDoesNotFit) {
    const auto device = openPositioner();
    ASSERT_TRUE(device);
    const auto result = runAxes({fitsNot, theGain, fail}, *device, {}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "not like this");
    IdentifyConfig config;
    config.axis = "z";
    EXPECT_EQ(runAxes({fits, theGain, fail}, *device, config, {}).error().code, ErrorCode::UnknownName);
}

TEST(AxesRun, optionsOfAMotorAndImpossibleInertiasAreRefused) {
    const auto device = openPositioner();
    ASSERT_TRUE(device);
    EXPECT_TRUE(checkAxesOptions(device->catalogue(), {}, "take an axis"));
    IdentifyConfig config;
    config.usableSpeed_rad_s = 5.0;
    const auto refused = checkAxesOptions(device->catalogue(), config, "take an axis");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().hint, "take an axis");
    EXPECT_TRUE(checkGivenInertia("m", 0.9));
    for (const double value : {0.0, -1.0}) {
        EXPECT_EQ(checkGivenInertia("m", value).error().code, ErrorCode::OutOfRange) << value;
    }
    for (const double value : {std::nan(""), HUGE_VAL}) {
        EXPECT_EQ(checkGivenInertia("m", value).error().code, ErrorCode::NotFinite) << value;
    }
}

} // namespace
} // namespace halbench::app
