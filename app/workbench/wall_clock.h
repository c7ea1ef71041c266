#pragma once

#include <QDateTime>
#include <QString>

#include <functional>
#include <string>

namespace halbench::app {

/// Tells the date on the wall; a test sets its own.
using WallClock = std::function<QDateTime()>;

/// The date on the wall, in UTC: for names of files and the `started` of results and recordings; their
/// numbers never depend on it.
QDateTime wallClock();

/// The `started` of a result as its reader's clock had it, "2026-11-26 23:14:05"; as it is when it is no
/// date.
QString localDate(const std::string& started);

/// "sim-htm-1_2026-11-21T21-15-42": sorts by time and is legal on every file system.
QString datedName(const QString& subject, const QDateTime& date);

} // namespace halbench::app
