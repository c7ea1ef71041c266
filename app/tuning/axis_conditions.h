#pragma once

#include "app/documents/axis_loop_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/procedures/tune/tune_axes.h"
#include "devices/device.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// The surroundings of the loops of these axes of a model, from the shipped profile of its device: effort
/// limits, test steps, and the timing where the model does not say it. Errors: of the profile.
Result<AxisConditions> axisConditionsOf(const AxisModelFile& model, const std::vector<std::string>& axes);

/// The same from what a device says of itself: its delay, and its efforts in proportion to its current limit.
/// Errors: UnknownName (an axis that the device does not have), of the device.
Result<AxisConditions> axisConditionsOf(devices::Device& device, const std::vector<std::string>& axes);

/// The same from values that were read. Error: UnknownName.
Result<AxisConditions> axisConditionsOf(const devices::Catalogue& catalogue,
                                        const std::map<std::string, double>& values,
                                        const std::vector<std::string>& axes);

/// Laws and methods of a file for the loops of these axes. Errors: UnknownName, naming the axes of the file.
struct AxisLaws {
    std::vector<LoopLaw> laws;
    std::vector<std::string> methods;
    std::vector<control::LoopTiming> timings; ///< that they were found for
};
Result<AxisLaws> lawsOf(const AxisGainsFile& file, const std::vector<std::string>& axes);

} // namespace halbench::app
