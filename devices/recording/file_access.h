#pragma once

#include "control/base/result.h"

#include <QtCore/QFileDevice>

#include <memory>
#include <string>

namespace halbench::devices {

// Words and steps that every reader and writer of a recording needs.

/// Why the last operation on this file failed. Qt has no words for some failures (a flush); the system has.
/// Call it directly after the failure.
std::string causeOf(const QFileDevice& file);

/// FileSystem, with path, cause and remedy.
tl::unexpected<Error> cannotWrite(const std::string& path, const QFileDevice& file);

/// Somebody looks at a file: as long as this lives no Halbench tidies it away. Where the disk knows no locks,
/// or there is no such file, it does nothing.
class FileHold {
public:
    explicit FileHold(const std::string& path);
    ~FileHold();

private:
    std::unique_ptr<QFileDevice> m_file;
};
/// Whether a file is held or written, here or by another program.
bool isHeld(const std::string& path);

/// Makes the folder in which `path` will be written. Errors: FileSystem, also when `path` is a folder, a
/// device or a pipe.
Result<void> createFolderOf(const std::string& path);

/// Gives a file another name; what had it is replaced in one step. Errors: FileSystem.
Result<void> moveInto(const std::string& from, const std::string& to);

} // namespace halbench::devices
