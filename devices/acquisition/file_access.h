#pragma once

#include "control/base/result.h"

#include <QtCore/QFileDevice>

#include <string>

namespace halbench::devices {

// Words and steps that every reader and writer of a recording needs.

/// Why the last operation on this file failed. Qt has no words for some failures (a flush); the system has.
/// Call it directly after the failure.
std::string causeOf(const QFileDevice& file);

/// FileSystem, with path, cause and remedy.
tl::unexpected<Error> cannotWrite(const std::string& path, const QFileDevice& file);

/// Makes the folder in which `path` will be written. Errors: FileSystem, also when `path` is a folder.
Result<void> createFolderOf(const std::string& path);

/// Gives a file another name; what had it is replaced in one step. Errors: FileSystem.
Result<void> moveInto(const std::string& from, const std::string& to);

} // namespace halbench::devices
