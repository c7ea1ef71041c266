#include "app/workbench/display_quantity.h"

#include "control/base/unit_text.h"
#include "control/base/units.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>
#include <string_view>

namespace halbench::app {

namespace {

constexpr char Degree[] = "\u00b0";
constexpr char DegreePerSecond[] = "\u00b0/s";
constexpr char Context[] = "halbench::app::DisplayQuantity";

struct Row {
    const char* symbol;
    const char* quantity;
    const char* unit;
    double factor;
    int decimals;
    double typical;
};

constexpr Row Rows[] = {
    {"rad", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "angle"), Degree, 180.0 / Pi, 2, 99999.0},
    {"rad", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "angle"), "rad", 1.0, 4, 9999.0},
    {"rad/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "speed"),
     QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "r/min"), 30.0 / Pi, 1, 9999.0},
    {"rad/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "speed"), DegreePerSecond, 180.0 / Pi, 1,
     99999.0},
    {"rad/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "speed"), "rad/s", 1.0, 2, 999.0},
    {"A", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "current"), "A", 1.0, 3, 9.0},
    {"T", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "field"), "mT", 1000.0, 2, 999.0},
    {"m", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "length"), "mm", 1000.0, 4, 99.0},
    {"m/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "velocity"), "mm/s", 1000.0, 2, 999.0},
    {"N", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "force"), "N", 1.0, 3, 99.0},
    {"N*m", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "torque"), "mN\u00b7m", 1000.0, 3, 99.0},
    {"degC", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "temperature"), "\u00b0C", 1.0, 1, 999.0},
    {"s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "time"), "s", 1.0, 3, 999.0},
    {"Hz", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "frequency"), "Hz", 1.0, 2, 999.0},
    {"A/s", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "current slope"), "A/s", 1.0, 2, 99.0},
    {"1", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "ratio"), "", 1.0, 4, 999.0},
    {"", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "state"), "", 1.0, 0, 9999.0},
};

/// As the rows above write it; empty where nobody has a choice.
std::string_view wantedUnit(const std::string& symbol, const DisplayUnits& units) {
    if (symbol == "rad") {
        return units.angle == widgets::AngleUnit::Degree ? Degree : "rad";
    }
    if (symbol == "rad/s") {
        return units.speed == SpeedUnit::TurnsPerMinute     ? "r/min"
               : units.speed == SpeedUnit::DegreesPerSecond ? DegreePerSecond
                                                            : "rad/s";
    }
    return {};
}

struct Words {
    const char* name;
    const char* words;
};

constexpr Words Signals[] = {
    {"position", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Angle")},
    {"speed", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Speed")},
    {"reference", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Reference")},
    {"current_command", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Current command")},
    {"current.a", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Current A")},
    {"current.b", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Current B")},
    {"hall.a", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Hall A")},
    {"hall.b", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Hall B")},
    {"coil_temperature.a", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Coil A")},
    {"coil_temperature.b", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Coil B")},
    {"status", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Board state")},
    {"fault", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Fault code")},
    {"torn_count", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Inconsistent parameter sets")},
    {"reference.segment", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Generator segment")},
    {"reference.running", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Generator running")},
    {"capture.state", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Capture state")},
    {"capture.time", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Capture time")},
    {"truth.position", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True angle")},
    {"truth.speed", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True speed")},
    {"lift", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Lift force")},
    {"chi_square", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Chi-square")},
    {"innovation_square", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Squared innovation")},
    {"current_scale", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Current scale")},
    {"cell.x", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Cell x")},
    {"cell.y", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Cell y")},
    {"chips_left_out", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Sensors left out")},
    {"channels_left_out", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Channels left out")},
    {"homed", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Homed")},
    {"strength", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Field strength")},
    {"strength.expected", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Expected field strength")},
    {"shaft.cone95", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Shaft cone (95 %)")},
    {"orientation.fresh", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Orientation state")},
    {"integrity", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Integrity code")},
    {"coil.current", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Coil current")},
    {"temperature", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Temperature")},
    {"truth.strength", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True field strength")},
};

/// Of signals that there are one of for each axis, coil or sensor: %1 is the sign of it.
constexpr Words Families[] = {
    {"position.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Position %1")},
    {"speed.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Speed %1")},
    {"reference.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Reference %1")},
    {"command.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Command %1")},
    {"effort.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Effort %1")},
    {"truth.position.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True position %1")},
    {"truth.speed.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True speed %1")},
    {"truth.effort.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True effort %1")},
    {"orientation.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Orientation %1")},
    {"shaft.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Shaft %1")},
    {"truth.rate.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True rate %1")},
    {"truth.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "True orientation %1")},
    {"hall.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Hall %1")},
    {"current.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Current %1")},
    {"coil_temperature.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Coil %1")},
    {"field.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Field %1")},
    {"residual.", QT_TRANSLATE_NOOP("halbench::app::DisplayQuantity", "Residual %1")},
};

/// The signs of axes as formulas have them.
constexpr Words Signs[] = {
    {"x", "x"},        {"y", "y"},          {"z", "z"},          {"w", "w"},         {"r", "R"},
    {"phi", "\u03c6"}, {"theta", "\u03b8"}, {"alpha", "\u03b1"}, {"beta", "\u03b2"}, {"gamma", "\u03b3"},
};

QString signOf(std::string_view axis) {
    for (const Words& row : Signs) {
        if (axis == row.name) {
            return QString::fromUtf8(row.words);
        }
    }
    return {};
}

/// "x", "x1", "coil3" and "0.phi" as "x", "x1", "3" and "0 \u03c6"; empty for anything else.
QString memberWords(const std::string& member) {
    static const QRegularExpression parts(QStringLiteral("^(?:coil(\\d)|(\\d)\\.([a-z]+)|([a-z]+)(\\d?))$"));
    const QRegularExpressionMatch found = parts.match(QString::fromStdString(member));
    if (!found.captured(1).isEmpty()) {
        return found.captured(1);
    }
    const bool isOfSensor = !found.captured(2).isEmpty();
    const QString sign = signOf(found.captured(isOfSensor ? 3 : 4).toStdString());
    if (sign.isEmpty()) {
        return {};
    }
    return isOfSensor ? found.captured(2) + QChar(QChar::Nbsp) + sign : sign + found.captured(5);
}

/// Empty for a signal of no family.
QString familyWords(const std::string& name) {
    for (const Words& row : Families) {
        const std::string_view prefix = row.name;
        if (name.starts_with(prefix)) {
            const QString member = memberWords(name.substr(prefix.size()));
            if (!member.isEmpty()) {
                return QCoreApplication::translate(Context, row.words).arg(member);
            }
        }
    }
    return {};
}

} // namespace

DisplayQuantity displayQuantity(const std::string& symbol, const DisplayUnits& units) {
    const std::string_view wanted = wantedUnit(symbol, units);
    for (const Row& row : Rows) {
        if (symbol == row.symbol && (wanted.empty() || wanted == row.unit)) {
            return {QCoreApplication::translate(Context, row.quantity),
                    QCoreApplication::translate(Context, row.unit), row.factor, row.decimals, row.typical};
        }
    }
    const std::optional<Unit> unit = findUnit(symbol);
    const QString quantity = unit ? widgets::inWords(std::string(unit->quantity)) : QString();
    return {quantity, QString::fromStdString(unitText(symbol)), 1.0, 4, 999.0};
}

DisplayQuantity signalQuantity(const SignalSpec& spec, const DisplayUnits& units) {
    const bool isPlain = spec.unit.empty() && spec.choices.empty();
    if (isPlain && spec.name.ends_with("_square")) {
        DisplayQuantity square = displayQuantity("1", units);
        square.decimals = 2;
        return square;
    }
    const bool isRatio = isPlain && spec.min == -1.0 && spec.max == 1.0;
    return displayQuantity(isRatio ? "1" : spec.unit, units);
}

double shownStep(const DisplayQuantity& shown, double step) {
    return std::pow(10.0, std::round(std::log10(step * shown.factor)));
}

QString angleText(double angle_rad, const DisplayUnits& units, int significantDigits) {
    const widgets::DisplayUnit shown = widgets::displayUnit("rad", units.angle);
    const bool isDegree = units.angle == widgets::AngleUnit::Degree;
    return widgets::numberText(angle_rad * shown.factor, significantDigits) +
           (isDegree ? QString::fromUtf8(Degree) : QStringLiteral(" rad"));
}

QString speedText(double speed_rad_s, const DisplayUnits& units, int significantDigits) {
    const DisplayQuantity shown = displayQuantity("rad/s", units);
    return widgets::numberText(speed_rad_s * shown.factor, significantDigits) + QLatin1Char(' ') + shown.unit;
}

QString signalWords(const std::string& name) {
    for (const Words& row : Signals) {
        if (name == row.name) {
            return QCoreApplication::translate(Context, row.words);
        }
    }
    const QString family = familyWords(name);
    return family.isEmpty() ? QString::fromStdString(name) : family;
}

} // namespace halbench::app
