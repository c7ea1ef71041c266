#pragma once

#include "control/base/result.h"
#include "devices/recording/recording_meta.h"

#include <QtCore/QJsonObject>
#include <QtCore/QString>

#include <functional>
#include <vector>

namespace halbench::app {

/// What the user changes in a recording's sidecar: its other fields stay as they are, also those of a later
/// version. One at a time, by whatever thread or program. `hint`: what helps without a sidecar. Errors:
/// FileSystem, InvalidInput (the sidecar is damaged).
Result<void> changeSidecar(const QString& path, const char* hint,
                           const std::function<void(QJsonObject&)>& change);

/// Markers of a recording instead of those before; times on its own axis. Errors: as above.
Result<void> writeRecordingMarkers(const QString& path,
                                   const std::vector<devices::RecordingMeta::Marker>& markers);

/// Those of a recording as its sidecar has them. Errors: FileSystem, InvalidInput.
Result<std::vector<devices::RecordingMeta::Marker>> recordingMarkers(const QString& path);

} // namespace halbench::app
