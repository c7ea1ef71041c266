#include "app/experiments/experiment_validation.h"

#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/experiments/experiment_keys.h"
#include "app/procedures/record/capture_procedure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace halbench::app {

namespace {

tl::unexpected<Error> complaint(const ConfigNode& node, const std::string& what, const std::string& hint) {
    return failure(ErrorCode::InvalidInput, node.where() + ": " + what, hint);
}

std::string lastPart(std::string_view key) {
    return std::string(key.substr(key.rfind('.') + 1));
}

std::string keyList(const std::vector<const KeySpec*>& keys) {
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const KeySpec* spec : keys) {
        names.push_back(lastPart(spec->key));
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

Result<void> checkNumber(const KeySpec& spec, const ConfigNode& node) {
    const bool isNumber = node.kind == ConfigNode::Kind::Number || node.kind == ConfigNode::Kind::Integer;
    if (!isNumber || (spec.type == KeyType::Integer && node.kind != ConfigNode::Kind::Integer)) {
        return complaint(node, fmt::format("'{}' is {}", spec.key, kindName(node.kind)),
                         spec.type == KeyType::Integer ? "give a whole number" : "give a number");
    }
    if (!std::isfinite(node.number) || node.number < spec.min || node.number > spec.max) {
        return complaint(node, fmt::format("'{}' = {} is out of range", spec.key, formatNumber(node.number)),
                         fmt::format("allowed is {} to {}", formatNumber(spec.min), formatNumber(spec.max)));
    }
    return {};
}

Result<void> checkChoice(const KeySpec& spec, const ConfigNode& node) {
    const std::vector<std::string> choices = choicesOf(spec);
    if (node.kind != ConfigNode::Kind::Text ||
        std::find(choices.begin(), choices.end(), node.text) == choices.end()) {
        const std::string got =
            node.kind == ConfigNode::Kind::Text ? "\"" + node.text + "\"" : std::string(kindName(node.kind));
        return complaint(node, fmt::format("'{}' is {}", spec.key, got),
                         fmt::format("allowed: {}", fmt::join(choices, ", ")));
    }
    return {};
}

Result<void> checkNumbers(const KeySpec& spec, const ConfigNode& node) {
    if (node.kind == ConfigNode::Kind::Table && !node.members.empty()) {
        for (const ConfigNode::Member& member : node.members) {
            const KeySpec entry{spec.section, member.first, KeyType::Number};
            const bool isTable = member.second.kind == ConfigNode::Kind::Table;
            const Result<void> valid =
                isTable ? checkNumbers(spec, member.second) : checkNumber(entry, member.second);
            if (!valid) {
                return valid;
            }
        }
        return {};
    }
    return complaint(node, fmt::format("'{}' needs a table of names and numbers", spec.key),
                     "write it like { \"gain.kp\" = 10.0 }");
}

bool isName(const std::string& text) {
    return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

Result<void> checkText(const KeySpec& spec, const ConfigNode& node) {
    if (node.kind != ConfigNode::Kind::Text) {
        return complaint(node, fmt::format("'{}' is {}", spec.key, kindName(node.kind)),
                         "give a text in quotes");
    }
    if (spec.type == KeyType::Name && !isName(node.text)) {
        return complaint(node, fmt::format("'{}' = \"{}\" is no name", spec.key, node.text),
                         "use up to 64 letters, digits, '-' and '_'");
    }
    return {};
}

Result<void> checkTextList(const KeySpec& spec, const ConfigNode& node) {
    bool isList = node.kind == ConfigNode::Kind::List && !node.items.empty();
    for (const ConfigNode& item : node.items) {
        isList = isList && item.kind == ConfigNode::Kind::Text;
    }
    if (!isList) {
        return complaint(node, fmt::format("'{}' needs a list of texts", spec.key),
                         "write it like [\"position\", \"current_command\"]");
    }
    return {};
}

Result<void> checkKeys(const ConfigNode& table, std::string_view section, std::string_view parent);

Result<void> checkValue(const KeySpec& spec, const ConfigNode& node) {
    switch (spec.type) {
    case KeyType::Text:
    case KeyType::Name:
        return checkText(spec, node);
    case KeyType::TextList:
        return checkTextList(spec, node);
    case KeyType::Number:
    case KeyType::Integer:
        return checkNumber(spec, node);
    case KeyType::Boolean:
        return node.kind == ConfigNode::Kind::Boolean
                   ? Result<void>()
                   : complaint(node, fmt::format("'{}' is {}", spec.key, kindName(node.kind)),
                               "allowed: true, false");
    case KeyType::Choice:
    case KeyType::PresetName:
        return checkChoice(spec, node);
    case KeyType::Numbers:
        return checkNumbers(spec, node);
    case KeyType::Table:
        return node.kind == ConfigNode::Kind::Table
                   ? checkKeys(node, spec.section, spec.key)
                   : complaint(node, fmt::format("'{}' is {}", spec.key, kindName(node.kind)),
                               fmt::format("give a table with {}", keyList(keysOf(spec.section, spec.key))));
    }
    return {};
}

/// Keys of a step are those of its kind and those of every step.
std::vector<const KeySpec*> knownKeys(std::string_view section, std::string_view parent) {
    std::vector<const KeySpec*> keys = keysOf(section, parent);
    const std::vector<std::string> kinds = stepKinds();
    if (parent.empty() && std::find(kinds.begin(), kinds.end(), section) != kinds.end()) {
        const std::vector<const KeySpec*> common = keysOf("step", "");
        keys.insert(keys.begin(), common.begin(), common.end());
    }
    return keys;
}

Result<void> checkKeys(const ConfigNode& table, std::string_view section, std::string_view parent) {
    const std::vector<const KeySpec*> keys = knownKeys(section, parent);
    for (const ConfigNode::Member& member : table.members) {
        const auto spec = std::find_if(keys.begin(), keys.end(), [&](const KeySpec* candidate) {
            return lastPart(candidate->key) == member.first;
        });
        const bool isArrayOfTables =
            section == "experiment" && (member.first == "step" || member.first == "check");
        if (spec == keys.end() && !isArrayOfTables) {
            return complaint(member.second, fmt::format("unknown key '{}'", member.first),
                             fmt::format("allowed here: {}{}", keyList(keys),
                                         section == "experiment" ? ", [[step]], [[check]]" : ""));
        }
        if (!isArrayOfTables) {
            if (const Result<void> valid = checkValue(**spec, member.second); !valid) {
                return valid;
            }
        }
    }
    for (const KeySpec* spec : keys) {
        if (spec->isRequired && table.find(lastPart(spec->key)) == nullptr) {
            return complaint(table, fmt::format("the key '{}' is missing", spec->key),
                             std::string(spec->help));
        }
    }
    return {};
}

/// A key that the subject of an analysis does not read is a mistake, not a remark.
Result<void> checkSubject(const ConfigNode& step) {
    constexpr std::array<std::pair<const char*, const char*>, 12> Readers = {
        std::pair("model", "loop"),        std::pair("gains", "loop"),
        std::pair("speed_rpm", "torque"),  std::pair("torque_Nm", "torque"),
        std::pair("zeta", "poles"),        std::pair("omega_rad_s", "poles"),
        std::pair("rate_deg_s", "poles"),  std::pair("accuracy_deg", "poles"),
        std::pair("remanence_T", "field"), std::pair("ring_radius_mm", "field"),
        std::pair("pitch_mm", "coil"),     std::pair("temperature_degC", "sensing")};
    const std::string& subject = step.find("what")->text;
    for (const auto& [key, reader] : Readers) {
        if (const ConfigNode* node = step.find(key); node != nullptr && subject != reader) {
            return complaint(*node, fmt::format("'{}' is not used with what = \"{}\"", key, subject),
                             fmt::format("it belongs to \"{}\"", reader));
        }
    }
    return {};
}

Result<void> checkRecording(const ConfigNode& step) {
    const ConfigNode* trigger = step.find("trigger");
    for (const char* key : {"pre_trigger_s", "wait_s"}) {
        if (const ConfigNode* node = step.find(key); node != nullptr && trigger == nullptr) {
            return complaint(*node, fmt::format("'{}' needs a 'trigger'", key),
                             "give the trigger, e.g. trigger = \"speed>10\"");
        }
    }
    if (trigger == nullptr) {
        return {};
    }
    const Result<CaptureTrigger> event = parseCaptureTrigger(trigger->text);
    if (!event || event->kind != CaptureTrigger::Kind::Level) {
        return complaint(*trigger, fmt::format("'trigger' = \"{}\" is no level of a signal", trigger->text),
                         "write SIGNAL>LEVEL (rising) or SIGNAL<LEVEL (falling), e.g. \"speed>10\"");
    }
    if (const ConfigNode* reconnect = step.find("reconnect"); reconnect != nullptr && reconnect->boolean) {
        return complaint(*reconnect, "'reconnect' does not go with 'trigger'", "leave one of them out");
    }
    return {};
}

/// Of the keys that begin with `stem`: the names that a table holds.
std::vector<std::string> keysWith(const ConfigNode& table, std::string_view stem) {
    std::vector<std::string> keys;
    for (const ConfigNode::Member& member : table.members) {
        if (member.first.starts_with(stem)) {
            keys.push_back(member.first);
        }
    }
    return keys;
}

bool isOfAngle(const std::string& key) {
    return key.find("rad") != std::string::npos || key.find("deg") != std::string::npos;
}

/// An amplitude, a rate and a base are each written in one unit; a table may have a rate of lengths and one
/// of angles.
Result<void> checkReferenceUnits(const ConfigNode* reference) {
    const ConfigNode* shape = reference != nullptr ? reference->find("shape") : nullptr;
    const bool isOfTable = shape != nullptr && shape->text == "table";
    for (const std::string_view stem : {"amplitude_", "rate_", "base_"}) {
        const auto keys = reference != nullptr ? keysWith(*reference, stem) : std::vector<std::string>();
        const bool isOfBoth = isOfTable && keys.size() == 2 && isOfAngle(keys[0]) != isOfAngle(keys[1]);
        if (keys.size() > 1 && !isOfBoth) {
            return complaint(*reference, fmt::format("'{}' and '{}' exclude each other", keys[0], keys[1]),
                             "give one");
        }
    }
    return {};
}

/// A limit is written in one unit, and it and the direction are those of repeated runs.
Result<void> checkRepetition(const ConfigNode& step) {
    std::vector<std::string> keys = keysWith(step, "settled_");
    if (keys.size() > 1) {
        return complaint(step, fmt::format("'{}' and '{}' exclude each other", keys[0], keys[1]), "give one");
    }
    if (step.find("alternate") != nullptr) {
        keys.emplace_back("alternate");
    }
    if (!keys.empty() && step.find("repeat") == nullptr) {
        return complaint(*step.find(keys[0]), fmt::format("'{}' needs 'repeat'", keys[0]),
                         "say how many times");
    }
    return {};
}

/// Rules that no single key can hold.
Result<void> checkCombination(const ConfigNode& step) {
    const auto has = [&](const ConfigNode* table, const char* key) {
        return table != nullptr && table->find(key) != nullptr;
    };
    const std::string& kind = step.find("kind")->text;
    if (kind == "apply" && has(&step, "gains") == has(&step, "preset")) {
        return complaint(step, "needs one of 'gains' and 'preset'", "name a tune step or a preset");
    }
    if (kind == "apply" && has(&step, "verify_step_deg") && !has(&step, "gains") && !has(&step, "model")) {
        return complaint(step, "'verify_step_deg' needs a 'model' beside a preset", "name an identify step");
    }
    if (kind == "tune" && has(&step, "model") == has(&step, "model_file")) {
        return complaint(step, "needs one of 'model' and 'model_file'", "name an identify step or a file");
    }
    if (kind == "identify" && has(&step, "bare") != has(&step, "added_inertia_kg_m2")) {
        return complaint(step, "'bare' and 'added_inertia_kg_m2' belong together", "give both or none");
    }
    if (kind == "analyse" && step.find("what")->text == "loop" &&
        !(has(&step, "model") && has(&step, "gains"))) {
        return complaint(step, "what = \"loop\" needs 'model' and 'gains'",
                         "name an identify and a tune step");
    }
    if (const Result<void> repeated = checkRepetition(step); !repeated) {
        return repeated;
    }
    if (kind == "record") {
        if (const Result<void> recorded = checkRecording(step); !recorded) {
            return recorded;
        }
    }
    if (kind == "analyse") {
        if (const Result<void> read = checkSubject(step); !read) {
            return read;
        }
    }
    return checkReferenceUnits(step.find("reference"));
}

/// A step may use the results of steps before it only.
Result<void> checkUses(const ConfigNode& step, const std::vector<const ConfigNode*>& earlier) {
    constexpr std::array<std::pair<const char*, const char*>, 5> Uses = {
        std::pair("model", "identify"), std::pair("gains", "tune"), std::pair("bare", "identify"),
        std::pair("relay", "relay"), std::pair("recording", "record")};
    for (const auto& use : Uses) {
        const ConfigNode* used = step.find(use.first);
        const auto isMeant = [&](const ConfigNode* other) {
            return other->find("name")->text == used->text && other->find("kind")->text == use.second;
        };
        const bool isFound = used == nullptr || std::any_of(earlier.begin(), earlier.end(), isMeant);
        if (!isFound) {
            return complaint(*used,
                             fmt::format("'{}': no earlier step of kind {} is called \"{}\"", use.first,
                                         use.second, used->text),
                             "use an earlier step");
        }
    }
    return {};
}

Result<void> checkSteps(const ConfigNode& root) {
    const ConfigNode* steps = root.find("step");
    if (steps == nullptr || steps->kind != ConfigNode::Kind::List || steps->items.empty()) {
        return complaint(root, "there is no [[step]]", "add at least one step");
    }
    std::vector<const ConfigNode*> earlier;
    for (const ConfigNode& step : steps->items) {
        const ConfigNode* kind = step.find("kind");
        if (step.kind != ConfigNode::Kind::Table || kind == nullptr) {
            return complaint(step, "a step needs the key 'kind'",
                             fmt::format("allowed: {}", fmt::join(stepKinds(), ", ")));
        }
        Result<void> valid = checkValue(*keysOf("step", "").front(), *kind);
        valid = valid ? checkKeys(step, kind->text, "") : valid;
        valid = valid ? checkCombination(step) : valid;
        valid = valid ? checkUses(step, earlier) : valid;
        if (!valid) {
            return valid;
        }
        for (const ConfigNode* other : earlier) {
            if (other->find("name")->text == step.find("name")->text) {
                return complaint(*step.find("name"),
                                 "two steps are called \"" + step.find("name")->text + "\"", "rename one");
            }
        }
        earlier.push_back(&step);
    }
    return {};
}

Result<void> checkCheck(const ConfigNode& check, const ConfigNode& steps) {
    const Result<void> valid = checkKeys(check, "check", "");
    if (!valid) {
        return valid;
    }
    const ConfigNode* min = check.find("min");
    const ConfigNode* max = check.find("max");
    if (min == nullptr && max == nullptr) {
        return complaint(check, "a check needs 'min', 'max' or both", "give a limit");
    }
    if (min != nullptr && max != nullptr && min->number > max->number) {
        return complaint(check, "'min' is larger than 'max'", "exchange them");
    }
    const std::string& quantity = check.find("quantity")->text;
    const std::string step = quantity.substr(0, quantity.find('.'));
    const bool isKnown =
        std::any_of(steps.items.begin(), steps.items.end(),
                    [&](const ConfigNode& candidate) { return candidate.find("name")->text == step; });
    if (!isKnown || quantity.size() <= step.size() + 1) {
        return complaint(*check.find("quantity"), fmt::format("no step is called \"{}\"", step),
                         "write STEP.QUANTITY with the name of a step");
    }
    return {};
}

} // namespace

Result<void> validateExperiment(const ConfigNode& root) {
    Result<void> valid = checkKeys(root, "experiment", "");
    valid = valid ? checkSteps(root) : valid;
    const ConfigNode* checks = root.find("check");
    if (!valid || checks == nullptr) {
        return valid;
    }
    if (checks->kind != ConfigNode::Kind::List) {
        return complaint(*checks, "'check' must be [[check]]", "use double brackets");
    }
    for (const ConfigNode& check : checks->items) {
        if (check.kind != ConfigNode::Kind::Table) {
            return complaint(check, "a check must be a table", "use [[check]]");
        }
        valid = checkCheck(check, *root.find("step"));
        if (!valid) {
            return valid;
        }
    }
    return {};
}

} // namespace halbench::app
