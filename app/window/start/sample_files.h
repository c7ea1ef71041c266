#pragma once

#include "control/base/result.h"

#include <QByteArray>
#include <QString>

namespace halbench::app {

/// Copies of the sample recordings, which are opened so that nothing changes the ones of the program.
QString sampleFolder();

/// One file of a sample recording, "motor-step.csv" or "motor-step.meta.json". Errors: FileSystem.
Result<QByteArray> sampleContent(const QString& name);

/// Copies a sample recording and its sidecar into the folder, read-only, over an earlier or changed copy.
/// Answers with the path of the recording. For a thread of its own. Errors: FileSystem.
Result<QString> copySample(const QString& file, const QString& folder);

} // namespace halbench::app
