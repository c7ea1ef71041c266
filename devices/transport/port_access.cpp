#include "devices/transport/port_access.h"

#include <fmt/format.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace halbench::devices {

namespace {

namespace fs = std::filesystem;

/// "process 1234" with its name; from /proc, which tells other users' processes to root only.
std::string processName(const fs::path& process) {
    std::ifstream file(process / "comm");
    std::string name;
    std::getline(file, name);
    return fmt::format("{} (process {})", name.empty() ? "a program" : name, process.filename().string());
}

/// The number of a character device; nothing for any other path.
std::optional<dev_t> deviceNumber(const std::string& path) {
    struct stat status {};
    const bool isDevice = ::stat(path.c_str(), &status) == 0 && S_ISCHR(status.st_mode);
    return isDevice ? std::optional(status.st_rdev) : std::nullopt;
}

bool holds(const fs::path& process, dev_t device) {
    std::error_code error;
    for (fs::directory_iterator entry(process / "fd", error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unreadable;
        const bool isNode = fs::read_symlink(entry->path(), unreadable).string().rfind("/dev/", 0) == 0;
        if (isNode && deviceNumber(entry->path().string()) == device) {
            return true;
        }
    }
    return false;
}

std::string groupOf(const struct stat& status) {
    std::array<char, 1024> storage{};
    group entry{};
    group* found = nullptr;
    const bool isKnown = ::getgrgid_r(status.st_gid, &entry, storage.data(), storage.size(), &found) == 0;
    return isKnown && found != nullptr ? entry.gr_name : std::string();
}

} // namespace

std::optional<std::string> holderOf(const std::string& node) {
    const std::optional<dev_t> device = deviceNumber(node); // links and several nodes lead to the same one
    if (!device) {
        return std::nullopt;
    }
    std::error_code error;
    const std::string own = std::to_string(::getpid());
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
        const std::string number = entry->path().filename().string();
        const bool isProcess = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
        if (isProcess && holds(entry->path(), *device)) {
            return number == own ? "this program" : processName(entry->path());
        }
    }
    return std::nullopt;
}

bool isUdevRunning() {
    return ::access("/run/udev/control", F_OK) == 0;
}

PortTrouble permissionTrouble(const std::string& node, bool hasUdev) {
    struct stat status {};
    const bool isKnown = ::stat(node.c_str(), &status) == 0;
    const std::string group = isKnown && (status.st_mode & S_IRGRP) != 0 ? groupOf(status) : std::string();
    std::string hint =
        hasUdev
            ? "install the rules printed by 'halbench devices --udev-rules', then plug the device in again"
            : fmt::format(
                  "no udev runs here, so that rules have no effect: allow it with 'sudo chmod a+rw {}' "
                  "each time it was plugged in",
                  node);
    if (!group.empty() && group != "root") {
        hint += fmt::format(", or join the group with 'sudo usermod -aG {} $USER' and log in again", group);
    }
    return {fmt::format("no permission to use {}", node), hint};
}

PortTrouble busyTrouble(const std::string& node) {
    const std::optional<std::string> holder = holderOf(node);
    return {fmt::format("{} is in use by {}", node, holder.value_or("another program")),
            holder == "this program"
                ? "disconnect there first"
                : "close that program (ModemManager releases a new port after some seconds)"};
}

std::optional<PortTrouble> troubleOf(const std::string& node) {
    if (::access(node.c_str(), F_OK) != 0) {
        return PortTrouble{fmt::format("{} not found", node),
                           "plug the device in; 'halbench devices' lists the addresses"};
    }
    if (::access(node.c_str(), R_OK | W_OK) != 0) {
        return permissionTrouble(node);
    }
    return std::nullopt;
}

Error portError(const std::string& description, const PortTrouble& trouble) {
    return {ErrorCode::DeviceLost, fmt::format("{}: {}", description, trouble.reason), trouble.hint};
}

} // namespace halbench::devices
