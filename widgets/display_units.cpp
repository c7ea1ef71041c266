#include "widgets/display_units.h"

#include "control/base/unit_text.h"
#include "control/base/units.h"

#include <QLocale>

#include <cmath>

namespace halbench::widgets {

DisplayUnit displayUnit(const std::string& symbol, AngleUnit angleUnit) {
    const auto shown = [](const std::string& unit) { return QString::fromStdString(unitText(unit)); };
    const auto at = symbol.find("rad");
    if (angleUnit == AngleUnit::Radian || at == std::string::npos) {
        return {shown(symbol), 1.0};
    }
    const bool isBelowTheLine = symbol.find('/') < at;
    std::string inDegrees = symbol;
    inDegrees.replace(at, 3, "deg");
    return {shown(inDegrees), isBelowTheLine ? degreesToRadians(1.0) : radiansToDegrees(1.0)};
}

QString numberText(double value, int significantDigits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', significantDigits);
}

std::optional<double> parseNumber(const QString& text, const QString& unitText) {
    QString number = text.trimmed();
    if (!unitText.isEmpty() && number.endsWith(unitText)) {
        number.chop(unitText.size());
        number = number.trimmed();
    }
    number.replace(QChar(0x2212), QLatin1Char('-')); // the minus sign of typography
    bool isNumber = false;
    QLocale locale;
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    double value = locale.toDouble(number, &isNumber);
    if (!isNumber) {
        value = QLocale::c().toDouble(number, &isNumber);
    }
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool areSameOnBoard(double one, double other) {
    return std::abs(one - other) <= std::ldexp(std::max(std::abs(one), std::abs(other)), -23);
}

} // namespace halbench::widgets
