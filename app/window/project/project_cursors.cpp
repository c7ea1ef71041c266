// Pairs of cursors in a project.
#include "app/window/project/project_monitor.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

void readPair(ProjectReader& reader, const ConfigNode& node, CursorChoice& pair) {
    int ends = 0;
    for (const auto& [key, value] : node.members) {
        if (key == "name") {
            reader.text(value, key, pair.name);
        } else if (key == "a_s" || key == "b_s") {
            (key == "a_s" ? pair.a_s : pair.b_s) = reader.number(value, key);
            ++ends;
        } else if (key == "measuring") {
            pair.isMeasuring = reader.flag(value, key);
        } else {
            reader.refuse(
                value,
                fmt::format("unknown key '{}'; a pair of [[cursors]] has name, a_s, b_s, measuring", key));
        }
    }
    if (pair.name.empty() || ends != 2) {
        reader.refuse(node, "a pair of [[cursors]] has a name, a_s and b_s");
    }
}

} // namespace

toml::array projectCursors(const std::vector<CursorChoice>& list) {
    toml::array array;
    for (const CursorChoice& pair : list) {
        toml::table table{{"name", projectValue(pair.name)}, {"a_s", pair.a_s}, {"b_s", pair.b_s}};
        if (pair.isMeasuring) {
            table.insert("measuring", true);
        }
        array.push_back(table);
    }
    return array;
}

void readCursors(ProjectReader& reader, const ConfigNode& node, std::vector<CursorChoice>& list) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, "'cursors' must be a list of tables, [[cursors]]");
    }
    for (const ConfigNode& item : node.items) {
        if (item.kind != ConfigNode::Kind::Table) {
            reader.refuse(item, "'cursors' must be a list of tables, [[cursors]]");
        }
        CursorChoice& pair = list.emplace_back();
        readPair(reader, item, pair);
        const auto count = [&list](const auto& isMeant) {
            return std::count_if(list.begin(), list.end(), isMeant);
        };
        if (count([&](const CursorChoice& one) { return one.name == pair.name; }) > 1) {
            reader.refuse(item, fmt::format("there is a pair of [[cursors]] named '{}' already", pair.name));
        }
        if (count([](const CursorChoice& one) { return one.isMeasuring; }) > 1) {
            reader.refuse(item, "only one pair of [[cursors]] is measuring");
        }
    }
}

} // namespace halbench::app
