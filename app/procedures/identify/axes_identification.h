#pragma once

#include "app/procedures/base/axis_model.h"
#include "app/procedures/identify/identify_procedure.h"

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halbench::app {

/// A constant of the actuator with its interval, e.g. "force_constant_12".
struct NamedEstimate {
    std::string name;
    std::string title; ///< in words
    control::Estimate estimate;
};

/// `halbench.axis-model/1`: the axes for tuning, and what else was found of the actuator.
struct AxesIdentifyResult {
    AxisModel model;                      ///< of the axes that were asked for
    std::vector<NamedEstimate> constants; ///< absolute; they need one given constant
    std::vector<NamedEstimate> ratios;    ///< that need none
    DataQuality quality;
    double duration_s = 0.0;                       ///< device time that the excitation took
    std::optional<double> highestTemperature_degC; ///< of the coils, where the board reports it
    Recording recording;
    std::map<std::string, double> notes; ///< further diagnostics
};

/// Result of an identification: of the one axis of a motor, or of several.
using IdentifyOutcome = std::variant<IdentifyResult, AxesIdentifyResult>;

const DataQuality& qualityOf(const IdentifyOutcome& outcome);
const Recording& recordingOf(const IdentifyOutcome& outcome);

} // namespace halbench::app
