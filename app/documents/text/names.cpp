#include "app/documents/text/names.h"

#include <algorithm>
#include <numeric>

namespace halbench::app {

namespace {

/// Levenshtein distance: insertions, deletions and replacements.
std::size_t editDistance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= left.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= right.size(); ++j) {
            const std::size_t replaced = diagonal + (left[i - 1] == right[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

} // namespace

std::string nearestName(std::string_view wrong, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t best = std::max<std::size_t>(2, wrong.size() / 3) + 1;
    for (const std::string& name : known) {
        const std::size_t distance = editDistance(wrong, name);
        if (distance < best) {
            best = distance;
            nearest = name;
        }
    }
    return nearest;
}

Error unknownName(const devices::Catalogue& catalogue, const std::string& name) {
    std::vector<std::string> known;
    for (const SignalSpec& signal : catalogue.signals) {
        known.push_back(signal.name);
    }
    for (const ParameterSpec& parameter : catalogue.parameters) {
        known.push_back(parameter.name);
    }
    const std::string nearest = nearestName(name, known);
    return {ErrorCode::UnknownName, "'" + name + "' is neither a signal nor a parameter of this device",
            nearest.empty() ? "see 'halbench describe DEVICE'" : "did you mean '" + nearest + "'?"};
}

std::vector<std::string> splitList(std::string_view text, char separator) {
    std::vector<std::string> parts;
    if (text.empty()) {
        return parts;
    }
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        std::string_view part = text.substr(begin, end - begin);
        while (!part.empty() && part.front() == ' ') {
            part.remove_prefix(1);
        }
        while (!part.empty() && part.back() == ' ') {
            part.remove_suffix(1);
        }
        parts.emplace_back(part);
        begin = end + 1;
    }
    return parts;
}

} // namespace halbench::app
