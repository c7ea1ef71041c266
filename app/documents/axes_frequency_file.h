#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/base/axis_model.h"
#include "app/procedures/frequency/measured_loop.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Plant of one axis while the loops of the others were closed, as RESPONSE.json has it.
struct AxisPlantFile {
    std::string axis, positionUnit, effortUnit;
    MeasuredPlant plant;
};

/// Measured plants and header of a RESPONSE.json of several axes (halbench.axis-frequency/1).
struct AxesFrequencyFile {
    ResultHeader header;
    std::vector<AxisPlantFile> axes;
};

/// Errors: FileSystem; InvalidInput with the place (also for the response of a motor); Refused for a result
/// that was refused.
Result<AxesFrequencyFile> readAxesFrequencyFile(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<AxesFrequencyFile> parseAxesFrequency(const std::string& text, const std::string& origin);

/// The plants for the axes of a model that were measured. Errors: InvalidInput (none of its axes, another
/// unit of position or effort).
Result<std::map<std::string, MeasuredPlant>> plantsFor(const AxisModel& model, const AxesFrequencyFile& file);

} // namespace halbench::app
