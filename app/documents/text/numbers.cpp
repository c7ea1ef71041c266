#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace halbench::app {

std::string formatNumber(double value) {
    if (value == 0.0) {
        return "0";
    }
    std::array<char, 32> digits{};
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return std::string(digits.data(), end.ptr);
}

std::optional<double> parseNumber(std::string_view text) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
    std::int64_t value = 0;
    const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

Result<double> numberOption(const std::string& option, std::string_view text) {
    const std::optional<double> value = parseNumber(text);
    if (!value) {
        return failure(ErrorCode::Usage, fmt::format("{}: '{}' is not a number", option, text),
                       "write it like 0.5 or 2e-3, with a point");
    }
    if (!std::isfinite(*value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{}: '{}' is not a finite number", option, text),
                       "give a finite number");
    }
    return *value;
}

Result<std::optional<double>> optionalNumber(const std::string& option, std::string_view text) {
    if (text.empty()) {
        return std::optional<double>{};
    }
    const Result<double> value = numberOption(option, text);
    return value ? Result<std::optional<double>>(*value) : failure(value.error());
}

} // namespace halbench::app
