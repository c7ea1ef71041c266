#pragma once

#include <QtCore/QFile>

#include <functional>
#include <string_view>

namespace halbench::devices {

/// What a writer asks of the disk; a test gives a slow or a failing one. On failure `errno` says why.
struct DiskAccess {
    std::function<bool(QFile& file, std::string_view octets)> write; ///< all of it, to the system
    std::function<bool(int handle)> sync;                            ///< from there to the disk
};

/// The disk as it is.
DiskAccess realDisk();

} // namespace halbench::devices
