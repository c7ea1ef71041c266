#include "app/procedures/move/move_prediction.h"
#include "tests/app/procedures/simulated_motor.h"

namespace halbench::app {
namespace {

MoveConfig stepOf(const std::string& axis, const std::string& reference) {
    MoveConfig config = move(reference, 3.0);
    config.axis = axis;
    return config;
}

MotorEstimate freeMass(double mass_kg) {
    MotorEstimate estimate;
    estimate.values = {{"c_over_J", 0.0}, {"phi_over_J", 1.0 / mass_kg}, {"Kf_over_phi", 0.0}};
    return estimate;
}

TEST(MovePrediction, isTheDesignedStepOfTheLawOnTheBoard) {
    const auto device = devices::openDevice("sim:planar", {});
    ASSERT_TRUE(device);
    const auto figures =
        predictAxisMove(**device, stepOf("x", "step,amplitude_um=1000"), freeMass(0.64), 3.098);
    ASSERT_TRUE(figures && *figures);
    // resources/help/planar-theory.md section 9, with its tolerances of section 11.
    EXPECT_NEAR(*(*figures)->riseTime_s, 0.245, 0.02);
    EXPECT_NEAR(*(*figures)->settlingTime_s, 0.968, 0.05);
    EXPECT_LT(*(*figures)->overshoot_percent, 0.5);
}

TEST(MovePrediction, ofAShapeWithoutIdealFormIsNone) {
    const auto device = devices::openDevice("sim:planar", {});
    ASSERT_TRUE(device);
    const auto figures = predictAxisMove(
        **device, stepOf("x", "multisine,amplitude_um=10,frequency_hz=1,frequency_end_hz=10,count=4"),
        freeMass(0.64), 3.098);
    ASSERT_TRUE(figures) << figures.error().message;
    EXPECT_FALSE(*figures);
    EXPECT_FALSE(predictAxisMove(**device, stepOf("z", "step,amplitude_um=10"), freeMass(0.64), 3.0));
}

} // namespace
} // namespace halbench::app
