#pragma once

#include "control/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// Creates the folder that `path` lies in. Error: FileSystem.
Result<void> createFolderOf(const std::string& path);

/// Creates a folder and makes sure that files can be written into it. Error: FileSystem.
Result<void> createFolder(const std::string& folder);

/// Writes a whole file as `path.partial`, flushes it to the disk and renames it; when anything fails the
/// partial file is removed and the old `path` stays as it was. Folders are created. Error: FileSystem.
Result<void> writeFile(const std::string& path, std::string_view content);

/// Reads a whole file of at most 256 MB. Error: FileSystem.
Result<std::string> readFile(const std::string& path);

} // namespace halbench::app
