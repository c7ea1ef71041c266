#include "app/headless/analysis_device.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

Result<std::vector<ParameterValue>> deviceValuesFor(const Analysis& analysis, devices::Device& device) {
    if (!analysis.device) {
        return failure(ErrorCode::Usage, fmt::format("{} takes no device", analysis.name),
                       "leave the device out");
    }
    const std::vector<std::string>& names = analysis.device->parameters;
    for (const std::string& name : names) {
        if (device.catalogue().findParameter(name) == nullptr) {
            return failure(ErrorCode::UnknownName,
                           fmt::format("'{}' has no parameter '{}', which {} reads", device.info().uri, name,
                                       analysis.name),
                           std::string(analysis.device->hint));
        }
    }
    const auto read = device.readParameters(names);
    if (!read) {
        return failure(read.error());
    }
    std::vector<ParameterValue> values;
    for (std::size_t i = 0; i < names.size(); ++i) {
        values.push_back({names[i], (*read)[i]});
    }
    return values;
}

std::optional<std::vector<ParameterValue>> notedValues(const Analysis& analysis,
                                                       const devices::RecordingMeta& meta) {
    std::vector<ParameterValue> values;
    const std::vector<std::string> names =
        analysis.device ? analysis.device->parameters : std::vector<std::string>();
    for (const devices::RecordingMeta::ParameterNote& note : meta.parameters) {
        if (std::find(names.begin(), names.end(), note.name) != names.end()) {
            values.push_back({note.name, note.value});
        }
    }
    return values.empty() ? std::nullopt : std::optional(values);
}

std::vector<std::string> deviceSignalsFor(const Analysis& analysis, const AnalysisValues& values,
                                          const devices::Catalogue& catalogue) {
    std::vector<std::string> signals = analysis.device->signals(values);
    std::copy_if(analysis.device->extraSignals.begin(), analysis.device->extraSignals.end(),
                 std::back_inserter(signals),
                 [&catalogue](const std::string& name) { return catalogue.findSignal(name) != nullptr; });
    return signals;
}

} // namespace halbench::app
