#pragma once

#include "control/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace halbench::app {

/// The shortest decimal text that reads back as the same number, whatever the locale: "0.1", "1e-05", "4".
/// Minus zero is written as 0.
std::string formatNumber(double value);

/// Reads a whole text as one number in the C locale; also "nan" and "inf", so that whoever judges the value
/// can say so. Nothing for anything else.
std::optional<double> parseNumber(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

/// A number given on the command line. Errors: Usage naming the option; NotFinite.
Result<double> numberOption(const std::string& option, std::string_view text);
/// The same of an option that was not given when `text` is empty.
Result<std::optional<double>> optionalNumber(const std::string& option, std::string_view text);

} // namespace halbench::app
