#include "control/base/parameter_spec.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace halbench {
namespace {

ParameterSpec gain() {
    ParameterSpec spec;
    spec.name = "gain.kp";
    spec.unit = "A/rad";
    spec.min = 0.0;
    spec.max = 600.0;
    return spec;
}

TEST(ParameterSpec, acceptsBothEndsOfTheRange) {
    EXPECT_TRUE(checkParameterValue(gain(), 0.0).has_value());
    EXPECT_TRUE(checkParameterValue(gain(), 600.0).has_value());
}

TEST(ParameterSpec, refusesWhatIsNotFiniteBeforeItLooksAtTheRange) {
    EXPECT_EQ(checkParameterValue(gain(), std::numeric_limits<double>::quiet_NaN()).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(checkParameterValue(gain(), std::numeric_limits<double>::infinity()).error().code,
              ErrorCode::NotFinite);
}

TEST(ParameterSpec, namesTheParameterAndTheAllowedRange) {
    const auto result = checkParameterValue(gain(), 700.0);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(result.error().message.find("gain.kp"), std::string::npos);
    EXPECT_NE(result.error().hint.find("600"), std::string::npos);
}

TEST(ParameterSpec, writesTheUnitWhereThereIsOne) {
    ParameterSpec spec = gain();
    EXPECT_EQ(checkParameterValue(spec, 700.0).error().message,
              "parameter 'gain.kp' = 700 A/rad is out of range");
    EXPECT_EQ(checkParameterValue(spec, 700.0).error().hint, "allowed is 0 to 600 A/rad");
    spec.unit.clear();
    EXPECT_EQ(checkParameterValue(spec, 700.0).error().message, "parameter 'gain.kp' = 700 is out of range");
    EXPECT_EQ(checkParameterValue(spec, 700.0).error().hint, "allowed is 0 to 600");
}

TEST(ParameterSpec, refusesAFractionForAWholeNumber) {
    ParameterSpec spec = gain();
    spec.isInteger = true;
    EXPECT_EQ(checkParameterValue(spec, 1.5).error().code, ErrorCode::OutOfRange);
    EXPECT_TRUE(checkParameterValue(spec, 2.0).has_value());
}

TEST(Units, speedsOfThePublicationConvert) {
    // resources/help/htm-theory.md section 5: 500 deg/s are 83.3 r/min; 270 r/min = 9 pi rad/s.
    EXPECT_NEAR(radPerSecondToRpm(degreesToRadians(500.0)), 83.3, 0.05);
    EXPECT_NEAR(rpmToRadPerSecond(270.0), 9.0 * Pi, 1e-14);
}

TEST(Units, symbolsAreUnique) {
    std::set<std::string_view> seen;
    for (const Unit& unit : units()) {
        EXPECT_TRUE(seen.insert(unit.symbol).second) << unit.symbol;
    }
}

} // namespace
} // namespace halbench
