#pragma once

#include "app/cli/identify_options.h"
#include "app/headless/command_context.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_procedure.h"

#include <initializer_list>
#include <string>

namespace halbench::app {

/// `identify` has two kinds of options: those of the sweep and those of --frequency. Errors: Usage, naming
/// one that belongs to the other kind.
Result<void> checkFrequencyOptions(const IdentifyOptions& options);

/// Errors: Usage, UnknownName, NotFinite, naming the option. Ranges are the procedure's.
Result<FrequencyConfig> frequencyConfigFrom(const IdentifyOptions& options);

/// The same of a device with several axes. Error: Usage of an option that only a motor has.
Result<AxesFrequencyConfig> axesFrequencyConfigFrom(const IdentifyOptions& options);

/// One option that is a number and may be left out.
struct NumberOption {
    const char* option;
    const std::string& text;
    double& value;
};
/// Errors: Usage, NotFinite, naming the option.
Result<void> takeNumbers(std::initializer_list<NumberOption> numbers);
/// Error: Usage.
Result<int> wholePeriods(double periods, const std::string& text);

/// Writes the recording (--record) and the table of the response (--bode) where they are asked for. Errors:
/// of the files, naming them.
Result<void> writeResponseFiles(const IdentifyOptions& options, const Recording& recording,
                                const std::string& table, devices::Device& device,
                                const std::string& started);

/// identify DEVICE --frequency
CommandResult runFrequencyCommand(CommandContext& context, const IdentifyOptions& options);
/// The same on an open device with several axes.
CommandResult runAxesFrequencyCommand(CommandContext& context, const IdentifyOptions& options,
                                      devices::Device& device);

} // namespace halbench::app
