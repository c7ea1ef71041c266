#pragma once

#include "app/cli/loop_options.h"
#include "app/documents/axis_model_file.h"
#include "app/headless/command_context.h"

#include <memory>
#include <optional>
#include <string>

namespace halbench::app {

/// `tune` and `analyse` of a model of several axes; the commands decide by the file. `identified`: the
/// device, still open, that the model was identified on just now; --apply takes it when it names the same.
CommandResult tuneAxesOf(CommandContext& context, const TuneOptions& options, const AxisModelFile& model,
                         std::unique_ptr<devices::Device> identified = {});
/// `tune` of an open device with several axes: it is identified first.
CommandResult tuneAxesOfDevice(CommandContext& context, const TuneOptions& options,
                               std::unique_ptr<devices::Device> device);
CommandResult analyseAxesOf(CommandContext& context, const AnalyseOptions& options,
                            const AxisModelFile& model);

/// The model of several axes in a file; nothing for any other file, which its own reader judges. Errors: of
/// parseAxisModel.
Result<std::optional<AxisModelFile>> axisModelIn(const std::string& path);

/// --axis belongs to a model of several axes. Error: Usage.
Result<void> refuseAxis(const std::string& axis);

} // namespace halbench::app
