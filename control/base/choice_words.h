#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halbench {

/// The words of a choice that stand in one text, separated by '|'; none in an empty one.
std::vector<std::string> choiceWords(std::string_view text);

/// The index of the last word.
double lastChoice(std::string_view text);

} // namespace halbench
