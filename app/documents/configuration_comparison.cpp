#include "app/documents/configuration_comparison.h"

#include "app/documents/result_header.h"
#include "control/base/unit_conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

Result<void> checkModel(const Configuration& file, const devices::DeviceInfo& device) {
    if (file.device.model == device.model) {
        return {};
    }
    return failure(
        ErrorCode::InvalidInput,
        fmt::format("the configuration is for a device of model '{}', this device is of model '{}'",
                    file.device.model, device.model),
        "nothing was written; use a file for this model");
}

/// A value as the device takes it: another unit would be a wrong number in the right place. Nothing where the
/// unit is of another quantity.
std::optional<double> inUnitOf(const ParameterSpec& spec, const ConfigurationValue& entry) {
    const auto conversion = conversionBetween(entry.unit, spec.unit);
    return conversion ? std::optional((*conversion)(entry.value)) : std::nullopt;
}

std::string reasonAgainst(const ParameterSpec& spec, const ConfigurationValue& entry) {
    if (!isSetting(spec)) {
        return "this value is a command or read-only on the device";
    }
    const std::optional<double> value = inUnitOf(spec, entry);
    if (!value) {
        return fmt::format("unit '{}' in the file, '{}' on the device", entry.unit, spec.unit);
    }
    if (const Result<void> checked = checkParameterValue(spec, *value); !checked) {
        return checked.error().message;
    }
    return {};
}

RowState stateOf(const ComparedRow& row) {
    if (!row.file) {
        return RowState::OnlyOnDevice;
    }
    if (!row.reason.empty()) {
        return RowState::Refused;
    }
    return row.device && isSameValue(*row.device, *row.file) ? RowState::Same : RowState::Differs;
}

ComparedRow rowOf(const ParameterSpec& spec, const Configuration& file,
                  const std::map<std::string, double>& values) {
    ComparedRow row;
    row.name = spec.name;
    row.unit = spec.unit;
    row.isCalibration = spec.isCalibration;
    row.defaultValue = spec.defaultValue;
    if (const auto value = values.find(spec.name); value != values.end()) {
        row.device = value->second;
    }
    if (const auto entry = file.values.find(spec.name); entry != file.values.end()) {
        row.file = inUnitOf(spec, entry->second).value_or(entry->second.value);
        row.isCalibration = row.isCalibration || entry->second.isCalibration;
        row.reason = reasonAgainst(spec, entry->second);
    }
    row.state = stateOf(row);
    return row;
}

std::vector<ComparedRow> rowsOf(const Configuration& file, const devices::Catalogue& catalogue,
                                const std::map<std::string, double>& values) {
    std::vector<ComparedRow> rows;
    for (const ParameterSpec& spec : catalogue.parameters) {
        if (isSetting(spec) || file.values.count(spec.name) > 0) {
            rows.push_back(rowOf(spec, file, values));
        }
    }
    for (const auto& [name, entry] : file.values) {
        if (catalogue.findParameter(name) == nullptr) {
            rows.push_back({name,
                            entry.unit,
                            entry.isCalibration,
                            {},
                            entry.value,
                            {},
                            RowState::OnlyInFile,
                            "not available on this device",
                            false});
        }
    }
    return rows;
}

std::vector<Finding> findingsOf(const Configuration& file, const devices::DeviceInfo& device,
                                const ConfigurationComparison& comparison) {
    std::vector<Finding> findings;
    if (!comparison.isSameDevice) {
        findings.push_back({"other_device",
                            fmt::format("the configuration was read from the device '{}', this one is '{}'",
                                        file.device.id, device.id),
                            "its calibration was measured on that device and is excluded unless selected"});
    }
    if (file.device.firmware != device.firmware) {
        findings.push_back(
            {"other_firmware",
             fmt::format("the configuration was read from firmware '{}', this device runs '{}'",
                         file.device.firmware, device.firmware),
             "check each row: a value may have another meaning in this firmware"});
    }
    return findings;
}

} // namespace

std::string_view rowStateName(RowState state) {
    switch (state) {
    case RowState::Same:
        return "same";
    case RowState::Differs:
        return "differs";
    case RowState::OnlyOnDevice:
        return "only_on_device";
    case RowState::OnlyInFile:
        return "only_in_file";
    case RowState::Refused:
        return "refused";
    }
    return "";
}

bool isSameValue(double one, double other) {
    return one == other || static_cast<float>(one) == static_cast<float>(other);
}

Result<ConfigurationComparison> compareConfiguration(const Configuration& file,
                                                     const devices::DeviceInfo& device,
                                                     const devices::Catalogue& catalogue,
                                                     const std::map<std::string, double>& values) {
    if (const Result<void> fits = checkModel(file, device); !fits) {
        return failure(fits.error());
    }
    ConfigurationComparison comparison;
    // Boards without an identity cannot be told apart.
    comparison.isSameDevice = isSameDevice(file.device, device) && !device.id.empty();
    comparison.rows = rowsOf(file, catalogue, values);
    for (ComparedRow& row : comparison.rows) {
        row.isProposed = row.state == RowState::Differs && (comparison.isSameDevice || !row.isCalibration);
    }
    comparison.findings = findingsOf(file, device, comparison);
    return comparison;
}

std::vector<std::string> proposedRows(const ConfigurationComparison& comparison, bool includeCalibration) {
    std::vector<std::string> names;
    for (const ComparedRow& row : comparison.rows) {
        if (row.isProposed || (includeCalibration && row.isCalibration && row.state == RowState::Differs)) {
            names.push_back(row.name);
        }
    }
    return names;
}

Result<std::vector<ParameterValue>> chosenValues(const ConfigurationComparison& comparison,
                                                 const std::vector<std::string>& names) {
    std::vector<ParameterValue> chosen;
    for (const std::string& name : names) {
        const auto row = std::find_if(comparison.rows.begin(), comparison.rows.end(),
                                      [&](const ComparedRow& each) { return each.name == name; });
        if (row == comparison.rows.end() || !row->file) {
            return failure(ErrorCode::Usage, fmt::format("the configuration has no value for '{}'", name),
                           "nothing was written; choose one of its rows");
        }
        if (!row->canBeRestored()) {
            return failure(ErrorCode::Usage, fmt::format("'{}' cannot be restored: {}", name, row->reason),
                           "nothing was written; leave it out");
        }
        chosen.push_back({name, *row->file});
    }
    return chosen;
}

Result<std::vector<RowOutcome>> restoreValues(devices::Device& device,
                                              const std::vector<ParameterValue>& values) {
    if (device.state().isArmed) {
        return failure(ErrorCode::DeviceRefused,
                       "a configuration cannot be restored while the actuator is armed",
                       "nothing was written; disarm first");
    }
    if (values.empty()) {
        return std::vector<RowOutcome>();
    }
    std::vector<std::string> names;
    names.reserve(values.size());
    for (const ParameterValue& value : values) {
        names.push_back(value.name);
    }
    const Result<void> written = device.writeParameters(values);
    const Result<std::vector<double>> now = device.readParameters(names); // whatever the writing said
    if (!now) {
        return failure(now.error());
    }
    std::vector<RowOutcome> outcomes;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool isRestored = isSameValue((*now)[i], values[i].value);
        const std::string reason = written ? "the value read back differs" : written.error().message;
        outcomes.push_back({names[i], isRestored, isRestored ? std::string() : reason});
    }
    return outcomes;
}

Result<std::map<std::string, double>> readSettings(devices::Device& device) {
    const std::vector<std::string> names = settingNames(device.catalogue());
    const Result<std::vector<double>> values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    std::map<std::string, double> settings;
    for (std::size_t i = 0; i < names.size(); ++i) {
        settings[names[i]] = (*values)[i];
    }
    return settings;
}

} // namespace halbench::app
