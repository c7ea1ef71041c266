#include "devices/recording/file_access.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace halbench::devices {

std::string causeOf(const QFileDevice& file) {
    const int cause = errno;
    return file.errorString() == QLatin1String("Unknown error") ? std::strerror(cause)
                                                                : file.errorString().toStdString();
}

tl::unexpected<Error> cannotWrite(const std::string& path, const QFileDevice& file) {
    return failure(ErrorCode::FileSystem, fmt::format("cannot write '{}': {}", path, causeOf(file)),
                   "check that the folder can be written and the disk has room");
}

FileHold::FileHold(const std::string& path) : m_file(std::make_unique<QFile>(QString::fromStdString(path))) {
    if (m_file->open(QIODevice::ReadOnly)) {
        (void)::flock(m_file->handle(), LOCK_SH | LOCK_NB);
    }
}

FileHold::~FileHold() = default;

bool isHeld(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) && ::flock(file.handle(), LOCK_EX | LOCK_NB) != 0 &&
           errno == EWOULDBLOCK;
}

Result<void> createFolderOf(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    if (!QDir().mkpath(info.path())) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot create the folder '{}'", info.path().toStdString()),
                       "give a folder that can be written");
    }
    if (info.isDir()) {
        return failure(ErrorCode::FileSystem, fmt::format("'{}' is a folder", path),
                       "give the name of a file");
    }
    if (info.exists() && !info.isFile()) { // /dev/null would become a file
        return failure(ErrorCode::FileSystem, fmt::format("'{}' is a device or pipe", path),
                       "give the name of a file");
    }
    return {};
}

Result<void> moveInto(const std::string& from, const std::string& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("cannot rename '{}' to '{}': {}", from, to, std::strerror(errno)),
                       "check that the folder can be written");
    }
    return {};
}

} // namespace halbench::devices
