#include "app/documents/text/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace halbench::app {

namespace {

tl::unexpected<Error> cannotWrite(const std::string& path, int cause) {
    return failure(ErrorCode::FileSystem, fmt::format("{}: cannot write: {}", path, std::strerror(cause)),
                   cause == ENOSPC ? "free space on the disk"
                                   : "choose another path or change its permissions");
}

/// Writes everything or says why not.
Result<void> writeAll(int file, const std::string& path, std::string_view content) {
    while (!content.empty()) {
        const ssize_t count = ::write(file, content.data(), content.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            return cannotWrite(path, count < 0 ? errno : ENOSPC);
        }
        content.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
}

bool isSpecialFile(const std::string& path) {
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

Result<void> writeOpened(const std::string& openedPath, const std::string& path, std::string_view content) {
    const int file = ::open(openedPath.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) {
        return cannotWrite(path, errno);
    }
    Result<void> written = writeAll(file, path, content);
    if (written && ::fsync(file) != 0 && errno != EINVAL && errno != EROFS) {
        written = cannotWrite(path, errno);
    }
    if (::close(file) != 0 && written) {
        written = cannotWrite(path, errno);
    }
    return written;
}

} // namespace

Result<void> createFolderOf(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    std::error_code cause;
    if (!folder.empty() && !std::filesystem::is_directory(folder, cause)) {
        std::filesystem::create_directories(folder, cause);
        if (cause) {
            return cannotWrite(folder, cause.value());
        }
    }
    return {};
}

Result<void> createFolder(const std::string& folder) {
    const Result<void> created = createFolderOf((std::filesystem::path(folder) / "x").string());
    if (!created) {
        return created;
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        return cannotWrite(folder, errno);
    }
    return {};
}

Result<void> writeFile(const std::string& path, std::string_view content) {
    if (const Result<void> created = createFolderOf(path); !created) {
        return created;
    }
    if (isSpecialFile(path)) { // a device or pipe has no final name to protect
        return writeOpened(path, path, content);
    }
    const std::string partial = path + ".partial";
    if (const Result<void> written = writeOpened(partial, path, content); !written) {
        ::unlink(partial.c_str());
        return written;
    }
    if (::rename(partial.c_str(), path.c_str()) != 0) {
        const int cause = errno;
        ::unlink(partial.c_str());
        return cannotWrite(path, cause);
    }
    return {};
}

Result<std::string> readFile(const std::string& path) {
    constexpr std::uintmax_t Largest = 256u << 20;
    std::error_code cause;
    if (std::filesystem::is_directory(path, cause)) {
        return failure(ErrorCode::FileSystem, path + ": is a folder", "name a file");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return failure(ErrorCode::FileSystem, fmt::format("{}: cannot read: {}", path, std::strerror(errno)),
                       "check the path");
    }
    if (std::filesystem::file_size(path, cause) > Largest && !cause) {
        return failure(ErrorCode::InvalidInput, path + ": larger than 256 MB", "give a smaller file");
    }
    std::ostringstream content;
    content << file.rdbuf();
    return std::move(content).str();
}

} // namespace halbench::app
