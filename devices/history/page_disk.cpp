#include "devices/history/page_disk.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace halbench::devices {

namespace {

/// A program that is killed leaves nothing behind: the name goes before the first octet comes.
int openNameless(const std::string& folder) {
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);
    if (problem) {
        errno = problem.value();
        return -1;
    }
    std::string name = folder + "/history-XXXXXX";
    const int handle = ::mkostemp(name.data(), O_CLOEXEC);
    if (handle >= 0) {
        ::unlink(name.c_str());
    }
    return handle;
}

/// All of it, also when the system does it in pieces or is interrupted.
template <typename Octets, typename Step>
bool inSteps(Octets octets, std::uint64_t offset, const Step& step) {
    while (!octets.empty()) {
        const ssize_t done = step(octets.data(), octets.size(), static_cast<off_t>(offset));
        if (done == 0) {
            errno = EIO; // the file is shorter than it was
            return false;
        }
        if (done < 0) {
            if (errno == EINTR) {
                continue;
            }
            return false;
        }
        octets = octets.subspan(static_cast<std::size_t>(done));
        offset += static_cast<std::uint64_t>(done);
    }
    return true;
}

} // namespace

PageDisk realPageDisk() {
    PageDisk disk;
    disk.open = openNameless;
    disk.close = [](int handle) { ::close(handle); };
    disk.write = [](int handle, std::span<const std::byte> octets, std::uint64_t offset) {
        return inSteps(octets, offset, [handle](const std::byte* from, std::size_t size, off_t place) {
            return ::pwrite(handle, from, size, place);
        });
    };
    disk.read = [](int handle, std::span<std::byte> octets, std::uint64_t offset) {
        return inSteps(octets, offset, [handle](std::byte* into, std::size_t size, off_t place) {
            return ::pread(handle, into, size, place);
        });
    };
    disk.free_bytes = [](const std::string& folder) -> std::optional<std::uint64_t> {
        struct statvfs state {};
        if (::statvfs(folder.c_str(), &state) != 0) {
            return std::nullopt;
        }
        return static_cast<std::uint64_t>(state.f_bavail) * state.f_frsize;
    };
    return disk;
}

} // namespace halbench::devices
