#include "widgets/language/local_time.h"

namespace halbench::widgets {

QString localTimeText(const QDateTime& moment) {
    return moment.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

} // namespace halbench::widgets
