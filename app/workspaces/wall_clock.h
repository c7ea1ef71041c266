#pragma once

#include <QDateTime>
#include <QString>

namespace halbench::app {

/// The date on the wall, in UTC: for names of files and the `started` of a recording made by hand; results
/// never depend on it.
QDateTime wallClock();

/// "sim-htm-1_2026-11-21T21-15-42": sorts by time and is legal on every file system.
QString datedName(const QString& subject, const QDateTime& date);

} // namespace halbench::app
