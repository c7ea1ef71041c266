#include "app/window/project/project_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {

namespace {

bool isFinite(const ConfigNode& node) {
    const bool isNumber = node.kind == ConfigNode::Kind::Number || node.kind == ConfigNode::Kind::Integer;
    return isNumber && std::isfinite(node.number);
}

} // namespace

std::string projectValue(const std::string& text) {
    return text.rfind('\n', 0) == 0 ? '\n' + text : text;
}

void ProjectReader::text(const ConfigNode& node, const std::string& key, std::string& target) {
    if (node.kind == ConfigNode::Kind::Text) {
        target = node.text;
    } else {
        refuse(node, fmt::format("'{}' must be a text", key));
    }
}

double ProjectReader::number(const ConfigNode& node, const std::string& key) {
    if (!isFinite(node)) {
        refuse(node, fmt::format("'{}' must be a finite number", key));
        return 0.0;
    }
    return node.number;
}

std::optional<double> ProjectReader::numberOrReset(const ConfigNode& node, const std::string& key) {
    if (!isFinite(node)) {
        reset(node, fmt::format("'{}' must be a finite number", key));
        return std::nullopt;
    }
    return node.number;
}

bool ProjectReader::flag(const ConfigNode& node, const std::string& key) {
    if (node.kind != ConfigNode::Kind::Boolean) {
        refuse(node, fmt::format("'{}' must be true or false", key));
    }
    return node.boolean;
}

void ProjectReader::layouts(const ConfigNode& node, std::map<std::string, std::string>& target) {
    if (node.kind != ConfigNode::Kind::Table) {
        refuse(node, "'layout' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        text(value, "layout." + key, target[key]);
    }
}

void ProjectReader::documents(const ConfigNode& node, const std::string& key,
                              std::vector<NamedDocument>& target) {
    if (node.kind != ConfigNode::Kind::List) {
        refuse(node, fmt::format("'{0}' must be a list of tables, [[{0}]]", key));
    }
    for (const ConfigNode& item : node.items) {
        document(item, key, target.emplace_back());
    }
}

void ProjectReader::refuse(const ConfigNode& node, const std::string& text) {
    if (!m_error) {
        m_error = Error{ErrorCode::InvalidInput, fmt::format("{}: {}", node.where(), text),
                        "the file is not changed; open another project or correct this line"};
    }
}

void ProjectReader::reset(const ConfigNode& node, const std::string& text) {
    m_resets.push_back(fmt::format("{}: {}", node.where(), text));
}

void ProjectReader::document(const ConfigNode& node, const std::string& key, NamedDocument& target) {
    if (node.kind != ConfigNode::Kind::Table) {
        refuse(node, fmt::format("'{0}' must be a list of tables, [[{0}]]", key));
    }
    for (const auto& [name, value] : node.members) {
        if (name == "name") {
            text(value, "name", target.name);
        } else if (name == "document") {
            text(value, "document", target.document);
        } else {
            refuse(value, fmt::format("unknown key '{}'; a [[{}]] has name and document", name, key));
        }
    }
}

} // namespace halbench::app
