#include "widgets/language/unbroken.h"

#include <QRegularExpression>

namespace halbench::widgets {

QString unbroken(QString text) {
    constexpr QChar NoBreakSpace(0x00a0);
    constexpr QChar WordJoiner(0x2060); // no width; no break on its side
    text.replace(QLatin1Char(' '), NoBreakSpace);
    return text.replace(QLatin1Char('/'), WordJoiner + QStringLiteral("/") + WordJoiner);
}

QString withUnitsKept(QString sentence) {
    static const QRegularExpression between(
        QStringLiteral("(?<=\\d) (?=(?:\u00b0C|A|s|ms|Hz|V|%|rad/s|r/min|1/min)(?!\\w))"),
        QRegularExpression::UseUnicodePropertiesOption);
    return sentence.replace(between, QStringLiteral("\u00a0"));
}

} // namespace halbench::widgets
