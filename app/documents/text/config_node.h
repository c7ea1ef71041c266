#pragma once

#include "app/documents/text/text_place.h"
#include "control/base/result.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halbench::app {

/// A parsed TOML value that remembers where it stands, so that every later complaint can say line and column.
struct ConfigNode {
    enum class Kind { Text, Integer, Number, Boolean, List, Table, Other };
    using Member = std::pair<std::string, ConfigNode>;

    // Outside the class, because a member's type is complete only after it.
    ConfigNode();
    ConfigNode(const ConfigNode& other);
    ConfigNode(ConfigNode&& other) noexcept;
    ConfigNode& operator=(const ConfigNode& other);
    ConfigNode& operator=(ConfigNode&& other) noexcept;
    ~ConfigNode();

    Kind kind = Kind::Table;
    std::string text;
    double number = 0.0; ///< Integer and Number
    bool boolean = false;
    std::vector<ConfigNode> items;
    std::vector<Member> members; ///< in the order of the file
    TextPlace place;
    std::string origin; ///< file name, or the --set argument that put it there

    const ConfigNode* find(std::string_view key) const;
    ConfigNode* find(std::string_view key);
    /// "experiment.toml:12:3", or the origin alone when there is no line.
    std::string where() const;
};

/// "a text", "a whole number" ... for messages.
std::string_view kindName(ConfigNode::Kind kind);

/// Errors: InvalidInput with line and column.
Result<ConfigNode> parseToml(const std::string& text, const std::string& origin);

/// Applies `run --set PATH=VALUE`: the path's first part may be "step" followed by a step's name, otherwise
/// it names a key of the file. Tables on the way are created; an existing value of another kind is replaced.
/// The value is read as TOML, and as a text when it is none. Errors: Usage (no PATH=VALUE), UnknownName (no
/// such step).
Result<void> assignPath(ConfigNode& root, const std::string& assignment);

} // namespace halbench::app
