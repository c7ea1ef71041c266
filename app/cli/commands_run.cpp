#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/text/output_file.h"
#include "app/experiments/experiment_runner.h"
#include "app/experiments/run_files.h"
#include "app/experiments/run_plan.h"
#include "app/experiments/step_configs.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"
#include "app/headless/reconnecting_device.h"

#include <algorithm>
#include <filesystem>

namespace halbench::app {

namespace {

struct RunOptions {
    std::string experiment;
    std::string deviceOverride; ///< --device
    std::vector<std::string> assignments;
    bool isDryRun = false;
    std::string out;
};

Result<Experiment> readExperiment(const RunOptions& options) {
    const Result<std::string> text = readFile(options.experiment);
    if (!text) {
        return failure(text.error());
    }
    const std::string origin = std::filesystem::path(options.experiment).filename().string();
    Result<Experiment> experiment = parseExperiment(*text, origin, options.assignments);
    if (experiment && !options.deviceOverride.empty()) {
        experiment->device = options.deviceOverride;
    }
    if (experiment && experiment->device.empty()) {
        return failure(ErrorCode::InvalidInput, origin + ": names no device",
                       "add device = \"sim:htm\" or give --device");
    }
    return experiment;
}

bool needsConsent(const Experiment& experiment) {
    for (const ExperimentStep& step : experiment.steps) {
        if (step.kind == "identify" || step.kind == "frequency" || step.kind == "relay" ||
            step.kind == "calibrate" || step.kind == "move" || step.kind == "apply") {
            return true;
        }
    }
    return false;
}

CommandResult showPlan(CommandContext& context, const Experiment& experiment, devices::Device& device) {
    const Result<RunPlan> plan = planRun(experiment, device);
    if (!plan) {
        return failure(plan.error());
    }
    context.console.print(planText(*plan));
    const Result<void> printed =
        context.console.printDocument(planDocument(headerFor(context, "halbench.plan/1", device), *plan));
    if (!printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

/// A run that a device, a limit or a file that could not be written ended is still told in files; one that
/// the user or a bad input ended is not.
bool isTold(const std::optional<Error>& error) {
    if (!error || error->code == ErrorCode::FileSystem) {
        return true;
    }
    const ExitCode code = exitCodeFor(error->code);
    return code == ExitCode::CheckFailed || code == ExitCode::DeviceFailed || code == ExitCode::SafetyStop;
}

/// A device or limit that ended the run matters more than the files that it then left incomplete.
Error withCause(const Error& files, const std::optional<Error>& stoppedBy) {
    if (!stoppedBy) {
        return files;
    }
    return {stoppedBy->code, stoppedBy->message + "; " + files.message, stoppedBy->hint + "; " + files.hint};
}

CommandResult runAll(CommandContext& context, const RunOptions& options, const Experiment& experiment,
                     devices::Device& device) {
    const ResultHeader opened = headerFor(context, "halbench.run/1", device);
    const RunOutcome outcome = runExperiment(context, device, experiment, opened.seed, options.out);
    if (!isTold(outcome.stoppedBy)) {
        return failure(*outcome.stoppedBy);
    }
    ResultHeader header = opened;
    addQuality(header.quality, runQuality(outcome)); // to what is known of the device
    const Result<void> written = writeRunFiles(options.out, header, experiment, outcome, device);
    if (!written) {
        return failure(withCause(written.error(), outcome.stoppedBy));
    }
    if (outcome.stoppedBy && exitCodeFor(outcome.stoppedBy->code) != ExitCode::CheckFailed) {
        return failure(*outcome.stoppedBy);
    }
    if (outcome.stoppedBy) {
        context.console.log(LogLevel::Error, errorLine(*outcome.stoppedBy));
    }
    context.console.print(runText(outcome));
    if (const Result<void> printed = context.console.printDocument(runDocument(header, experiment, outcome));
        !printed) {
        return failure(printed.error());
    }
    return outcome.passed ? ExitCode::Done : ExitCode::CheckFailed;
}

/// Only a recording that asks for it goes on after the device was lost; every other step ends with it.
Result<std::unique_ptr<devices::Device>> openFor(CommandContext& context, const Experiment& experiment,
                                                 bool isDryRun) {
    Result<std::unique_ptr<devices::Device>> device = needsConsent(experiment) && !isDryRun
                                                          ? openToMove(context, experiment.device)
                                                          : openDeviceFor(context, experiment.device);
    const bool isWaiting = std::any_of(experiment.steps.begin(), experiment.steps.end(), isWaitingStep);
    if (!device || !isWaiting) {
        return device;
    }
    auto waiting = reconnectingDevice(context, experiment.device, *std::move(device));
    waiting->setWaiting(false);
    return waiting;
}

/// The files that the steps read and that of the device.
Result<void> checkKeepsInputsOf(const Experiment& experiment, const std::string& folder) {
    std::vector<std::string> named{experiment.device};
    for (const ExperimentStep& step : experiment.steps) {
        for (const auto& [key, value] : step.keys.members) {
            named.push_back(value.text); // a model, a placement, a calibration
        }
        named.push_back(step.text("reference.file").value_or("")); // a table of poses
    }
    CommandOutputs outputs{{}, {}, folder};
    outputs.inputs = namedInputs(outputs, std::move(named));
    return checkKeepsInputs(outputs);
}

CommandResult runRunCommand(CommandContext& context, const RunOptions& options) {
    const Result<Experiment> experiment = readExperiment(options);
    if (!experiment) {
        return failure(experiment.error());
    }
    if (!options.isDryRun && options.out.empty()) {
        return failure(ErrorCode::Usage, "--out is required", "name the folder that the results go into");
    }
    if (const Result<void> kept =
            options.isDryRun ? Result<void>() : checkKeepsInputsOf(*experiment, options.out);
        !kept) {
        return failure(kept.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openFor(context, *experiment, options.isDryRun);
    if (!device) {
        return failure(device.error());
    }
    Result<void> ready = checkAgainstDevice(*experiment, **device);
    if (ready && options.isDryRun) {
        return showPlan(context, *experiment, **device);
    }
    ready = ready ? createFolder(options.out) : ready;
    if (!ready) {
        return failure(ready.error());
    }
    return runAll(context, options, *experiment, **device);
}

void addOptions(CommandSyntax& syntax, RunOptions& options) {
    syntax.argument("EXPERIMENT.toml", options.experiment, "Experiment");
    syntax.option("--device", options.deviceOverride, "Device instead of the file's", "DEVICE");
    syntax.repeatable("--set", options.assignments,
                      "Change a value, e.g. step.sweep.given.J=6e-4; repeatable", "KEY=VALUE");
    syntax.flag("--dry-run", options.isDryRun, "Validate and predict, move nothing");
    syntax.option("--out", options.out, "Folder of the results", "DIR");
}

CommandOutputs outputsOf(const RunOptions& options) {
    return {{}, {}, options.isDryRun ? std::string() : options.out};
}

} // namespace

Command runCommand() {
    return makeCommand<RunOptions>("run", "Run an experiment file and judge its checks",
                                   {addOptions, runRunCommand, outputsOf});
}

} // namespace halbench::app
