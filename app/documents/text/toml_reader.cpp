#include "app/documents/text/config_node.h"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace halbench::app {

namespace {

ConfigNode fromToml(const toml::node& source, const std::string& origin);

void takeMembers(const toml::table& table, const std::string& origin, ConfigNode& node) {
    for (const auto& [key, value] : table) {
        node.members.emplace_back(std::string(key.str()), fromToml(value, origin));
        ConfigNode& member = node.members.back().second;
        if (key.source().begin.line > 0 && member.kind != ConfigNode::Kind::Table) {
            member.place = {static_cast<int>(key.source().begin.line),
                            static_cast<int>(key.source().begin.column)};
        }
    }
}

ConfigNode fromToml(const toml::node& source, const std::string& origin) {
    ConfigNode node;
    node.origin = origin;
    node.place = {static_cast<int>(source.source().begin.line),
                  static_cast<int>(source.source().begin.column)};
    if (const toml::table* table = source.as_table()) {
        node.kind = ConfigNode::Kind::Table;
        takeMembers(*table, origin, node);
    } else if (const toml::array* list = source.as_array()) {
        node.kind = ConfigNode::Kind::List;
        for (const toml::node& item : *list) {
            node.items.push_back(fromToml(item, origin));
        }
    } else if (const auto* text = source.as_string()) {
        node.kind = ConfigNode::Kind::Text;
        node.text = text->get();
    } else if (const auto* whole = source.as_integer()) {
        node.kind = ConfigNode::Kind::Integer;
        node.number = static_cast<double>(whole->get());
    } else if (const auto* number = source.as_floating_point()) {
        node.kind = ConfigNode::Kind::Number;
        node.number = number->get();
    } else if (const auto* boolean = source.as_boolean()) {
        node.kind = ConfigNode::Kind::Boolean;
        node.boolean = boolean->get();
    } else {
        node.kind = ConfigNode::Kind::Other;
    }
    return node;
}

} // namespace

Result<ConfigNode> parseToml(const std::string& text, const std::string& origin) {
    try { // the library of Debian reports by exception
        const toml::table root = toml::parse(std::string_view(text), std::string_view(origin));
        return fromToml(root, origin);
    } catch (const toml::parse_error& error) {
        const toml::source_position& place = error.source().begin;
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}:{}:{}: not valid TOML: {}", origin, place.line, place.column,
                                   error.description()),
                       "correct the line or open an earlier copy; the help shows the form of the files");
    }
}

} // namespace halbench::app
