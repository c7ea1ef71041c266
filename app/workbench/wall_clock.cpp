#include "app/workbench/wall_clock.h"

#include "widgets/language/local_time.h"

#include <QRegularExpression>

namespace halbench::app {

QDateTime wallClock() {
    return QDateTime::currentDateTimeUtc();
}

QString localDate(const std::string& started) {
    const QString text = QString::fromStdString(started);
    const QDateTime date = QDateTime::fromString(text, Qt::ISODate);
    return date.isValid() ? widgets::localTimeText(date) : text;
}

QString datedName(const QString& subject, const QDateTime& date) {
    QString name = subject.isEmpty() ? QStringLiteral("recording") : subject;
    name.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9._-]+")), QStringLiteral("-"));
    return name + QLatin1Char('_') + date.toString(QStringLiteral("yyyy-MM-ddTHH-mm-ss"));
}

} // namespace halbench::app
