#include "app/documents/configuration_file.h"

#include "app/documents/text/config_node.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"

#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>

namespace halbench::app {

namespace {

constexpr const char* Schema = "halbench.configuration/1";
constexpr const char* SchemaFamily = "halbench.configuration/";
constexpr const char* Remedy = "nothing was written; correct this line or use another file";

/// As TOML writes a text, whatever is in it.
std::string quoted(const std::string& text) {
    std::ostringstream stream;
    stream << toml::toml_formatter(toml::value<std::string>(text));
    return stream.str();
}

std::string deviceLines(const devices::DeviceInfo& device) {
    std::string text =
        fmt::format("\n[device]\nmodel = {}\nid = {}\nfirmware = {}\nsimulated = {}\n", quoted(device.model),
                    quoted(device.id), quoted(device.firmware), device.isSimulated);
    if (!device.overrides.empty()) {
        text += "\n[device.overrides]\n";
    }
    for (const auto& [key, value] : device.overrides) {
        text += fmt::format("{} = {}\n", quoted(key), quoted(value));
    }
    return text;
}

/// The shortest numbers that read back the same: this is a file for people, too.
std::string valueLines(const Configuration& configuration, bool isCalibration) {
    std::string text = fmt::format("\n[{}]\n", isCalibration ? "calibration" : "parameters");
    for (const auto& [name, entry] : configuration.values) {
        if (entry.isCalibration == isCalibration) {
            text += fmt::format("{} = {{ value = {}, unit = {} }}\n", quoted(name), formatNumber(entry.value),
                                quoted(entry.unit));
        }
    }
    return text;
}

/// Reads one part after the other; the first mistake stays.
class Reader {
public:
    void text(const ConfigNode& node, const std::string& key, std::string& target) {
        if (node.kind == ConfigNode::Kind::Text) {
            target = node.text;
        } else {
            refuse(node, fmt::format("'{}' must be a text", key));
        }
    }

    void schema(const ConfigNode& node) {
        std::string name;
        text(node, "schema", name);
        if (name == Schema || m_error) {
            return;
        }
        const bool isNewer = name.rfind(SchemaFamily, 0) == 0;
        refuse(node, isNewer ? fmt::format("'{}' was written by a newer Halbench", name)
                             : fmt::format("'{}' is not a configuration; expected '{}'", name, Schema));
    }

    void device(const ConfigNode& node, devices::DeviceInfo& device) {
        for (const auto& [key, value] : membersOf(node, "device")) {
            if (key == "model") {
                text(value, key, device.model);
            } else if (key == "id") {
                text(value, key, device.id);
            } else if (key == "firmware") {
                text(value, key, device.firmware);
            } else if (key == "simulated" && value.kind == ConfigNode::Kind::Boolean) {
                device.isSimulated = value.boolean;
            } else if (key == "overrides") {
                overrides(value, device);
            } else {
                refuse(value, fmt::format("'device.{}' is not allowed here", key));
            }
        }
    }

    void values(const ConfigNode& node, const std::string& table, Configuration& configuration) {
        for (const auto& [name, value] : membersOf(node, table)) {
            ConfigurationValue entry;
            entry.isCalibration = table == "calibration";
            row(value, name, entry);
            if (!configuration.values.emplace(name, entry).second) {
                refuse(value, fmt::format("'{}' occurs twice", name));
            }
        }
    }

    void refuse(const ConfigNode& node, const std::string& text) {
        if (!m_error) {
            m_error = Error{ErrorCode::InvalidInput, fmt::format("{}: {}", node.where(), text), Remedy};
        }
    }

    const std::optional<Error>& error() const { return m_error; }

private:
    const std::vector<ConfigNode::Member>& membersOf(const ConfigNode& node, const std::string& table) {
        if (node.kind != ConfigNode::Kind::Table) {
            refuse(node, fmt::format("'{0}' must be a table, [{0}]", table));
        }
        return node.members;
    }

    void overrides(const ConfigNode& node, devices::DeviceInfo& device) {
        for (const auto& [key, value] : membersOf(node, "device.overrides")) {
            device.overrides.emplace_back(key, std::string());
            text(value, key, device.overrides.back().second);
        }
        std::sort(device.overrides.begin(), device.overrides.end());
    }

    void row(const ConfigNode& node, const std::string& name, ConfigurationValue& entry) {
        bool hasValue = false;
        for (const auto& [key, value] : membersOf(node, name)) {
            if (key == "value") {
                hasValue = true;
                number(value, name, entry.value);
            } else if (key == "unit") {
                text(value, name + ".unit", entry.unit);
            } else {
                refuse(value, fmt::format("'{}' of '{}' is unknown; a row has value and unit", key, name));
            }
        }
        if (!hasValue) {
            refuse(node, fmt::format("'{}' has no value", name));
        }
    }

    void number(const ConfigNode& node, const std::string& name, double& target) {
        const bool isNumber = node.kind == ConfigNode::Kind::Number || node.kind == ConfigNode::Kind::Integer;
        if (!isNumber || !std::isfinite(node.number)) {
            refuse(node, fmt::format("the value of '{}' must be a finite number", name));
            return;
        }
        target = node.number;
    }

    std::optional<Error> m_error;
};

/// What may stand in a file name everywhere.
std::string inFileName(std::string text) {
    for (char& letter : text) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-';
        letter = isPlain ? letter : '_';
    }
    return text.empty() ? "unnamed" : text;
}

} // namespace

bool isSetting(const ParameterSpec& spec) {
    static constexpr std::array Orders = {"hb", "reference", "plateau", "capture"};
    return spec.access == ParameterAccess::ReadWrite &&
           std::none_of(Orders.begin(), Orders.end(), [&](const char* group) { return spec.group == group; });
}

std::vector<std::string> settingNames(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : catalogue.parameters) {
        if (isSetting(spec)) {
            names.push_back(spec.name);
        }
    }
    return names;
}

Configuration configurationOf(const devices::DeviceInfo& device, const devices::Catalogue& catalogue,
                              const std::map<std::string, double>& values, const std::string& written) {
    Configuration configuration;
    configuration.device.model = device.model;
    configuration.device.id = device.id;
    configuration.device.firmware = device.firmware;
    configuration.device.isSimulated = device.isSimulated;
    configuration.device.overrides = device.overrides;
    configuration.written = written;
    for (const auto& [name, value] : values) {
        const ParameterSpec* spec = catalogue.findParameter(name);
        if (spec != nullptr && isSetting(*spec)) {
            configuration.values[name] = {value, spec->unit, spec->isCalibration};
        }
    }
    return configuration;
}

std::string configurationText(const Configuration& configuration) {
    return fmt::format("schema = {}\nwritten = {}\n", quoted(Schema), quoted(configuration.written)) +
           deviceLines(configuration.device) + valueLines(configuration, false) +
           valueLines(configuration, true);
}

Result<Configuration> parseConfiguration(const std::string& text, const std::string& origin) {
    const Result<ConfigNode> root = parseToml(text, origin);
    if (!root) {
        return failure(root.error());
    }
    Reader reader;
    const ConfigNode* schema = root->find("schema");
    if (schema == nullptr) {
        reader.refuse(*root, fmt::format("there is no schema = \"{}\"", Schema));
    } else {
        reader.schema(*schema);
    }
    Configuration configuration;
    for (const auto& [key, node] : root->members) {
        if (key == "written") {
            reader.text(node, key, configuration.written);
        } else if (key == "device") {
            reader.device(node, configuration.device);
        } else if (key == "parameters" || key == "calibration") {
            reader.values(node, key, configuration);
        } else if (key != "schema") {
            reader.refuse(node, fmt::format("unknown key '{}'", key));
        }
    }
    if (reader.error()) {
        return failure(*reader.error());
    }
    return configuration;
}

Result<Configuration> readConfiguration(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseConfiguration(*text, path);
}

Result<std::string> backUpConfiguration(const Configuration& configuration, const std::string& folder) {
    const std::string stem = fmt::format("{}/{}/{}", folder, inFileName(configuration.device.id),
                                         inFileName(configuration.written));
    std::string path = stem + ".toml";
    for (int copy = 2; QFileInfo::exists(QString::fromStdString(path)); ++copy) {
        path = fmt::format("{}-{}.toml", stem, copy); // two in one second
    }
    if (const Result<void> written = writeFile(path, configurationText(configuration)); !written) {
        return failure(written.error());
    }
    return path;
}

std::string backupFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() +
           "/halbench/backups";
}

} // namespace halbench::app
