#pragma once

#include "app/documents/text/config_node.h"
#include "app/window/project/project_file.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// As a value: TOML drops a line break right behind the opening quotes of a text of several lines.
std::string projectValue(const std::string& text);

/// Reads one value of a project after the other; the first mistake stays.
class ProjectReader {
public:
    void text(const ConfigNode& node, const std::string& key, std::string& target);
    /// Finite.
    double number(const ConfigNode& node, const std::string& key);
    bool flag(const ConfigNode& node, const std::string& key);
    void layouts(const ConfigNode& node, std::map<std::string, std::string>& target);
    void documents(const ConfigNode& node, const std::string& key, std::vector<NamedDocument>& target);
    void refuse(const ConfigNode& node, const std::string& text);
    /// What harms nothing when it is lost, like the room that a plot has, is no reason to refuse a project:
    /// it is as usual then, and the window says so.
    void reset(const ConfigNode& node, const std::string& text);
    /// Of such a key: finite, or nothing and said.
    std::optional<double> numberOrReset(const ConfigNode& node, const std::string& key);

    const std::optional<Error>& error() const { return m_error; }
    const std::vector<std::string>& resets() const { return m_resets; }

private:
    void document(const ConfigNode& node, const std::string& key, NamedDocument& target);

    std::optional<Error> m_error;
    std::vector<std::string> m_resets;
};

} // namespace halbench::app
