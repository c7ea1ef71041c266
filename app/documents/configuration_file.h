#pragma once

#include "control/base/parameter_spec.h"
#include "devices/device.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

struct ConfigurationValue {
    double value = 0.0;
    std::string unit;
    bool isCalibration = false; ///< measured on that one device

    bool operator==(const ConfigurationValue&) const = default;
};

/// `halbench.configuration/1`: the settings of one device, to compare and to restore
/// (resources/help/command-line.md, "Configuration files").
struct Configuration {
    devices::DeviceInfo device; ///< model, id, firmware, overrides: what it was read from
    std::string written;        ///< ISO 8601, UTC
    std::map<std::string, ConfigurationValue> values;
};

/// A value that stays: not an order to the board (arm, reference, capture) and not read only.
bool isSetting(const ParameterSpec& spec);
/// Names of all settings of a board, in its order.
std::vector<std::string> settingNames(const devices::Catalogue& catalogue);

/// `values` by name; one that the catalogue does not have as a setting is left out.
Configuration configurationOf(const devices::DeviceInfo& device, const devices::Catalogue& catalogue,
                              const std::map<std::string, double>& values, const std::string& written);

/// Equal configurations give equal text, names sorted, one a line.
std::string configurationText(const Configuration& configuration);
/// `origin` names the text in messages. Errors: InvalidInput with line and column for a text that is none,
/// comes from a newer version, has an unknown key, a name twice or a value that is no finite number.
Result<Configuration> parseConfiguration(const std::string& text, const std::string& origin);
/// Errors: FileSystem, InvalidInput.
Result<Configuration> readConfiguration(const std::string& path);

/// Keeps a copy as `<folder>/<id>/<time>.toml`, never over another one. Gives the path. Errors: FileSystem.
Result<std::string> backUpConfiguration(const Configuration& configuration, const std::string& folder);
/// Folder of those copies.
std::string backupFolder();

} // namespace halbench::app
