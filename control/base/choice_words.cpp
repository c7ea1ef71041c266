#include "control/base/choice_words.h"

#include <algorithm>

namespace halbench {

std::vector<std::string> choiceWords(std::string_view text) {
    std::vector<std::string> words;
    if (text.empty()) {
        return words;
    }
    for (auto end = text.find('|'); end != std::string_view::npos; end = text.find('|')) {
        words.emplace_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    words.emplace_back(text);
    return words;
}

double lastChoice(std::string_view text) {
    return static_cast<double>(std::count(text.begin(), text.end(), '|'));
}

} // namespace halbench
