#include "widgets/language/number_text.h"

#include "widgets/language/display_units.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QToolTip>
#include <QWidget>

#include <algorithm>

namespace halbench::widgets {

namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::NumberWords)
};

/// Without the unit behind it, or the part of the unit that is typed so far.
QString withoutUnit(const QString& text, const QString& unitText) {
    QString number = text.trimmed();
    const QString spelled = QString(unitText).replace(QChar(0x00b0), QStringLiteral("deg"));
    for (const QString& unit : {unitText, spelled}) {
        for (int length = unit.size(); length > 0; --length) {
            if (number.endsWith(unit.left(length))) {
                return number.left(number.size() - length).trimmed();
            }
        }
    }
    return number;
}

/// The first that no number of any notation has; null: none.
QChar foreignLetter(const QString& number) {
    const auto isForeign = [](QChar letter) {
        return !letter.isDigit() && !letter.isSpace() && !QStringLiteral("+-\u2212.,'eE").contains(letter);
    };
    const auto* found = std::find_if(number.begin(), number.end(), isForeign);
    return found == number.end() ? QChar() : *found;
}

/// The sign in it that the user's notation does not have between whole part and decimals; null: none.
QChar foreignSeparator(const QString& number) {
    const QChar point = QLocale().decimalPoint();
    const auto* found = std::find_if(number.begin(), number.end(), [point](QChar letter) {
        return letter != point && QStringLiteral(".,'").contains(letter);
    });
    return found == number.end() ? QChar() : *found;
}

bool isBegun(const QString& number) {
    static const QRegularExpression Begun(QStringLiteral("^[+\u2212-]?\\d*[.,]?\\d*([eE][+\u2212-]?\\d*)?$"));
    return Begun.match(number).hasMatch();
}

} // namespace

QString numberProblem(const QString& text, const QString& unitText) {
    if (parseNumber(text, unitText)) {
        return {};
    }
    const QString number = withoutUnit(text, unitText);
    const QChar point = QLocale().decimalPoint();
    if (const QChar letter = foreignLetter(number); !letter.isNull()) {
        return Words::tr("'%1' is not allowed in a number. Use digits, a sign, '%2' before the decimals and "
                         "e for a power of ten.")
            .arg(letter)
            .arg(point);
    }
    if (const QChar sign = foreignSeparator(number); !sign.isNull()) {
        return Words::tr("'%1' is ambiguous. Use '%2' before the decimals and no thousands separators.")
            .arg(sign)
            .arg(point);
    }
    return Words::tr("This is not a number.");
}

QString typingProblem(const QString& text, const QString& unitText) {
    const QString number = withoutUnit(text, unitText);
    const bool hasForeign = !foreignLetter(number).isNull() || !foreignSeparator(number).isNull();
    return isBegun(number) && !hasForeign ? QString() : numberProblem(text, unitText);
}

QString bubbleOf(const QString& words) {
    return QStringLiteral("<qt>%1</qt>").arg(words.toHtmlEscaped());
}

void sayAt(QWidget& field, const QString& words) {
    if (!words.isEmpty() && field.isVisible()) {
        const QPoint below = field.mapToGlobal(QPoint(0, field.height()));
        QToolTip::showText(below, bubbleOf(words), &field, field.rect());
    } else if (QToolTip::isVisible()) {
        QToolTip::hideText();
    }
}

} // namespace halbench::widgets
