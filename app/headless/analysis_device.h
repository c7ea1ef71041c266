#pragma once

#include "app/analyses/analysis.h"
#include "devices/device.h"
#include "devices/recording/recording_meta.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The values of a device that stand for settings of an analysis which are not given. Errors: Usage (the
/// analysis takes no device), UnknownName (a device of another kind), of the device.
Result<std::vector<ParameterValue>> deviceValuesFor(const Analysis& analysis, devices::Device& device);

/// The same as a recording notes them; nothing when it notes none of them.
std::optional<std::vector<ParameterValue>> notedValues(const Analysis& analysis,
                                                       const devices::RecordingMeta& meta);

/// The signals that an analysis wants recorded of this device.
std::vector<std::string> deviceSignalsFor(const Analysis& analysis, const AnalysisValues& values,
                                          const devices::Catalogue& catalogue);

} // namespace halbench::app
