#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "devices/open/system_files.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct DevicesOptions {
    bool printsUdevRules = false;
    bool printsDesktopFile = false;
};

struct DescribeOptions {
    std::string device;
};

JsonValue toJson(const devices::DeviceListing& device) {
    JsonValue entry = JsonValue::object();
    entry.set("uri", device.uri).set("model", textOrNull(device.model)).set("transport", device.transport);
    entry.set("id", textOrNull(device.id))
        .set("name", textOrNull(device.name))
        .set("simulated", device.isSimulated)
        .set("available", device.isAvailable);
    entry.set("reason", textOrNull(device.reason)).set("hint", textOrNull(device.hint));
    return entry;
}

JsonValue toJson(const SignalSpec& signal) {
    JsonValue entry = JsonValue::object();
    entry.set("name", signal.name).set("role", textOrNull(signal.role)).set("unit", signal.unit);
    entry.set("min", finiteOrNull(signal.min)).set("max", finiteOrNull(signal.max));
    return entry.set("max_rate_hz", finiteOrNull(signal.maxRate_Hz));
}

JsonValue toJson(const ParameterSpec& spec, double value) {
    JsonValue entry = JsonValue::object();
    entry.set("name", spec.name).set("role", textOrNull(spec.role)).set("unit", spec.unit);
    entry.set("value", finiteOrNull(value)).set("default", finiteOrNull(spec.defaultValue));
    entry.set("min", finiteOrNull(spec.min))
        .set("max", finiteOrNull(spec.max))
        .set("group", textOrNull(spec.group));
    entry.set("access", spec.access == ParameterAccess::ReadOnly ? "read" : "read-write");
    return entry.set("help", textOrNull(spec.help));
}

std::vector<std::string> parameterNames(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : catalogue.parameters) {
        names.push_back(spec.name);
    }
    return names;
}

JsonValue descriptionDocument(const ResultHeader& header, const devices::Catalogue& catalogue,
                              const std::vector<double>& values) {
    JsonValue document = app::toJson(header);
    JsonValue signals = JsonValue::array();
    for (const SignalSpec& signal : catalogue.signals) {
        signals.push(toJson(signal));
    }
    JsonValue parameters = JsonValue::array();
    for (std::size_t index = 0; index < values.size(); ++index) {
        parameters.push(toJson(catalogue.parameters[index], values[index]));
    }
    document.set("signals", signals).set("parameters", parameters);
    return document.set("procedures", catalogue.procedures);
}

std::string descriptionText(const devices::Device& device, const std::vector<double>& values) {
    const devices::DeviceInfo& info = device.info();
    const devices::Catalogue& catalogue = device.catalogue();
    std::string text = fmt::format("{}  {}  firmware {}{}\n\nSignals\n", info.model, info.id, info.firmware,
                                   info.isSimulated ? "  SIMULATED" : "");
    for (const SignalSpec& signal : catalogue.signals) {
        text += fmt::format("  {:<28} {:<10} {:>6} Hz\n", signal.name, signal.unit,
                            formatNumber(signal.maxRate_Hz));
    }
    text += "\nParameters (value, unit, limits, default)\n";
    for (std::size_t index = 0; index < values.size(); ++index) {
        const ParameterSpec& spec = catalogue.parameters[index];
        text += fmt::format("  {:<28} {:>14} {:<10} [{}, {}]  {}\n", spec.name, formatNumber(values[index]),
                            spec.unit, formatNumber(spec.min), formatNumber(spec.max),
                            formatNumber(spec.defaultValue));
    }
    return text + fmt::format("\nProcedures: {}\n", fmt::join(catalogue.procedures, ", "));
}

CommandResult runDevicesCommand(CommandContext& context, const DevicesOptions& options) {
    if (options.printsUdevRules || options.printsDesktopFile) {
        if (context.global.style.isJson || (options.printsUdevRules && options.printsDesktopFile)) {
            return failure(ErrorCode::Usage,
                           fmt::format("{} prints a file, not a document",
                                       options.printsUdevRules ? "--udev-rules" : "--desktop-file"),
                           "leave out --json and the other one");
        }
        context.console.print(options.printsUdevRules ? devices::udevRules() : devices::desktopFile());
        return ExitCode::Done;
    }
    JsonValue list = JsonValue::array();
    std::string text;
    for (const devices::DeviceListing& device : devices::listDevices()) {
        list.push(toJson(device));
        text += fmt::format("{:<24} {:<8} {:<10} {:<20} {}{}{}\n", device.uri, device.model, device.transport,
                            device.id, device.name, device.name.empty() ? "" : ": ",
                            device.isAvailable ? "available" : device.reason + "; " + device.hint);
    }
    context.console.print(text);
    JsonValue document = app::toJson(headerFor(context, "halbench.devices/1"));
    if (const Result<void> printed = context.console.printDocument(document.set("devices", list)); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

CommandResult runDescribeCommand(CommandContext& context, const DescribeOptions& options) {
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const devices::Catalogue& catalogue = (*device)->catalogue();
    const Result<std::vector<double>> values = (*device)->readParameters(parameterNames(catalogue));
    if (!values) {
        return failure(values.error());
    }
    const ResultHeader header = headerFor(context, "halbench.description/1", **device);
    context.console.print(descriptionText(**device, *values));
    const Result<void> printed =
        context.console.printDocument(descriptionDocument(header, catalogue, *values));
    if (!printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, DevicesOptions& options) {
    syntax.flag("--udev-rules", options.printsUdevRules,
                "Print the rules that let a user open boards without being root");
    syntax.flag("--desktop-file", options.printsDesktopFile,
                "Print the entry that puts the window into the desktop's menu");
}

void addOptions(CommandSyntax& syntax, DescribeOptions& options) {
    syntax.device(options.device);
}

} // namespace

Command devicesCommand() {
    return makeCommand<DevicesOptions>("devices", "List what can be connected; opens nothing",
                                       {addOptions, runDevicesCommand});
}

Command describeCommand() {
    return makeCommand<DescribeOptions>("describe", "Identity, signals and parameters of a device",
                                        {addOptions, runDescribeCommand});
}

} // namespace halbench::app
