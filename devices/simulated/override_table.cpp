#include "devices/simulated/override_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace halbench::devices {

std::vector<OverrideSpec> commonOverrideSpecs() {
    OverrideSpec seed{
        "seed", "", 0.0, 18446744073709551615.0, 1.0, "noise and drawn errors of this specimen"};
    OverrideSpec imperfections;
    imperfections.key = "imperfections";
    imperfections.choices = {"on", "off"};
    imperfections.meaning = "noise, sensor errors and spread";
    OverrideSpec chain;
    chain.key = "chain";
    chain.choices = {"full", "ideal"};
    chain.meaning = "converters and amplifiers, or exact values";
    return {seed, imperfections, chain};
}

Result<double> parseOverride(const std::string& key, const std::string& text, const std::string& keys) {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status == std::errc::result_out_of_range && stop == end) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}={} is out of range", key, text), keys);
    }
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}={} is not a number", key, text),
                       "Write numbers like 2e-3. " + keys);
    }
    return value;
}

Result<double> parseOverrideWord(const std::string& key, const std::string& text,
                                 const std::vector<std::string>& words) {
    const std::string hint = fmt::format("Allowed: {}.", fmt::join(words, ", "));
    const auto word = std::find(words.begin(), words.end(), text);
    if (word != words.end()) {
        return static_cast<double>(word - words.begin());
    }
    const Result<double> index = parseOverride(key, text, hint);
    if (!index) {
        return failure(index.error().code, fmt::format("{}={} is unknown", key, text), hint);
    }
    const bool isIndex =
        *index == std::floor(*index) && *index >= 0.0 && *index < static_cast<double>(words.size());
    if (!isIndex) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}={} is unknown", key, text), hint);
    }
    return index;
}

Result<bool> parseOverrideChoice(const Overrides& overrides, const std::string& key, const char* usual,
                                 const char* other, const std::string& keys) {
    const auto given =
        std::find_if(overrides.begin(), overrides.end(), [&](const auto& row) { return row.first == key; });
    if (given == overrides.end() || given->second == usual) {
        return false;
    }
    if (given->second == other) {
        return true;
    }
    return failure(ErrorCode::InvalidInput, fmt::format("{}={} is unknown", key, given->second),
                   fmt::format("Allowed: {}={} and {}={}. {}", key, usual, key, other, keys));
}

} // namespace halbench::devices
