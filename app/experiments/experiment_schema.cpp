#include "app/experiments/experiment_schema.h"

#include "app/documents/text/numbers.h"
#include "app/experiments/experiment_keys.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace halbench::app {

namespace {

constexpr double Unlimited = std::numeric_limits<double>::max();

std::string lastPart(std::string_view key) {
    return std::string(key.substr(key.rfind('.') + 1));
}

JsonValue tableSchema(std::string_view section, std::string_view parent);

JsonValue typed(const char* type) {
    JsonValue schema = JsonValue::object();
    return schema.set("type", type);
}

JsonValue numberSchema(const KeySpec& spec) {
    JsonValue schema = typed(spec.type == KeyType::Integer ? "integer" : "number");
    if (spec.min > -Unlimited) {
        schema.set("minimum", spec.min);
    }
    if (spec.max < Unlimited) {
        schema.set("maximum", spec.max);
    }
    return schema;
}

JsonValue valueSchema(const KeySpec& spec) {
    switch (spec.type) {
    case KeyType::Text:
        return typed("string");
    case KeyType::Name:
        return typed("string").set("pattern", "^[A-Za-z0-9_-]{1,64}$");
    case KeyType::TextList:
        return typed("array").set("items", typed("string")).set("minItems", 1);
    case KeyType::Number:
    case KeyType::Integer:
        return numberSchema(spec);
    case KeyType::Boolean:
        return typed("boolean");
    case KeyType::Choice:
    case KeyType::PresetName: {
        JsonValue schema = JsonValue::object();
        return schema.set("enum", choicesOf(spec));
    }
    case KeyType::Numbers: // dotted names become tables in tables
        return typed("object").set(
            "additionalProperties",
            JsonValue::object().set("type", JsonValue(std::vector<const char*>{"number", "object"})));
    case KeyType::Table:
        return tableSchema(spec.section, spec.key);
    }
    return {};
}

void addKeys(const std::vector<const KeySpec*>& keys, JsonValue& properties, JsonValue& required) {
    for (const KeySpec* spec : keys) {
        JsonValue schema = valueSchema(*spec);
        properties.set(lastPart(spec->key), schema.set("description", spec->help));
        if (spec->isRequired) {
            required.push(lastPart(spec->key));
        }
    }
}

JsonValue objectSchema(const JsonValue& properties, const JsonValue& required) {
    JsonValue schema = typed("object");
    schema.set("additionalProperties", false).set("required", required);
    return schema.set("properties", properties);
}

JsonValue tableSchema(std::string_view section, std::string_view parent) {
    JsonValue properties = JsonValue::object();
    JsonValue required = JsonValue::array();
    addKeys(keysOf(section, parent), properties, required);
    return objectSchema(properties, required);
}

JsonValue stepSchema(const std::string& kind) {
    JsonValue properties = JsonValue::object();
    JsonValue required = JsonValue::array();
    addKeys(keysOf("step", ""), properties, required);
    properties.set("kind", JsonValue::object().set("const", kind));
    addKeys(keysOf(kind, ""), properties, required);
    return objectSchema(properties, required);
}

std::string rangeText(const KeySpec& spec) {
    if (const std::vector<std::string> choices = choicesOf(spec); !choices.empty()) {
        return fmt::format("{}", fmt::join(choices, ", "));
    }
    constexpr std::array Types = {"text",          "name", "list of texts",    "number", "whole number",
                                  "true or false", "",     "table of numbers", "table"};
    const std::string type = Types[static_cast<std::size_t>(spec.type)];
    const bool isBounded =
        (spec.type == KeyType::Number || spec.type == KeyType::Integer) && spec.max < Unlimited;
    return isBounded ? fmt::format("{} {} to {}", type, formatNumber(spec.min), formatNumber(spec.max))
                     : type;
}

} // namespace

JsonValue experimentSchema() {
    JsonValue properties = JsonValue::object();
    JsonValue required = JsonValue::array();
    addKeys(keysOf("experiment", ""), properties, required);
    JsonValue kinds = JsonValue::array();
    for (const std::string& kind : stepKinds()) {
        kinds.push(stepSchema(kind));
    }
    properties.set("step",
                   typed("array").set("minItems", 1).set("items", JsonValue::object().set("oneOf", kinds)));
    properties.set("check", typed("array").set("items", tableSchema("check", "")));
    required.push("step");
    JsonValue schema = JsonValue::object();
    schema.set("$schema", "http://json-schema.org/draft-07/schema#").set("$id", "halbench.experiment.1");
    schema.set("title", "Experiment file (TOML)");
    const JsonValue object = objectSchema(properties, required);
    for (const JsonMember& member : object.members()) {
        schema.set(member.key, member.value);
    }
    return schema;
}

std::string experimentKeyTables() {
    std::vector<std::string> sections = {"experiment", "check", "step"};
    for (const std::string& kind : stepKinds()) {
        sections.push_back(kind);
    }
    std::string text;
    for (const std::string& section : sections) {
        const bool isKind = text.find("`step`") != std::string::npos;
        text += fmt::format("{}`{}`\n\n| key | needed | value | meaning |\n|---|---|---|---|\n",
                            isKind ? "kind " : "", section);
        for (const KeySpec& spec : experimentKeys()) {
            if (spec.section == section) {
                text += fmt::format("| `{}` | {} | {} | {} |\n", spec.key, spec.isRequired ? "yes" : "",
                                    rangeText(spec), spec.help);
            }
        }
        text += '\n';
    }
    return text;
}

} // namespace halbench::app
