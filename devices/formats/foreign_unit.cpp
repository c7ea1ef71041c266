#include "devices/formats/foreign_unit.h"

#include "control/base/unit_conversion.h"
#include "control/base/units.h"

#include <algorithm>
#include <array>

namespace halbench::devices {

namespace {

constexpr double DegreeFactor = Pi / 180.0;
constexpr double RpmFactor = Pi / 30.0;

// Octets beyond ASCII are written out, in UTF-8.
constexpr std::array Table = {
    ForeignUnit{"s", "s"},
    ForeignUnit{"sec", "s"},
    ForeignUnit{"ms", "s", 1.0, 1e3},
    ForeignUnit{"us", "s", 1.0, 1e6},
    ForeignUnit{"\xC2\xB5s", "s", 1.0, 1e6}, // micro sign
    ForeignUnit{"\xCE\xBCs", "s", 1.0, 1e6}, // Greek mu
    ForeignUnit{"ns", "s", 1.0, 1e9},
    ForeignUnit{"rad", "rad"},
    ForeignUnit{"mrad", "rad", 1.0, 1e3},
    ForeignUnit{"deg", "rad", DegreeFactor},
    ForeignUnit{"\xC2\xB0", "rad", DegreeFactor}, // degree sign
    ForeignUnit{"rev", "rad", 2.0 * Pi},
    ForeignUnit{"rad_s", "rad/s"},
    ForeignUnit{"deg/s", "rad/s", DegreeFactor},
    ForeignUnit{"\xC2\xB0/s", "rad/s", DegreeFactor},
    ForeignUnit{"rpm", "rad/s", RpmFactor},
    ForeignUnit{"r/min", "rad/s", RpmFactor},
    ForeignUnit{"U/min", "rad/s", RpmFactor},
    ForeignUnit{"rad/s2", "rad/s^2"},
    ForeignUnit{"rad/s\xC2\xB2", "rad/s^2"},
    ForeignUnit{"kA", "A", 1e3},
    ForeignUnit{"mA", "A", 1.0, 1e3},
    ForeignUnit{"uA", "A", 1.0, 1e6},
    ForeignUnit{"kV", "V", 1e3},
    ForeignUnit{"mV", "V", 1.0, 1e3},
    ForeignUnit{"uV", "V", 1.0, 1e6},
    ForeignUnit{"mT", "T", 1.0, 1e3},
    ForeignUnit{"uT", "T", 1.0, 1e6},
    ForeignUnit{"\xC2\xB0\x43", "degC"}, // degree sign and C
    ForeignUnit{"Nm", "N*m"},
    ForeignUnit{"N.m", "N*m"},
    ForeignUnit{"N\xC2\xB7m", "N*m"}, // middle dot
    ForeignUnit{"mNm", "N*m", 1.0, 1e3},
    ForeignUnit{"kHz", "Hz", 1e3},
    ForeignUnit{"mOhm", "Ohm", 1.0, 1e3},
    ForeignUnit{"\xCE\xA9", "Ohm"}, // Omega
    ForeignUnit{"mH", "H", 1.0, 1e3},
    ForeignUnit{"uH", "H", 1.0, 1e6},
    ForeignUnit{"-", ""},
    ForeignUnit{"1", ""},
};

/// Quantities whose units are read in every way that recordings are. Kelvin is here a difference, and a rate
/// in 1/min may count turns or anything else.
constexpr std::array ReadWidely = {"s", "rad",  "rad/s", "rad/s^2", "A", "V",
                                   "T", "degC", "m",     "m/s",     "N", "N*m"};

std::string_view withoutBrackets(std::string_view text) {
    const bool areSquare = text.size() >= 2 && text.front() == '[' && text.back() == ']';
    const bool areRound = text.size() >= 2 && text.front() == '(' && text.back() == ')';
    return areSquare || areRound ? text.substr(1, text.size() - 2) : text;
}

} // namespace

std::optional<ForeignUnit> readForeignUnit(std::string_view written) {
    const std::string_view text = withoutBrackets(written);
    for (const ForeignUnit& unit : Table) { // before our own: a degree becomes a radian
        if (unit.written == text) {
            return unit;
        }
    }
    if (const std::optional<Unit> unit = findUnit(text)) {
        return ForeignUnit{unit->symbol, unit->symbol};
    }
    for (const char* symbol : ReadWidely) {
        if (const std::optional<UnitConversion> way =
                text == "C" ? std::nullopt : conversionBetween(text, symbol)) {
            return ForeignUnit{symbol, symbol, way->factor, way->divisor, way->offset};
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> foreignUnitWords() {
    std::vector<std::string_view> words;
    for (const ForeignUnit& unit : Table) {
        words.push_back(unit.written);
    }
    for (const Unit& unit : units()) {
        if (!unit.symbol.empty() && std::find(words.begin(), words.end(), unit.symbol) == words.end()) {
            words.push_back(unit.symbol);
        }
    }
    return words;
}

} // namespace halbench::devices
