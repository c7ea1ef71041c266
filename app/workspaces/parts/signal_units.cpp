#include "app/workspaces/parts/signal_units.h"

#include "control/base/units.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace halbench::app {

namespace {

constexpr char Context[] = "halbench::app::DisplayQuantity";

/// Each unit of a quantity has about the same smallest step, finer where it is chosen to look closely.
struct Row {
    const char* symbol; ///< SI
    const char* key;    ///< as `halbench import --unit` spells it
    const char* text;
    double factor;
    int decimals;
};

constexpr Row Rows[] = {
    {"rad", "deg", "\u00b0", 180.0 / Pi, 2},
    {"rad", "rad", "rad", 1.0, 4},
    {"rad", "mrad", "mrad", 1e3, 2},
    {"rad", "urad", "\u00b5rad", 1e6, 0},
    {"rad", "rev", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "rev"), 0.5 / Pi, 5},
    {"rad/s", "r/min", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "r/min"), 30.0 / Pi, 1},
    {"rad/s", "deg/s", "\u00b0/s", 180.0 / Pi, 1},
    {"rad/s", "rad/s", "rad/s", 1.0, 2},
    {"rad/s", "mrad/s", "mrad/s", 1e3, 1},
    {"rad/s", "rev/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "rev/s"), 0.5 / Pi, 4},
    {"A", "A", "A", 1.0, 3},
    {"A", "mA", "mA", 1e3, 1},
    {"A", "uA", "\u00b5A", 1e6, 0},
    {"T", "T", "T", 1.0, 5},
    {"T", "mT", "mT", 1e3, 2},
    {"T", "uT", "\u00b5T", 1e6, 0},
    {"V", "V", "V", 1.0, 4},
    {"V", "mV", "mV", 1e3, 2},
    {"V", "uV", "\u00b5V", 1e6, 0},
    {"s", "s", "s", 1.0, 3},
    {"s", "ms", "ms", 1e3, 3},
    {"s", "us", "\u00b5s", 1e6, 1},
    {"Hz", "Hz", "Hz", 1.0, 2},
    {"Hz", "kHz", "kHz", 1e-3, 5},
    {"N*m", "Nm", "N\u00b7m", 1.0, 4},
    {"N*m", "mNm", "mN\u00b7m", 1e3, 2},
    {"1", "1", "", 1.0, 4},
    {"1", "%", "%", 1e2, 2},
};

} // namespace

std::vector<widgets::UnitChoice> unitChoices(const std::string& symbol, const DisplayUnits& units) {
    std::vector<widgets::UnitChoice> choices;
    for (const Row& row : Rows) {
        if (symbol == row.symbol) {
            const QString text =
                *row.text == '\0' ? QString() : QCoreApplication::translate(Context, row.text);
            choices.push_back({row.key, text, row.factor, row.decimals});
        }
    }
    if (!choices.empty()) {
        const DisplayQuantity preferred = displayQuantity(symbol, units);
        choices.insert(choices.begin(), {{}, preferred.unit, preferred.factor, preferred.decimals});
    }
    return choices;
}

bool isDisplayUnit(const std::string& key) {
    return std::any_of(std::begin(Rows), std::end(Rows), [&](const Row& row) { return key == row.key; });
}

std::string displayUnitNames() {
    std::string names;
    for (const Row& row : Rows) {
        names += names.empty() ? row.key : std::string(", ") + row.key;
    }
    return names;
}

} // namespace halbench::app
