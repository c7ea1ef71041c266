#pragma once

#include "app/batch/config_node.h"
#include "app/window/project_file.h"

#include <optional>
#include <string>

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

    const std::optional<Error>& error() const { return m_error; }

private:
    void document(const ConfigNode& node, const std::string& key, NamedDocument& target);

    std::optional<Error> m_error;
};

} // namespace halbench::app
