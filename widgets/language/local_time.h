#pragma once

#include <QDateTime>
#include <QString>

namespace halbench::widgets {

/// "2026-11-26 23:14:05": the moment on the reader's clock, with seconds, in any language.
QString localTimeText(const QDateTime& moment);

} // namespace halbench::widgets
