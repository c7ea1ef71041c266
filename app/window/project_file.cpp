#include "app/window/project_file.h"

#include "app/batch/config_node.h"
#include "app/batch/output_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <optional>
#include <sstream>

namespace halbench::app {

namespace {

constexpr const char* Schema = "halbench.project/1";

toml::array documents(const std::vector<NamedDocument>& list) {
    toml::array array;
    for (const NamedDocument& entry : list) {
        array.push_back(toml::table{{"name", entry.name}, {"document", entry.document}});
    }
    return array;
}

/// Reads one value after the other; the first mistake stays.
class Reader {
public:
    void text(const ConfigNode& node, const std::string& key, std::string& target) {
        if (node.kind == ConfigNode::Kind::Text) {
            target = node.text;
        } else {
            refuse(node, fmt::format("'{}' must be a text", key));
        }
    }

    void layouts(const ConfigNode& node, std::map<std::string, std::string>& target) {
        if (node.kind != ConfigNode::Kind::Table) {
            refuse(node, "'layout' must be a table");
        }
        for (const auto& [key, value] : node.members) {
            text(value, "layout." + key, target[key]);
        }
    }

    void documents(const ConfigNode& node, const std::string& key, std::vector<NamedDocument>& target) {
        if (node.kind != ConfigNode::Kind::List) {
            refuse(node, fmt::format("'{0}' must be a list of tables, [[{0}]]", key));
        }
        for (const ConfigNode& item : node.items) {
            document(item, key, target.emplace_back());
        }
    }

    void refuse(const ConfigNode& node, const std::string& text) {
        if (!m_error) {
            m_error = Error{ErrorCode::InvalidInput, fmt::format("{}: {}", node.where(), text),
                            "the file is left as it is; open another project or mend this line"};
        }
    }

    const std::optional<Error>& error() const { return m_error; }

private:
    void document(const ConfigNode& node, const std::string& key, NamedDocument& target) {
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

    std::optional<Error> m_error;
};

void readKey(Reader& reader, const std::string& key, const ConfigNode& node, Project& project) {
    if (key == "device") {
        reader.text(node, key, project.device);
    } else if (key == "notes") {
        reader.text(node, key, project.notes);
    } else if (key == "perspective") {
        reader.text(node, key, project.perspective);
    } else if (key == "layout") {
        reader.layouts(node, project.layouts);
    } else if (key == "model") {
        reader.documents(node, key, project.models);
    } else if (key == "design") {
        reader.documents(node, key, project.designs);
    } else if (key != "schema") {
        reader.refuse(node,
                      fmt::format("unknown key '{}'; known are schema, device, notes, perspective, layout, "
                                  "model, design",
                                  key));
    }
}

Result<void> checkSchema(const ConfigNode& root, const std::string& place) {
    const ConfigNode* node = root.find("schema");
    const std::string schema = node != nullptr ? node->text : std::string();
    if (schema == Schema) {
        return {};
    }
    if (schema.rfind("halbench.project/", 0) == 0) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: is a '{}', made by a newer version", place, schema),
                       fmt::format("this version reads {}; the file is left as it is", Schema));
    }
    return failure(ErrorCode::InvalidInput, fmt::format("{}: is not a Halbench project", place),
                   fmt::format("a project begins with schema = \"{}\"", Schema));
}

} // namespace

std::string projectText(const Project& project) {
    toml::table layouts;
    for (const auto& [perspective, layout] : project.layouts) {
        layouts.insert(perspective, layout);
    }
    const toml::table table{{"schema", Schema},
                            {"device", project.device},
                            {"notes", project.notes},
                            {"perspective", project.perspective},
                            {"layout", layouts},
                            {"model", documents(project.models)},
                            {"design", documents(project.designs)}};
    std::ostringstream text;
    text << toml::toml_formatter(table, toml::toml_formatter::default_flags &
                                            ~toml::format_flags::allow_literal_strings)
         << '\n';
    return text.str();
}

Result<Project> parseProject(const std::string& text, const std::string& place) {
    const Result<ConfigNode> root = parseToml(text, place);
    if (!root) {
        return failure(root.error());
    }
    if (Result<void> known = checkSchema(*root, place); !known) {
        return failure(known.error());
    }
    Project project;
    Reader reader;
    for (const auto& [key, node] : root->members) {
        readKey(reader, key, node, project);
    }
    if (reader.error()) {
        return failure(*reader.error());
    }
    return project;
}

Result<void> saveProject(const Project& project, const std::string& path) {
    return writeFile(path, projectText(project));
}

Result<Project> loadProject(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseProject(*text, path);
}

std::string autosavePath(const std::string& projectPath) {
    return projectPath + ".autosave";
}

} // namespace halbench::app
