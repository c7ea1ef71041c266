#include "app/window/project/project_file.h"

#include "app/documents/text/config_node.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/window/docks/perspective.h"
#include "app/window/project/project_monitor.h"
#include "app/window/project/project_plots.h"
#include "app/window/project/project_reader.h"
#include "app/window/project/project_recording.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

namespace halbench::app {

namespace {

using Reader = ProjectReader;

constexpr const char* Schema = "halbench.project/1";

toml::array documents(const std::vector<NamedDocument>& list) {
    toml::array array;
    for (const NamedDocument& entry : list) {
        array.push_back(
            toml::table{{"name", projectValue(entry.name)}, {"document", projectValue(entry.document)}});
    }
    return array;
}

void readGiven(Reader& reader, const ConfigNode& node, std::map<std::string, double>& given) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'given' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        control::GivenConstants checked;
        const double constant = reader.number(value, "given." + key);
        if (const Result<void> set = setGivenConstant(checked, key, constant); !set) {
            reader.refuse(value, "given: " + set.error().message);
        }
        given[key] = constant;
    }
}

bool isFurtherMonitor(const std::string& key) {
    return std::find(std::begin(FurtherMonitors), std::end(FurtherMonitors), key) !=
           std::end(FurtherMonitors);
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
    } else if (isFurtherMonitor(key)) {
        readFurtherMonitor(reader, node, project.furtherMonitors[key]);
    } else if (key == "recording") {
        readRecording(reader, node, project.recording);
    } else if (key == "plot") {
        readPlots(reader, node, project.monitor.plots);
    } else if (key == "cursors") {
        readCursors(reader, node, project.monitor.cursors);
    } else if (key == "derived") {
        readDerived(reader, node, project.monitor.derived);
    } else if (key != "schema") {
        reader.refuse(node,
                      fmt::format("unknown key '{}'; known are schema, device, notes, perspective, layout, "
                                  "monitor, monitor2, monitor3, recording, plot, cursors, derived, given, "
                                  "model, design, calibration",
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
                       fmt::format("{}: is a '{}' of a newer version", place, schema),
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
    arranged.resets = one.resets; // of a file that is not written
    return one == arranged;
}

std::string projectText(const Project& project) {
    toml::table layouts;
    for (const auto& [perspective, layout] : project.layouts) {
        layouts.insert(perspective, projectValue(layout));
    }
    toml::table given;
    for (const auto& [symbol, value] : project.given) {
        given.insert(symbol, value);
    }
    toml::table table{{"schema", Schema},
                      {"device", projectValue(project.device)},
                      {"notes", projectValue(project.notes)},
                      {"perspective", projectValue(project.perspective)},
                      {"layout", layouts},
                      {"monitor", projectMonitor(project.monitor)},
                      {"plot", projectPlots(project.monitor.plots)},
                      {"given", given},
                      {"model", documents(project.models)},
                      {"design", documents(project.designs)},
                      {"calibration", documents(project.calibrations)}};
    for (const auto& [panel, view] : project.furtherMonitors) { // likewise
        table.insert(panel, projectFurtherMonitor(view));
    }
    if (!project.monitor.derived.empty()) { // an older version does not know the key
        table.insert("derived", projectDerived(project.monitor.derived));
    }
    if (!project.monitor.cursors.empty()) {
        table.insert("cursors", projectCursors(project.monitor.cursors));
    }
    if (project.recording != RecordingChoice{}) { // likewise
        table.insert("recording", projectRecording(project.recording));
    }
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
    project.resets = reader.resets();
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
