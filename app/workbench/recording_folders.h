#pragma once

#include <QStringList>

namespace halbench::app {

/// Where recordings go as long as nobody chose another folder.
QString defaultRecordingFolder();

/// Interrupted recordings of a folder, which can be recovered. For a thread of its own.
QStringList interruptedIn(const QString& folder);

} // namespace halbench::app
