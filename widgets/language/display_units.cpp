#include "widgets/language/display_units.h"

#include "control/base/unit_text.h"
#include "control/base/units.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
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

namespace {

/// Whether the user's notation would read a point between thousands, as "1.500" in German: what else it could
/// mean differs by a factor of 1000. No thousands begin with a zero.
bool isGrouped(const QString& number) {
    bool isNumber = false;
    QLocale().toDouble(number, &isNumber);
    const int first = number.indexOf(QRegularExpression(QStringLiteral("[0-9]")));
    return isNumber && first >= 0 && number.at(first) != QLatin1Char('0');
}

} // namespace

namespace {

QLocale ungrouped() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

} // namespace

QString tidyExponent(QString number) {
    static const QRegularExpression padding(QStringLiteral("(?<=[0-9][eE])(\\+|(-))?0*(?=[0-9])"));
    return number.replace(padding, QStringLiteral("\\2"));
}

QString numberText(double value, int significantDigits) {
    return tidyExponent(ungrouped().toString(value, 'g', significantDigits));
}

QString exponentText(double value, int decimals) {
    return tidyExponent(ungrouped().toString(value, 'e', decimals));
}

QString countText(quint64 count) {
    return ungrouped().toString(count);
}

QString settingText(double value) {
    constexpr int LeastDigits = 5;
    constexpr int MostDigits = 7; // a board's numbers have no more
    const double whole = std::floor(std::log10(std::max(std::abs(value), 1.0))) + 1.0;
    return numberText(value, static_cast<int>(std::clamp(whole, double(LeastDigits), double(MostDigits))));
}

QString fixedText(const std::optional<double>& value, int decimals) {
    if (!value) {
        return QStringLiteral("\u2013");
    }
    const bool isZero = std::abs(*value) < 0.5 * std::pow(10.0, -decimals);
    return ungrouped().toString(isZero ? 0.0 : *value, 'f', decimals);
}

std::optional<double> parseNumber(const QString& text, const QString& unitText) {
    QString number = text.trimmed();
    const QString spelled = QString(unitText).replace(QChar(0x00b0), QStringLiteral("deg"));
    for (const QString& unit : {unitText, spelled}) {
        if (!unit.isEmpty() && number.endsWith(unit)) {
            number.chop(unit.size());
            number = number.trimmed();
            break;
        }
    }
    number.replace(QChar(0x2212), QLatin1Char('-')); // the minus sign of typography
    const auto read = [&number](QLocale locale) {
        locale.setNumberOptions(QLocale::RejectGroupSeparator);
        bool isNumber = false;
        const double value = locale.toDouble(number, &isNumber);
        return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
    };
    if (const auto value = read(QLocale())) {
        return value;
    }
    return isGrouped(number) ? std::nullopt : read(QLocale::c());
}

bool areSameOnBoard(double one, double other) {
    return std::abs(one - other) <= std::ldexp(std::max(std::abs(one), std::abs(other)), -23);
}

} // namespace halbench::widgets
