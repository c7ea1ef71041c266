#pragma once

#include "app/documents/configuration_file.h"
#include "app/procedures/base/procedure.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

enum class RowState { Same, Differs, OnlyOnDevice, OnlyInFile, Refused };
/// "same", "differs", "only_on_device", "only_in_file", "refused"
std::string_view rowStateName(RowState state);

struct ComparedRow {
    std::string name;
    std::string unit;
    bool isCalibration = false;
    std::optional<double> device;
    std::optional<double> file;
    std::optional<double> defaultValue;
    RowState state = RowState::Same;
    std::string reason;      ///< why it cannot be restored; empty otherwise
    bool isProposed = false; ///< restoring it needs no second thought

    bool canBeRestored() const { return state == RowState::Same || state == RowState::Differs; }
};

/// A configuration file beside a device, row by row: first in the board's order, then what only the file has.
struct ConfigurationComparison {
    bool isSameDevice = false; ///< the file was read from this very device
    std::vector<ComparedRow> rows;
    std::vector<Finding> findings;
};

/// Whether the board would run with the same number: boards of this family keep 32-bit floats.
bool isSameValue(double one, double other);

/// `values`: what the device now has, by name. Calibration values are proposed for the device they were
/// measured on only. Errors: InvalidInput for a file of another model.
Result<ConfigurationComparison> compareConfiguration(const Configuration& file,
                                                     const devices::DeviceInfo& device,
                                                     const devices::Catalogue& catalogue,
                                                     const std::map<std::string, double>& values);

/// Names of the rows that are proposed; with `includeCalibration` also the calibration of another device.
std::vector<std::string> proposedRows(const ConfigurationComparison& comparison, bool includeCalibration);

/// The values of the file that the named rows take. Errors: Usage for a row that the file cannot restore.
Result<std::vector<ParameterValue>> chosenValues(const ConfigurationComparison& comparison,
                                                 const std::vector<std::string>& names);

struct RowOutcome {
    std::string name;
    bool isRestored = false; ///< read back from the device
    std::string reason;      ///< why not
};

/// Writes the values as one transaction and says what became of each, as read back. Nothing is stored in
/// non-volatile memory. Errors: DeviceRefused while armed; DeviceLost when it could not be read back any
/// more.
Result<std::vector<RowOutcome>> restoreValues(devices::Device& device,
                                              const std::vector<ParameterValue>& values);

/// Values of all settings of a device, by name.
Result<std::map<std::string, double>> readSettings(devices::Device& device);

} // namespace halbench::app
