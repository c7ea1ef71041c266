#include "app/workspaces/parts/signal_units.h"
#include "control/base/units.h"
#include "devices/formats/foreign_unit.h"

#include <gtest/gtest.h>

#include <set>

namespace halbench::app {
namespace {

constexpr const char* Symbols[] = {"rad", "rad/s", "A", "T", "V", "s", "Hz", "N*m", "1"};

const widgets::UnitChoice& choice(const std::vector<widgets::UnitChoice>& choices, const std::string& key) {
    for (const widgets::UnitChoice& each : choices) {
        if (each.key == key) {
            return each;
        }
    }
    ADD_FAILURE() << key;
    return choices.front();
}

// What import reads of a unit, by its own table, is what it was shown from: factor x (factor / divisor) = 1.
// Three roundings: 4 ulp.
TEST(SignalUnits, importReadsBackWhatIsShown) {
    int compared = 0;
    for (const char* symbol : Symbols) {
        for (const widgets::UnitChoice& each : unitChoices(symbol, {})) {
            const auto foreign = devices::readForeignUnit(each.key);
            if (each.key.empty() || each.key == "1" || each.key == "%" || !foreign) {
                continue; // without unit, or one that no table of another program has
            }
            EXPECT_EQ(foreign->symbol, symbol) << each.key;
            EXPECT_NEAR(each.factor * foreign->factor / foreign->divisor, 1.0, 1e-15) << each.key;
            ++compared;
        }
    }
    EXPECT_GE(compared, 20);
}

TEST(SignalUnits, aQuarterTurnInEveryUnit) {
    const auto choices = unitChoices("rad", {});
    const double angle_rad = 0.5 * Pi;
    EXPECT_DOUBLE_EQ(choice(choices, "deg").factor * angle_rad, 90.0);
    EXPECT_EQ(choice(choices, "rad").factor * angle_rad, angle_rad);
    EXPECT_EQ(choice(choices, "mrad").factor * angle_rad, 1e3 * angle_rad);
    EXPECT_EQ(choice(choices, "urad").factor * angle_rad, 1e6 * angle_rad);
    EXPECT_DOUBLE_EQ(choice(choices, "rev").factor * angle_rad, 0.25);
    const auto speeds = unitChoices("rad/s", {});
    EXPECT_DOUBLE_EQ(choice(speeds, "rev/s").factor * 2.0 * Pi, 1.0);
    EXPECT_DOUBLE_EQ(choice(speeds, "r/min").factor * 2.0 * Pi, 60.0);
    EXPECT_EQ(choice(speeds, "mrad/s").factor, 1e3);
}

TEST(SignalUnits, theFirstIsThatOfThePreferences) {
    for (const char* symbol : Symbols) {
        for (const DisplayUnits& units :
             {DisplayUnits{}, DisplayUnits{widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond}}) {
            const auto choices = unitChoices(symbol, units);
            const DisplayQuantity preferred = displayQuantity(symbol, units);
            ASSERT_GE(choices.size(), 3U) << symbol;
            EXPECT_EQ(choices[0],
                      (widgets::UnitChoice{"", preferred.unit, preferred.factor, preferred.decimals}));
        }
    }
}

TEST(SignalUnits, keysAreNamesOfOneUnitEach) {
    std::set<std::string> keys;
    for (const char* symbol : Symbols) {
        for (const widgets::UnitChoice& each : unitChoices(symbol, {})) {
            if (!each.key.empty()) {
                EXPECT_TRUE(keys.insert(each.key).second) << each.key;
                EXPECT_TRUE(isDisplayUnit(each.key));
                EXPECT_NE(displayUnitNames().find(each.key), std::string::npos);
            }
        }
    }
    EXPECT_FALSE(isDisplayUnit(""));
    EXPECT_FALSE(isDisplayUnit("furlong"));
}

// A temperature in another unit has another zero, which no factor gives; a state is a number without unit.
TEST(SignalUnits, thereIsNothingToChooseForTemperaturesAndStates) {
    EXPECT_TRUE(unitChoices("degC", {}).empty());
    EXPECT_TRUE(unitChoices("", {}).empty());
}

} // namespace
} // namespace halbench::app
