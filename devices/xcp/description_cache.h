#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <optional>
#include <string>

namespace halbench::devices::xcp {

/// What makes two descriptions the same one (resources/help/protocol.md 3.7).
struct DescriptionKey {
    std::string name; ///< GET_ID 1
    std::string epk;  ///< GET_ID 5: changes with every change of the board's tables
    std::size_t octets = 0;
};

/// Descriptions of boards met before, one file each. A file that is damaged, cut short or of another key is
/// as good as none. A board without name or EPK is not kept: nothing would tell when it changes.
class DescriptionCache {
public:
    /// An empty folder keeps nothing. It is created when it is first needed.
    explicit DescriptionCache(std::string folder) : m_folder(std::move(folder)) {}

    std::optional<std::string> find(const DescriptionKey& key) const;
    /// The EPK under which a board of this name was kept last, when it was another: its firmware changed.
    std::optional<std::string> epkBefore(const DescriptionKey& key) const;
    /// Written beside and renamed, so that no reader meets half a file. False when nothing was to be kept.
    /// Errors: FileSystem.
    Result<bool> store(const DescriptionKey& key, const std::string& text) const;

private:
    std::string pathOf(const DescriptionKey& key) const;

    std::string m_folder;
};

} // namespace halbench::devices::xcp
