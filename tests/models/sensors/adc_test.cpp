#include "models/sensors/adc.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

TEST(Adc, oneCodeIsTheQuotedFieldStep) {
    const AdcConfig adc;
    // 5 V / 1024 / 12.5 mV/mT = 0.390625 mT (printed 0.39); at 80 degC 1.066 times the sensitivity.
    EXPECT_DOUBLE_EQ(adcStep_V(adc) / 12.5, 0.390625e-3);
    EXPECT_NEAR(adcStep_V(adc) / (12.5 * 1.066), 0.3664e-3, 5e-8);
    // The temperature sensor gives 10 mV/K: one code is 0.488 K.
    EXPECT_NEAR(adcStep_V(adc) / 0.01, 0.488, 5e-4);
}

TEST(Adc, roundsDownAndReconstructsInTheMiddle) {
    const AdcConfig adc;
    const double step_V = adcStep_V(adc);
    EXPECT_EQ(adcCode(adc, 0.0), 0.0);
    EXPECT_EQ(adcCode(adc, 511.999 * step_V), 511.0);
    EXPECT_EQ(adcCode(adc, 512.0 * step_V), 512.0);
    EXPECT_DOUBLE_EQ(adcVoltage_V(adc, 512.0), 512.5 * step_V);
}

TEST(Adc, clipsAtBothEnds) {
    AdcConfig adc;
    EXPECT_EQ(adcCode(adc, -0.1), 0.0);
    EXPECT_EQ(adcCode(adc, 5.0), 1023.0);
    adc.isQuantised = false;
    EXPECT_EQ(adcVoltage_V(adc, adcCode(adc, 7.0)), 5.0);
    EXPECT_EQ(adcVoltage_V(adc, adcCode(adc, -7.0)), 0.0);
}

TEST(Adc, idealChainReturnsTheVoltageItself) {
    AdcConfig adc;
    adc.isQuantised = false;
    for (const double voltage_V : {0.2, 1.234567, 2.5, 4.8}) {
        // One subtraction and one addition near 1024 lose at most two rounding errors of 1024 * 1.1e-16
        // codes.
        EXPECT_NEAR(adcVoltage_V(adc, adcCode(adc, voltage_V)), voltage_V, 3e-15);
    }
}

} // namespace
} // namespace halbench::models
