#pragma once

#include "app/recordings/recording_name.h"

#include <QtCore/QLockFile>

#include <functional>
#include <memory>

namespace halbench::app {

/// The first name of those that a mask gives one after the other for which `isFree` says so. Errors: those of
/// recordingName().
Result<QString> firstRecordingName(const QString& mask, const NameParts& parts, const QString& folder,
                                   const std::function<bool(const QString&)>& isFree);

/// A name that no other recorder gets as long as this lives: until the recording's own file has it. What a
/// killed program left of one counts for nothing.
struct ReservedName {
    QString name;
    std::unique_ptr<QLockFile> hold;
};

/// recordingName(), found and taken in one step: several programs may do so at once. The folder is made. A
/// folder that takes no file reserves nothing; what writes there says why. Errors: of recordingName();
/// FileSystem (no folder).
Result<ReservedName> reserveRecordingName(const QString& mask, const NameParts& parts, const QString& folder);

} // namespace halbench::app
