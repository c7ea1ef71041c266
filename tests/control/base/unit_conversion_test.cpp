#include "control/base/unit_conversion.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench {
namespace {

// Expected values are definitions: a degree is pi/180, a gauss 1e-4 T, r/min 2 pi/60 s; a few roundings of
// 1e-16.
void expectConverted(double value, const char* from, double expected, const char* to) {
    const auto conversion = conversionBetween(from, to);
    ASSERT_TRUE(conversion) << from << " in " << to;
    EXPECT_NEAR((*conversion)(value), expected, 1e-14 * std::abs(expected)) << from << " in " << to;
}

TEST(UnitConversionTest, gainsPerDegreeBecomeGainsPerRadian) {
    expectConverted(10.0, "A/deg", 1800.0 / Pi, "A/rad");
    expectConverted(0.1, "A/(deg*s)", 18.0 / Pi, "A/(rad*s)");
    expectConverted(0.02, "A*s/deg", 3.6 / Pi, "A*s/rad");
    expectConverted(40.0, "mA/mrad", 40.0, "A/rad");
    expectConverted(2.0, "A/rev", 1.0 / Pi, "A/rad");
}

TEST(UnitConversionTest, mechanicalUnitsAreReadAsCataloguesWriteThem) {
    expectConverted(14.3, "mN*m/A", 14.3e-3, "N*m/A");
    expectConverted(14.3, "mNm/A", 14.3e-3, "N*m/A");
    expectConverted(5500.0, "g*cm^2", 5.5e-4, "kg*m^2");
    expectConverted(5500.0, "gcm2", 5.5e-4, "kg*m^2");
    expectConverted(5.5e-4, "kg\xC2\xB7m\xC2\xB2", 5.5e-4, "kg*m^2");
    expectConverted(1.0, "N*m*s/deg", 180.0 / Pi, "N*m*s/rad");
    expectConverted(1.23e-3, "Nms", 1.23e-3, "N*m*s/rad");
    expectConverted(1.0, "mN*m/rpm", 0.03 / Pi, "N*m*s/rad");
    expectConverted(120.0, "1/min", 2.0, "1/s");
}

TEST(UnitConversionTest, signalsComeInEveryUsualUnit) {
    expectConverted(90.0, "deg", Pi / 2.0, "rad");
    expectConverted(0.25, "turns", Pi / 2.0, "rad");
    expectConverted(60.0, "r/min", 2.0 * Pi, "rad/s");
    expectConverted(10.0, "G", 1e-3, "T");
    expectConverted(1500.0, "\xC2\xB5\x41", 1.5e-3, "A"); // micro sign
    expectConverted(300.0, "K", 26.85, "degC");
    expectConverted(212.0, "degF", 100.0, "degC");
}

// A radian is 1 by definition; turns per time squared are written by nobody as 1/s^2.
TEST(UnitConversionTest, accelerationsMayLeaveTheRadianOut) {
    for (const char* text : {"1/(A*s^2)", "s^-2/A", "1/s^2/A", "1/s2/A", "A^-1*s^-2"}) {
        expectConverted(26.0, text, 26.0, "rad/s^2/A");
    }
    expectConverted(26.0, "1/s^2", 26.0, "rad/s^2");
    expectConverted(26.0, "1/(mA*s^2)", 26000.0, "rad/s^2/A");
    expectConverted(2.0, "A*s^2", 2.0, "A*s^2/rad");
    expectConverted(1.0, "Hz/s", 2.0 * Pi, "rad/s^2"); // a frequency that changes
    EXPECT_FALSE(conversionBetween("1/min", "rad/s"));
    EXPECT_FALSE(conversionBetween("Hz", "1/s")) << "turns are no decay";
    EXPECT_FALSE(conversionBetween("A*s", "A*s/rad"));
    EXPECT_FALSE(conversionBetween("1/(A*s)", "rad/s^2/A"));
}

TEST(UnitConversionTest, anotherQuantityIsNotConverted) {
    EXPECT_FALSE(conversionBetween("A", "A/rad"));
    EXPECT_FALSE(conversionBetween("1/s", "rad/s"));
    EXPECT_FALSE(conversionBetween("deg", "degC"));
    EXPECT_FALSE(conversionBetween("mm", "rad"));
    EXPECT_FALSE(conversionBetween("A/deg", "A/(rad*s)"));
    EXPECT_FALSE(conversionBetween("", "A/rad"));
}

TEST(UnitConversionTest, whatIsNoUnitIsNotRead) {
    for (const char* text :
         {"furlong", "A//rad", "A/", "(A", "A)", "10/s", "A^", "*", "m^99", "((((((((((A"}) {
        EXPECT_FALSE(isReadableUnit(text)) << text;
    }
}

TEST(UnitConversionTest, everyUnitOfTheTableIsRead) {
    for (const Unit& unit : units()) {
        EXPECT_TRUE(isReadableUnit(unit.symbol)) << unit.symbol;
    }
}

TEST(UnitConversionTest, aPrefixCostsOneRounding) {
    EXPECT_EQ((*conversionBetween("mA", "A"))(4095.0), 4.095);
    EXPECT_TRUE(conversionBetween("kg*m^2", "kg*m^2")->isIdentity());
    EXPECT_TRUE(conversionBetween("Nm", "N*m")->isIdentity());
}

} // namespace
} // namespace halbench
