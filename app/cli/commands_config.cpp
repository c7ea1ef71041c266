#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/comparison_documents.h"
#include "app/documents/text/names.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

struct ConfigOptions {
    std::string what; ///< save, compare or restore
    std::string device;
    std::string input; ///< FILE
    std::string only;  ///< rows, separated by commas
    bool withCalibration = false;
    bool isSaved = false;
};

CommandResult save(CommandContext& context, devices::Device& device, const std::string& path) {
    const Result<std::map<std::string, double>> values = readSettings(device);
    if (!values) {
        return failure(values.error());
    }
    const ResultHeader header = headerFor(context, "halbench.values/1", device);
    const Configuration configuration =
        configurationOf(device.info(), device.catalogue(), *values, header.started);
    if (const Result<void> written = writeFile(path, configurationText(configuration)); !written) {
        return failure(written.error());
    }
    JsonValue list = JsonValue::array();
    for (const auto& [name, entry] : configuration.values) {
        list.push(JsonValue::object().set("name", name).set("value", entry.value).set("unit", entry.unit));
    }
    context.console.print(
        fmt::format("{} values of '{}' saved\n", configuration.values.size(), device.info().id));
    if (const Result<void> printed = context.console.printDocument(toJson(header).set("values", list));
        !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

struct Question {
    Configuration file;
    ConfigurationComparison comparison;
    std::map<std::string, double> values;
};

Result<Question> ask(devices::Device& device, const std::string& path) {
    Result<Configuration> file = readConfiguration(path);
    if (!file) {
        return failure(file.error());
    }
    Result<std::map<std::string, double>> values = readSettings(device);
    if (!values) {
        return failure(values.error());
    }
    Result<ConfigurationComparison> comparison =
        compareConfiguration(*file, device.info(), device.catalogue(), *values);
    if (!comparison) {
        return failure(comparison.error());
    }
    return Question{*std::move(file), *std::move(comparison), *std::move(values)};
}

CommandResult answer(CommandContext& context, const devices::Device& device, const Question& question,
                     const std::vector<RowOutcome>& outcomes, bool isGood) {
    context.console.print(comparisonText(question.comparison, outcomes));
    const JsonValue document = comparisonDocument(headerFor(context, "halbench.comparison/1", device),
                                                  question.file, question.comparison, outcomes);
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return isGood ? ExitCode::Done : ExitCode::CheckFailed;
}

/// A row that only the device has is no difference: a file may hold a few values on purpose.
bool isAllSame(const ConfigurationComparison& comparison) {
    return std::all_of(comparison.rows.begin(), comparison.rows.end(), [](const ComparedRow& row) {
        return row.state == RowState::Same || row.state == RowState::OnlyOnDevice;
    });
}

CommandResult compare(CommandContext& context, devices::Device& device, const std::string& path) {
    const Result<Question> question = ask(device, path);
    if (!question) {
        return failure(question.error());
    }
    return answer(context, device, *question, {}, isAllSame(question->comparison));
}

std::vector<std::string> rowsToRestore(const ConfigurationComparison& comparison,
                                       const ConfigOptions& options) {
    if (options.only.empty()) {
        return proposedRows(comparison, options.withCalibration);
    }
    return splitList(options.only);
}

bool isAllRestored(const ConfigurationComparison& comparison, const std::vector<RowOutcome>& outcomes,
                   bool isWhole) {
    const bool isDone = std::all_of(outcomes.begin(), outcomes.end(),
                                    [](const RowOutcome& outcome) { return outcome.isRestored; });
    const bool isTaken =
        std::all_of(comparison.rows.begin(), comparison.rows.end(), [](const ComparedRow& row) {
            return row.state != RowState::Refused && row.state != RowState::OnlyInFile;
        });
    return isDone && (isTaken || !isWhole);
}

CommandResult restore(CommandContext& context, devices::Device& device, const ConfigOptions& options) {
    const Result<Question> question = ask(device, options.input);
    if (!question) {
        return failure(question.error());
    }
    const std::vector<std::string> names = rowsToRestore(question->comparison, options);
    const Result<std::vector<ParameterValue>> values = chosenValues(question->comparison, names);
    if (!values) {
        return failure(values.error());
    }
    if (!values->empty()) {
        if (const Result<void> kept = backUp(context, device, question->values); !kept) {
            return failure(kept.error());
        }
    }
    const Result<std::vector<RowOutcome>> outcomes = restoreValues(device, *values);
    if (!outcomes) {
        return failure(outcomes.error());
    }
    const bool isGood = isAllRestored(question->comparison, *outcomes, options.only.empty());
    if (isGood && options.isSaved) {
        if (const Result<void> saved = device.saveParameters(); !saved) {
            return failure(saved.error());
        }
    }
    return answer(context, device, *question, *outcomes, isGood);
}

Result<void> checkOptions(const ConfigOptions& options) {
    const bool isRestoring = options.what == "restore";
    if (options.what != "save" && options.what != "compare" && !isRestoring) {
        return failure(ErrorCode::Usage, fmt::format("config cannot '{}'", options.what),
                       "use save, compare or restore");
    }
    if (!isRestoring && (options.isSaved || options.withCalibration || !options.only.empty())) {
        return failure(ErrorCode::Usage, "--only, --calibration and --save belong to config restore",
                       "leave them out");
    }
    if (options.withCalibration && !options.only.empty()) {
        return failure(ErrorCode::Usage, "--only names the rows already; --calibration adds to all",
                       "give one of the two");
    }
    return {};
}

CommandResult runConfigCommand(CommandContext& context, const ConfigOptions& options) {
    if (const Result<void> checked = checkOptions(options); !checked) {
        return failure(checked.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    if (const Result<void> fits = checkStore(options.isSaved, options.device, **device); !fits) {
        return failure(fits.error());
    }
    if (options.what == "save") {
        return save(context, **device, options.input);
    }
    return options.what == "compare" ? compare(context, **device, options.input)
                                     : restore(context, **device, options);
}

void addOptions(CommandSyntax& syntax, ConfigOptions& options) {
    syntax.argument("WHAT", options.what, "save, compare or restore");
    syntax.device(options.device);
    syntax.argument("FILE", options.input, "Configuration", "FILE.toml");
    syntax.option("--only", options.only, "Restore these rows, separated by commas", "A,B");
    syntax.flag("--calibration", options.withCalibration,
                "Restore the calibration too when it was measured on another device");
    syntax.flag("--save", options.isSaved, "Store in the board's non-volatile memory as well");
}

CommandOutputs outputsOf(const ConfigOptions& options) {
    return {{options.what == "save" ? options.input : std::string()}, {}};
}

} // namespace

Command configCommand() {
    return makeCommand<ConfigOptions>("config", "Save, compare and restore all settings of a device",
                                      {addOptions, runConfigCommand, outputsOf});
}

} // namespace halbench::app
