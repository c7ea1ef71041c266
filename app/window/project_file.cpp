#include "app/window/project_file.h"

#include "app/batch/config_node.h"
#include "app/batch/output_file.h"
#include "app/procedures/identify_procedure.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <optional>
#include <sstream>

namespace halbench::app {

namespace {

constexpr const char* Schema = "halbench.project/1";

/// As a value: TOML drops a line break right behind the opening quotes of a text of several lines.
std::string valueOf(const std::string& text) {
    return text.rfind('\n', 0) == 0 ? '\n' + text : text;
}

toml::array documents(const std::vector<NamedDocument>& list) {
    toml::array array;
    for (const NamedDocument& entry : list) {
        array.push_back(toml::table{{"name", valueOf(entry.name)}, {"document", valueOf(entry.document)}});
    }
    return array;
}

toml::array plots(const std::vector<PlotChoice>& list) {
    toml::array array;
    for (const PlotChoice& plot : list) {
        toml::array names;
        for (const std::string& name : plot.signalNames) {
            names.push_back(valueOf(name));
        }
        toml::table table{{"signals", names}};
        if (plot.range) {
            table.insert("min", plot.range->low);
            table.insert("max", plot.range->high);
            table.insert("unit", valueOf(plot.unit));
        }
        array.push_back(table);
    }
    return array;
}

toml::table monitor(const MonitorView& view) {
    toml::table table{{"follow", view.isFollowing}};
    if (view.span_s) {
        table.insert("span_s", *view.span_s);
    }
    return table;
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

double number(Reader& reader, const ConfigNode& node, const std::string& key) {
    const bool isNumber = node.kind == ConfigNode::Kind::Number || node.kind == ConfigNode::Kind::Integer;
    if (!isNumber || !std::isfinite(node.number)) {
        reader.refuse(node, fmt::format("'{}' must be a finite number", key));
        return 0.0;
    }
    return node.number;
}

void readSignals(Reader& reader, const ConfigNode& node, std::vector<std::string>& target) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, "'signals' must be a list of texts");
    }
    for (const ConfigNode& item : node.items) {
        reader.text(item, "signals", target.emplace_back());
    }
}

void readPlot(Reader& reader, const ConfigNode& node, PlotChoice& plot) {
    widgets::ValueRange range;
    int ends = 0;
    for (const auto& [key, value] : node.members) {
        if (key == "signals") {
            readSignals(reader, value, plot.signalNames);
        } else if (key == "unit") {
            reader.text(value, key, plot.unit);
        } else if (key == "min" || key == "max") {
            (key == "min" ? range.low : range.high) = number(reader, value, key);
            ++ends;
        } else {
            reader.refuse(value,
                          fmt::format("unknown key '{}'; a [[plot]] has signals, min, max, unit", key));
        }
    }
    if (ends == 1 || (ends == 2 && !(range.low < range.high))) {
        reader.refuse(node, "a [[plot]] has both min and max, or neither; min is less than max");
    }
    plot.range = ends == 2 ? std::optional(range) : std::nullopt;
}

void readPlots(Reader& reader, const ConfigNode& node, std::vector<PlotChoice>& plots) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, "'plot' must be a list of tables, [[plot]]");
    }
    for (const ConfigNode& item : node.items) {
        if (item.kind != ConfigNode::Kind::Table) {
            reader.refuse(item, "'plot' must be a list of tables, [[plot]]");
        }
        readPlot(reader, item, plots.emplace_back());
    }
}

void readMonitor(Reader& reader, const ConfigNode& node, MonitorView& view) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'monitor' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        if (key == "follow" && value.kind == ConfigNode::Kind::Boolean) {
            view.isFollowing = value.boolean;
        } else if (key == "span_s") {
            view.span_s = number(reader, value, key);
        } else {
            reader.refuse(value, "[monitor] has follow (true or false) and span_s");
        }
    }
    if (view.span_s && *view.span_s <= 0.0) {
        reader.refuse(node, "'span_s' must be more than 0");
    }
}

void readGiven(Reader& reader, const ConfigNode& node, std::map<std::string, double>& given) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'given' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        control::GivenConstants checked;
        const double constant = number(reader, value, "given." + key);
        if (const Result<void> set = setGivenConstant(checked, key, constant); !set) {
            reader.refuse(value, "given: " + set.error().message);
        }
        given[key] = constant;
    }
}

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
    } else if (key == "calibration") {
        reader.documents(node, key, project.calibrations);
    } else if (key == "given") {
        readGiven(reader, node, project.given);
    } else if (key == "monitor") {
        readMonitor(reader, node, project.monitor);
    } else if (key == "plot") {
        readPlots(reader, node, project.monitor.plots);
    } else if (key != "schema") {
        reader.refuse(node,
                      fmt::format("unknown key '{}'; known are schema, device, notes, perspective, layout, "
                                  "monitor, plot, given, model, design, calibration",
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

bool isSameWork(const Project& one, const Project& other) {
    Project arranged = other;
    arranged.perspective = one.perspective;
    arranged.layouts = one.layouts;
    return one == arranged;
}

std::string projectText(const Project& project) {
    toml::table layouts;
    for (const auto& [perspective, layout] : project.layouts) {
        layouts.insert(perspective, valueOf(layout));
    }
    toml::table given;
    for (const auto& [symbol, value] : project.given) {
        given.insert(symbol, value);
    }
    const toml::table table{{"schema", Schema},
                            {"device", valueOf(project.device)},
                            {"notes", valueOf(project.notes)},
                            {"perspective", valueOf(project.perspective)},
                            {"layout", layouts},
                            {"monitor", monitor(project.monitor)},
                            {"plot", plots(project.monitor.plots)},
                            {"given", given},
                            {"model", documents(project.models)},
                            {"design", documents(project.designs)},
                            {"calibration", documents(project.calibrations)}};
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
