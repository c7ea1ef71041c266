#pragma once

#include "app/documents/text/json_value.h"

#include <optional>
#include <string>
#include <string_view>

namespace halbench::app {

/// In which unit the program takes a value of a document ("kp", "inertia", "stray.coefficient") or a
/// parameter
/// ("gain.kp"); nothing for what is only shown.
std::optional<std::string_view> dueUnit(std::string_view key);

/// `value` of `key` in its due unit. Error: InvalidInput naming `place` where `unit` is another dimension or
/// not known.
Result<double> inDueUnit(std::string_view key, double value, const std::string& unit,
                         const std::string& place);

/// parseJson(), with every value that states a unit in the unit that the program takes it in: its `value`,
/// `ci95` and `unit`. Errors: of parseJson(); InvalidInput naming the key, of a unit of another dimension or
/// one that is not known; of checkLimits().
Result<JsonValue> parseDocument(const std::string& text, const std::string& origin);

/// Fault of the interval of {"value", "ci95"} in words: no two finite numbers, the ends not in order, the
/// value outside. Nothing where it is sound or null.
std::optional<std::string> intervalProblem(const JsonValue& quantity);

} // namespace halbench::app
