#pragma once

#include "control/base/result.h"
#include "devices/simulated/simulated_model.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

/// The value of a key as a number. Errors: OutOfRange, InvalidInput; `keys` stand in the hint.
Result<double> parseOverride(const std::string& key, const std::string& text, const std::string& keys);

/// The index of one of the words of a key, written as the word or the index. Errors: OutOfRange,
/// InvalidInput; the words stand in the hint.
Result<double> parseOverrideWord(const std::string& key, const std::string& text,
                                 const std::vector<std::string>& words);

/// One of two words; true for the second. Errors: InvalidInput.
Result<bool> parseOverrideChoice(const Overrides& overrides, const std::string& key, const char* usual,
                                 const char* other, const std::string& keys);

/// The words of a key that is a choice among them; empty for a number.
using OverrideWords = std::vector<std::string> (*)(std::string_view key);

/// `seed`, `imperfections` and `chain`, which every device takes.
std::vector<OverrideSpec> commonOverrideSpecs();

/// Those and the keys of one device. `specs` have key, unit, min, max and meaning; `standardOf` gives the
/// value of a key where nothing is written, nothing where the seed draws it; `wordsOf`, if given, the words
/// of a choice.
template <typename Specs, typename StandardOf>
std::vector<OverrideSpec> overrideSpecs(const Specs& specs, StandardOf standardOf,
                                        OverrideWords wordsOf = nullptr) {
    std::vector<OverrideSpec> all = commonOverrideSpecs();
    for (const auto& spec : specs) {
        all.push_back({std::string(spec.key), std::string(spec.unit), spec.min, spec.max,
                       standardOf(spec.key), std::string(spec.meaning)});
        if (wordsOf != nullptr) {
            all.back().choices = wordsOf(spec.key);
        }
    }
    return all;
}

/// Parameters of one simulated device that its address may change. Besides its own keys every device
/// takes `imperfections` (on, off) and `chain` (full, ideal).
template <typename Parameters>
struct OverrideTable {
    std::string address; ///< e.g. "sim:htm", for messages
    std::string keys;    ///< all of them, for messages
    bool (*isKnown)(std::string_view key);
    Result<void> (*set)(Parameters& parameters, std::string_view key, double value);
    Parameters (*withoutImperfections)(Parameters parameters);
    Parameters (*withIdealChain)(Parameters parameters);
    OverrideWords words = nullptr; ///< none: every key is a number
};

/// Parameters with the overrides in force. Written values win over the sets, in any order; `seed` belongs to
/// the address and is skipped. Errors: UnknownName, InvalidInput, NotFinite, OutOfRange.
template <typename Parameters>
Result<Parameters> withOverrides(const OverrideTable<Parameters>& table, const Overrides& overrides) {
    const std::string hint = fmt::format("Known keys: {}.", table.keys);
    const Result<bool> isOff = parseOverrideChoice(overrides, "imperfections", "on", "off", hint);
    if (!isOff) {
        return failure(isOff.error());
    }
    const Result<bool> isIdeal = parseOverrideChoice(overrides, "chain", "full", "ideal", hint);
    if (!isIdeal) {
        return failure(isIdeal.error());
    }
    Parameters parameters;
    parameters = *isOff ? table.withoutImperfections(parameters) : parameters;
    parameters = *isIdeal ? table.withIdealChain(parameters) : parameters;
    for (const auto& [key, text] : overrides) {
        if (key == "imperfections" || key == "chain" || key == "seed") {
            continue;
        }
        if (!table.isKnown(key)) {
            return failure(ErrorCode::UnknownName, fmt::format("{} has no override '{}'", table.address, key),
                           hint);
        }
        const std::vector<std::string> words =
            table.words != nullptr ? table.words(key) : std::vector<std::string>();
        const Result<double> value =
            words.empty() ? parseOverride(key, text, hint) : parseOverrideWord(key, text, words);
        if (!value) {
            return failure(value.error());
        }
        if (const Result<void> isSet = table.set(parameters, key, *value); !isSet) {
            return failure(isSet.error());
        }
    }
    return parameters;
}

} // namespace halbench::devices
