#pragma once

#include <cstdint>
#include <string>

namespace halbench {

/// The sentence for one thing, or the other with its {} replaced by how many there are. Two whole sentences,
/// because more than the noun changes, and because each is a phrase to translate.
inline std::string counted(std::uint64_t count, const std::string& one, const std::string& several) {
    if (count == 1) {
        return one;
    }
    const std::string number = std::to_string(count);
    const std::size_t place = several.find("{}");
    return place == std::string::npos ? several : std::string(several).replace(place, 2, number);
}

} // namespace halbench
