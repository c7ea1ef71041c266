#pragma once

#include <cstddef>
#include <string_view>

namespace halbench::app {

/// Where something stands in a text file, counted from 1; line 0 = nowhere in a file.
struct TextPlace {
    int line = 0;
    int column = 0;
};

inline TextPlace placeOfOffset(std::string_view text, std::size_t offset) {
    TextPlace place{1, 1};
    for (std::size_t index = 0; index < offset && index < text.size(); ++index) {
        if (text[index] == '\n') {
            ++place.line;
            place.column = 1;
        } else {
            ++place.column;
        }
    }
    return place;
}

} // namespace halbench::app
