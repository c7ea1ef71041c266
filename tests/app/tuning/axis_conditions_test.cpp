#include "app/tuning/axis_conditions.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

AxisModelFile model(const std::string& device) {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModelFile file;
    file.header.device = devices::DeviceInfo{};
    file.header.device->model = device;
    file.model.axes.push_back({"y", "m", "N", known(0.0, "1/s"), known(1.5, "m/(s^2*N)"), {}, {2e-3, 2}});
    file.model.axes.push_back({"phi", "rad", "N*m", known(0.0, "1/s"), known(1e3, "rad/(s^2*N*m)"), {}, {}});
    return file;
}

TEST(AxisConditions, ofAModelComeFromItsProfileAndItsTiming) {
    const auto all = axisConditionsOf(model("planar"), {"phi", "y"});
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->size(), 2u);
    EXPECT_EQ((*all)[0].axis->id, "phi");
    EXPECT_EQ((*all)[0].timing.period_s, 1e-3); // of the profile
    // Forces available at every position with 1 A (resources/help/planar-theory.md section 6).
    EXPECT_EQ((*all)[0].currentLimit_A, 0.236);
    EXPECT_EQ((*all)[1].currentLimit_A, 6.195);
    EXPECT_EQ((*all)[1].timing, (control::LoopTiming{2e-3, 2})); // as measured
    EXPECT_EQ((*all)[0].axis->designFrequency_rad_s, 60.0);      // section 9
    EXPECT_EQ((*all)[1].axis->designFrequency_rad_s, 30.0);
}

TEST(AxisConditions, ofAModelWithoutProfileHaveNoEffortLimit) {
    const auto all = axisConditionsOf(model("something"), {"y"});
    ASSERT_TRUE(all);
    EXPECT_EQ((*all)[0].currentLimit_A, UnknownEffortLimit);
    EXPECT_EQ((*all)[0].axis->effortUnit, "N");
    EXPECT_EQ((*all)[0].axis->testStep, LoopAxis::usualStep("m"));
}

TEST(AxisConditions, ofADeviceFollowItsCurrentLimitAndDelay) {
    const auto device = devices::openDevice("sim:planar", {});
    ASSERT_TRUE(device);
    const ParameterValue half[] = {{"limit.current", 0.5}, {"delay.samples", 2.0}};
    ASSERT_TRUE((*device)->writeParameters(half));
    const auto all = axisConditionsOf(**device, {"x"});
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_NEAR((*all)[0].currentLimit_A, 0.5 * 3.098, 1e-9);
    EXPECT_EQ((*all)[0].timing, (control::LoopTiming{1e-3, 2}));
    const auto unknown = axisConditionsOf(**device, {"z"});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::UnknownName);
    EXPECT_NE(unknown.error().hint.find("x, y, phi"), std::string::npos);
}

TEST(AxisConditions, lawsAreFoundByTheirAxis) {
    AxisGainsFile file;
    file.axes = {"x", "y"};
    file.gains.resize(2);
    file.gains[1].law.gains.proportional = 5.0;
    file.gains[1].method = "bandwidth";
    const auto laws = lawsOf(file, {"y"});
    ASSERT_TRUE(laws);
    EXPECT_EQ(laws->laws[0].law.gains.proportional, 5.0);
    EXPECT_EQ(laws->methods[0], "bandwidth");
    EXPECT_EQ(lawsOf(file, {"phi"}).error().code, ErrorCode::UnknownName);
}

} // namespace
} // namespace halbench::app
