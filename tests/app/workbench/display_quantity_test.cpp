#include "app/workbench/display_quantity.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

constexpr double Pi = 3.14159265358979323846;

// One turn per second is 2 pi rad/s, 60 r/min and 360 degrees/s.
TEST(DisplayQuantity, oneTurnPerSecondInEveryUnitOfSpeed) {
    const double speed_rad_s = 2.0 * Pi;
    const std::tuple<SpeedUnit, QString, double> cases[] = {
        {SpeedUnit::TurnsPerMinute, "r/min", 60.0},
        {SpeedUnit::DegreesPerSecond, QString::fromUtf8("\u00b0/s"), 360.0},
        {SpeedUnit::RadiansPerSecond, "rad/s", speed_rad_s}};
    for (const auto& [unit, text, value] : cases) {
        const DisplayQuantity shown = displayQuantity("rad/s", {widgets::AngleUnit::Degree, unit});
        EXPECT_EQ(shown.unit, text);
        EXPECT_DOUBLE_EQ(shown.factor * speed_rad_s, value);
        EXPECT_EQ(shown.quantity, "speed");
    }
}

TEST(DisplayQuantity, aPartOfAQuaternionIsARatioAndACodeIsAState) {
    const auto shown = [](const char* unit, double min, double max) {
        SignalSpec spec;
        spec.unit = unit;
        spec.min = min;
        spec.max = max;
        return signalQuantity(spec, {});
    };
    EXPECT_EQ(shown("", -1.0, 1.0).decimals, 4);
    EXPECT_EQ(shown("", 0.0, 255.0).decimals, 0);
    EXPECT_EQ(shown("T", -1.0, 1.0).unit, "mT");
}

TEST(DisplayQuantity, aSumOfSquaresIsNoState) {
    SignalSpec spec;
    spec.name = "chi_square";
    spec.max = 1e9;
    EXPECT_EQ(signalQuantity(spec, {}).decimals, 2);
}

TEST(DisplayQuantity, aRightAngleInBothUnits) {
    EXPECT_DOUBLE_EQ(displayQuantity("rad", {}).factor * Pi / 2.0, 90.0);
    EXPECT_DOUBLE_EQ(displayQuantity("rad", {widgets::AngleUnit::Radian, {}}).factor * Pi / 2.0, Pi / 2.0);
}

TEST(DisplayQuantity, whatNobodyChoosesStaysAsItIs) {
    const DisplayUnits other{widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond};
    for (const char* symbol : {"A", "T", "degC", "s", "Hz", "A/s"}) {
        EXPECT_EQ(displayQuantity(symbol, other).unit, displayQuantity(symbol, {}).unit) << symbol;
        EXPECT_EQ(displayQuantity(symbol, other).factor, displayQuantity(symbol, {}).factor) << symbol;
    }
    EXPECT_DOUBLE_EQ(displayQuantity("T", {}).factor * 0.157, 157.0);
}

// A platen's steps of micrometres keep a digit: 1.2345 mm, not 0.0012 m.
TEST(DisplayQuantity, lengthsAndForcesOfAPlatenKeepTheirDigits) {
    const DisplayQuantity length = displayQuantity("m", {});
    EXPECT_EQ(length.unit, "mm");
    EXPECT_DOUBLE_EQ(length.factor * 1.2345e-3, 1.2345);
    EXPECT_EQ(length.decimals, 4);
    EXPECT_EQ(displayQuantity("m/s", {}).unit, "mm/s");
    EXPECT_EQ(displayQuantity("m/s", {}).quantity, "velocity");
    EXPECT_DOUBLE_EQ(displayQuantity("N*m", {}).factor * 2e-3, 2.0);
    EXPECT_EQ(displayQuantity("N", {}).factor, 1.0);
}

} // namespace
} // namespace halbench::app
