#pragma once

#include "app/cli/loop_options.h"
#include "app/documents/model_file.h"
#include "app/documents/result_header.h"
#include "app/headless/command_context.h"
#include "app/procedures/tune/tune.h"

#include <memory>
#include <optional>
#include <string>

namespace halbench::app {

/// Start of `tune`: a model file, or a device that it identifies first and keeps open.
struct TuningSource {
    MotorEstimate estimate;
    ResultHeader header;
    LoopConditions conditions;
    std::optional<GainsFile> gains; ///< of --gains: judged instead of designed
    std::unique_ptr<devices::Device> device;
};

/// Errors: of the file, of its model's profile.
Result<TuningSource> sourceFromFile(const CommandContext& context, const std::string& path);
/// The motor of an open device with one axis, identified now; targets are judged before anything moves.
/// Errors: of the options, of the device, of the identification, of a target that this board cannot have.
Result<TuningSource> sourceFromDevice(CommandContext& context, const TuneOptions& options,
                                      const TuneConfig& wanted, std::unique_ptr<devices::Device> device);

} // namespace halbench::app
