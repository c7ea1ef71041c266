#pragma once

#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace halbench::app {

/// Value kinds of a key of an experiment file.
enum class KeyType {
    Text,
    Name, ///< letters, digits, '-' and '_': it becomes part of file names
    TextList,
    Number,  ///< finite, within [min, max]
    Integer, ///< likewise, whole
    Boolean,
    Choice,    ///< one of `choices`
    Numbers,   ///< a table of names and finite numbers; dotted and quoted names mean the same
    Table,     ///< its keys follow in the table as "key.sub"
    PresetName ///< one of presetNames()
};

/// One key of an experiment file. This table is the only place that knows them: it drives validation, the
/// messages, resources/schemas/experiment.schema.json and the tables of resources/help/command-line.md.
struct KeySpec {
    std::string_view section; ///< "experiment", "check", "step" (every kind), or a kind of step
    std::string_view key;     ///< "currents_A.from" lies in the table "currents_A"
    KeyType type = KeyType::Text;
    bool isRequired = false;
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    std::string_view choices{}; ///< separated by '|'
    std::string_view help{};
};

std::span<const KeySpec> experimentKeys();

/// The kinds of steps, in the order of the help.
std::vector<std::string> stepKinds();

/// The texts that a key takes, none for one that is no choice.
std::vector<std::string> choicesOf(const KeySpec& spec);

/// The keys of one section directly under `table` ("" = the section itself).
std::vector<const KeySpec*> keysOf(std::string_view section, std::string_view table);

} // namespace halbench::app
