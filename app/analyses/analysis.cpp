#include "app/analyses/analysis.h"

#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

Result<double> numberOf(const AnalysisKey& key, const std::string& text) {
    const Result<double> number = numberOption(optionOf(key), text);
    if (!number) {
        return number;
    }
    const bool isWhole = key.type != AnalysisKeyType::Integer || *number == std::round(*number);
    if (*number < key.min || *number > key.max || !isWhole) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is out of range", optionOf(key), text),
                       fmt::format("allowed: {} to {}{}", formatNumber(key.min), formatNumber(key.max),
                                   key.type == AnalysisKeyType::Integer ? ", whole numbers" : ""));
    }
    return number;
}

} // namespace

std::optional<double> AnalysisValues::number(std::string_view key) const {
    const auto found = numbers.find(key);
    return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
}

std::string AnalysisValues::text(std::string_view key) const {
    const auto found = texts.find(key);
    return found == texts.end() ? std::string() : found->second;
}

bool AnalysisValues::isSet(std::string_view key) const {
    const auto found = flags.find(key);
    return found != flags.end() && found->second;
}

std::string analysisCsv(const AnalysisTable& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (std::size_t i = 0; i < table.values.size(); ++i) {
        if (std::isfinite(table.values[i])) {
            text += formatNumber(table.values[i]);
        }
        text += (i + 1) % table.columns.size() == 0 ? '\n' : ',';
    }
    return text;
}

std::string optionOf(const AnalysisKey& key) {
    std::string name(key.name);
    std::replace(name.begin(), name.end(), '_', '-');
    return "--" + name;
}

Result<AnalysisValues> parseAnalysisValues(const Analysis& analysis,
                                           const std::map<std::string, std::string>& texts,
                                           const std::map<std::string, bool>& flags) {
    AnalysisValues values;
    for (const AnalysisKey& key : analysis.keys) {
        const std::string name(key.name);
        if (key.type == AnalysisKeyType::Flag) {
            const auto flag = flags.find(name);
            values.flags[name] = flag != flags.end() && flag->second;
            continue;
        }
        const auto given = texts.find(name);
        if (given == texts.end() || given->second.empty()) {
            continue;
        }
        if (key.type == AnalysisKeyType::Number || key.type == AnalysisKeyType::Integer) {
            const Result<double> number = numberOf(key, given->second);
            if (!number) {
                return failure(number.error());
            }
            values.numbers[name] = *number;
            continue;
        }
        const std::vector<std::string> choices = splitList(key.choices, '|');
        if (key.type == AnalysisKeyType::Choice &&
            std::find(choices.begin(), choices.end(), given->second) == choices.end()) {
            return failure(ErrorCode::Usage,
                           fmt::format("{}: '{}' is not known", optionOf(key), given->second),
                           fmt::format("use one of {}", fmt::join(choices, ", ")));
        }
        values.texts[name] = given->second;
    }
    return values;
}

} // namespace halbench::app
