#include "app/procedures/frequency/frequency_board.h"
#include "tests/app/procedures/simulated_motor.h"

namespace halbench::app {
namespace {

TEST(FrequencyBoard, theLoopIsThatOfTheBoard) {
    auto device = openMotor("imperfections=off");
    setParameter(*device, "gain.kp", 7.0);
    const auto margins = readFrequencyMargins(*device);
    ASSERT_TRUE(margins) << margins.error().message;
    EXPECT_EQ(margins->law.kp_A_per_rad, 7.0);
    EXPECT_EQ(margins->period_s, 0.01);
    EXPECT_NEAR(margins->plant.accelerationGain_rad_s2_A, 26.0, 1e-9); // 1.43e-2/5.5e-4
    setParameter(*device, "control.law", 1.0);
    EXPECT_EQ(readFrequencyMargins(*device).error().code, ErrorCode::Refused);
}

TEST(FrequencyBoard, aBoardWithoutWhatIsNeededIsNamed) {
    auto device = openMotor("imperfections=off");
    devices::Catalogue catalogue = device->catalogue();
    EXPECT_TRUE(checkFrequencyBoard(catalogue, {}));
    std::erase_if(catalogue.parameters,
                  [](const ParameterSpec& each) { return each.name == "reference.frequency_end"; });
    const auto plain = checkFrequencyBoard(catalogue, {});
    ASSERT_FALSE(plain);
    EXPECT_NE(plain.error().hint.find("stepped sine"), std::string::npos);
    FrequencyConfig stepped;
    stepped.excitation = Excitation::SteppedSine;
    EXPECT_TRUE(checkFrequencyBoard(catalogue, stepped));
    std::erase_if(catalogue.signals, [](const SignalSpec& each) { return each.name == "reference"; });
    EXPECT_EQ(checkFrequencyBoard(catalogue, stepped).error().code, ErrorCode::DeviceRefused);
}

} // namespace
} // namespace halbench::app
