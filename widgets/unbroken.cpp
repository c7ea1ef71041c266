#include "widgets/unbroken.h"

namespace halbench::widgets {

QString unbroken(QString text) {
    constexpr QChar NoBreakSpace(0x00a0);
    constexpr QChar WordJoiner(0x2060); // no width; no break on its side
    text.replace(QLatin1Char(' '), NoBreakSpace);
    return text.replace(QLatin1Char('/'), WordJoiner + QStringLiteral("/") + WordJoiner);
}

} // namespace halbench::widgets
