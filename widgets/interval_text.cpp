#include "widgets/interval_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int LeastPlainExponent = -2; ///< 0.01 ... 99999 are written out, others with an exponent
constexpr int MostPlainExponent = 4;

/// The power of ten of the last digit that an uncertainty of this size leaves.
int lastPlace(double halfWidth) {
    const int exponent = static_cast<int>(std::floor(std::log10(halfWidth)));
    const double leading = halfWidth / std::pow(10.0, exponent); // 1 ... 10
    if (leading < 3.55) {
        return exponent - 1;
    }
    return exponent; // 9.5 ... 10 round up to 10, two digits
}

struct Notation {
    int exponent = 0; ///< of the written power of ten; 0: none
    int place = 0;    ///< power of ten of the last digit that means something
};

QString number(double value, const Notation& notation) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double unit = std::pow(10.0, notation.place);
    const double rounded = std::round(value / unit) * unit + 0.0; // + 0: no minus before a zero
    const int decimals = std::clamp(notation.exponent - notation.place, 0, 15);
    const QString text = locale.toString(rounded / std::pow(10.0, notation.exponent), 'f', decimals);
    return notation.exponent == 0 ? text : text + QLatin1Char('e') + QString::number(notation.exponent);
}

Notation notationFor(double largest, int place) {
    const int exponent = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) : place;
    const bool isPlain = exponent >= LeastPlainExponent && exponent <= MostPlainExponent;
    return {isPlain ? 0 : exponent, place};
}

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::IntervalText)
};

} // namespace

QString intervalText(const IntervalWords& words) {
    if (!words.interval || !std::isfinite(words.value) || !std::isfinite(words.interval->first) ||
        !std::isfinite(words.interval->second)) {
        return Words::tr("not identified");
    }
    const double below = words.value - words.interval->first;
    const double above = words.interval->second - words.value;
    const double halfWidth = 0.5 * (below + above);
    const double largest =
        std::max({std::abs(words.value), std::abs(words.interval->first), std::abs(words.interval->second)});
    const int place = halfWidth > 0.0
                          ? lastPlace(halfWidth)
                          : static_cast<int>(std::floor(std::log10(std::max(largest, 1e-300)))) - 6;
    const Notation notation = notationFor(std::max(std::abs(words.value), halfWidth), place);
    const bool isLopsided = std::abs(above - below) > 0.2 * halfWidth;
    const QString unit = words.unit.isEmpty() ? QString() : QChar(QChar::Nbsp) + words.unit;
    const QString value = number(words.value, notation);
    const QString numbers = isLopsided ? Words::tr("%1 (%2 to %3)")
                                             .arg(value, number(words.interval->first, notation),
                                                  number(words.interval->second, notation))
                                       : QStringLiteral("%1 ± %2").arg(value, number(halfWidth, notation));
    return Words::tr("%1%2 (%3 %)").arg(numbers, unit).arg(words.level_percent);
}

} // namespace halbench::widgets
