#include "app/documents/text/config_node.h"

#include "app/documents/text/names.h"

#include <fmt/format.h>

namespace halbench::app {

ConfigNode::ConfigNode() = default;
ConfigNode::ConfigNode(const ConfigNode& other) = default;
ConfigNode::ConfigNode(ConfigNode&& other) noexcept = default;
ConfigNode& ConfigNode::operator=(const ConfigNode& other) = default;
ConfigNode& ConfigNode::operator=(ConfigNode&& other) noexcept = default;
ConfigNode::~ConfigNode() = default;

const ConfigNode* ConfigNode::find(std::string_view key) const {
    for (const Member& member : members) {
        if (member.first == key) {
            return &member.second;
        }
    }
    return nullptr;
}

ConfigNode* ConfigNode::find(std::string_view key) {
    return const_cast<ConfigNode*>(static_cast<const ConfigNode*>(this)->find(key));
}

std::string ConfigNode::where() const {
    return place.line > 0 ? fmt::format("{}:{}:{}", origin, place.line, place.column) : origin;
}

std::string_view kindName(ConfigNode::Kind kind) {
    switch (kind) {
    case ConfigNode::Kind::Text:
        return "a text";
    case ConfigNode::Kind::Integer:
        return "a whole number";
    case ConfigNode::Kind::Number:
        return "a number";
    case ConfigNode::Kind::Boolean:
        return "true or false";
    case ConfigNode::Kind::List:
        return "a list";
    case ConfigNode::Kind::Table:
        return "a table";
    case ConfigNode::Kind::Other:
        return "a date or time";
    }
    return "a value";
}

namespace {

void setOrigin(ConfigNode& node, const std::string& origin) {
    node.origin = origin;
    node.place = {};
    for (ConfigNode& item : node.items) {
        setOrigin(item, origin);
    }
    for (ConfigNode::Member& member : node.members) {
        setOrigin(member.second, origin);
    }
}

ConfigNode parseValue(const std::string& text) {
    const Result<ConfigNode> document = parseToml("value = " + text, "--set");
    if (document && document->members.size() == 1) {
        return document->members.front().second;
    }
    ConfigNode node;
    node.kind = ConfigNode::Kind::Text;
    node.text = text;
    return node;
}

/// The step that `name` names, nullptr without one.
ConfigNode* findStep(ConfigNode& root, const std::string& name) {
    ConfigNode* steps = root.find("step");
    if (steps == nullptr) {
        return nullptr;
    }
    for (ConfigNode& step : steps->items) {
        const ConfigNode* stepName = step.find("name");
        if (stepName != nullptr && stepName->text == name) {
            return &step;
        }
    }
    return nullptr;
}

ConfigNode& childTable(ConfigNode& parent, const std::string& key) {
    if (ConfigNode* child = parent.find(key)) {
        if (child->kind != ConfigNode::Kind::Table) {
            *child = ConfigNode{};
        }
        return *child;
    }
    parent.members.emplace_back(key, ConfigNode{});
    return parent.members.back().second;
}

} // namespace

Result<void> assignPath(ConfigNode& root, const std::string& assignment) {
    const std::string origin = "--set " + assignment;
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
        return failure(ErrorCode::Usage, origin + ": is not PATH=VALUE", "write step.sweep.given.J=6e-4");
    }
    const std::vector<std::string> path = splitList(assignment.substr(0, equals), '.');
    ConfigNode* table = &root;
    std::size_t next = 0;
    if (path.front() == "step") {
        table = path.size() < 3 ? nullptr : findStep(root, path[1]);
        if (table == nullptr) {
            return failure(ErrorCode::UnknownName, origin + ": there is no such step",
                           "write step.NAME.KEY=VALUE with the name of a step of the file");
        }
        next = 2;
    }
    for (; next + 1 < path.size(); ++next) {
        table = &childTable(*table, path[next]);
    }
    ConfigNode value = parseValue(assignment.substr(equals + 1));
    setOrigin(value, origin);
    if (ConfigNode* existing = table->find(path.back())) {
        *existing = std::move(value);
    } else {
        table->members.emplace_back(path.back(), std::move(value));
    }
    return {};
}

} // namespace halbench::app
