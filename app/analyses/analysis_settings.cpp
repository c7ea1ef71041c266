#include "app/analyses/analysis_settings.h"

#include "app/documents/text/config_node.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

const AnalysisKey* keyOf(const Analysis& analysis, const std::string& name) {
    const auto found = std::find_if(analysis.keys.begin(), analysis.keys.end(),
                                    [&name](const AnalysisKey& key) { return key.name == name; });
    return found == analysis.keys.end() ? nullptr : &*found;
}

std::string allowedKeys(const Analysis& analysis) {
    std::string names;
    for (const AnalysisKey& key : analysis.keys) {
        names += (names.empty() ? "" : ", ") + std::string(key.name);
    }
    return "allowed here: " + names;
}

bool isOfKind(const AnalysisKey& key, const ConfigNode& node) {
    switch (key.type) {
    case AnalysisKeyType::Number:
        return node.kind == ConfigNode::Kind::Number || node.kind == ConfigNode::Kind::Integer;
    case AnalysisKeyType::Integer:
        return node.kind == ConfigNode::Kind::Integer;
    case AnalysisKeyType::Flag:
        return node.kind == ConfigNode::Kind::Boolean;
    case AnalysisKeyType::Text:
    case AnalysisKeyType::Choice:
        break;
    }
    return node.kind == ConfigNode::Kind::Text;
}

std::string_view kindOf(const AnalysisKey& key) {
    switch (key.type) {
    case AnalysisKeyType::Number:
        return "a number";
    case AnalysisKeyType::Integer:
        return "a whole number";
    case AnalysisKeyType::Flag:
        return "true or false";
    case AnalysisKeyType::Text:
    case AnalysisKeyType::Choice:
        break;
    }
    return "a text in quotes";
}

/// One setting, judged like an option of the command.
Result<void> addSetting(const Analysis& analysis, const ConfigNode::Member& member, AnalysisTexts& texts) {
    const auto& [name, node] = member;
    const AnalysisKey* key = keyOf(analysis, name);
    if (key == nullptr) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: unknown key '{}'", node.where(), name),
                       allowedKeys(analysis));
    }
    if (!isOfKind(*key, node)) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("{}: '{}' is {}, not {}", node.where(), name, kindName(node.kind), kindOf(*key)),
            fmt::format("write {}", kindOf(*key)));
    }
    if (key->type == AnalysisKeyType::Flag) {
        texts.flags[name] = node.boolean;
        return {};
    }
    const bool isText = node.kind == ConfigNode::Kind::Text;
    texts.values[name] = isText ? node.text : formatNumber(node.number);
    const auto judged = parseAnalysisValues(analysis, {{name, texts.values[name]}}, {});
    return judged ? Result<void>()
                  : failure(ErrorCode::InvalidInput,
                            fmt::format("{}: {}", node.where(), judged.error().message), judged.error().hint);
}

} // namespace

Result<AnalysisTexts> readAnalysisSettings(const Analysis& analysis, const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    const Result<ConfigNode> root = parseToml(*text, path);
    if (!root) {
        return failure(root.error());
    }
    AnalysisTexts texts;
    for (const ConfigNode::Member& member : root->members) {
        if (const Result<void> added = addSetting(analysis, member, texts); !added) {
            return failure(added.error());
        }
    }
    return texts;
}

} // namespace halbench::app
