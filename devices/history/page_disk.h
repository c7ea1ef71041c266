#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace halbench::devices {

/// What a page file asks of the disk; a test gives one that fails. On failure `errno` says why.
struct PageDisk {
    /// A new file in the folder that has no name and is gone when it is closed; -1 when there is none.
    std::function<int(const std::string& folder)> open;
    std::function<void(int handle)> close;
    std::function<bool(int handle, std::span<const std::byte> octets, std::uint64_t offset)> write;
    std::function<bool(int handle, std::span<std::byte> octets, std::uint64_t offset)> read;
    std::function<std::optional<std::uint64_t>(const std::string& folder)> free_bytes;
};

/// The disk as it is.
PageDisk realPageDisk();

} // namespace halbench::devices
