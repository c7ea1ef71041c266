#include "app/window/docks/kept_arrangement.h"

#include <QXmlStreamReader>

namespace halbench::app {

std::optional<ArrangementFault> faultOf(const QByteArray& arrangement, int version) {
    QXmlStreamReader reader(arrangement);
    const bool isOurs =
        reader.readNextStartElement() && reader.name() == QLatin1String("QtAdvancedDockingSystem");
    bool isNumber = false;
    const int found = reader.attributes().value(QLatin1String("UserVersion")).toInt(&isNumber);
    while (!reader.atEnd()) {
        reader.readNext(); // the docking library would show what comes before the damage
    }
    if (!isOurs || !isNumber || reader.hasError()) {
        return ArrangementFault::Damaged;
    }
    if (found == version) {
        return std::nullopt;
    }
    return found > version ? ArrangementFault::Newer : ArrangementFault::Older;
}

QString unreadName(const QHash<QString, QByteArray>& arrangements, const QString& perspective) {
    QString name = perspective + QStringLiteral(".unread");
    for (int number = 2; arrangements.contains(name); ++number) {
        name = QStringLiteral("%1.unread-%2").arg(perspective).arg(number);
    }
    return name;
}

} // namespace halbench::app
