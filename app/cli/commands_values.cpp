#include "app/actuators/actuator.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

struct GetOptions {
    std::string device;
    std::vector<std::string> names;
};

struct SetOptions {
    std::string device;
    std::vector<std::string> names; ///< NAME=VALUE
    bool isSaved = false;
};

struct NamedValue {
    std::string name;
    double value = 0.0;
    std::string unit;
};

/// Reads signals and parameters, each kind in one go, and gives them in the order asked for.
Result<std::vector<NamedValue>> readNamed(devices::Device& device, const std::vector<std::string>& names) {
    std::vector<std::string> signals;
    std::vector<std::string> parameters;
    for (const std::string& name : names) {
        const bool isSignal = device.catalogue().findSignal(name) != nullptr;
        if (!isSignal && device.catalogue().findParameter(name) == nullptr) {
            return failure(unknownName(device.catalogue(), name));
        }
        (isSignal ? signals : parameters).push_back(name);
    }
    Result<std::vector<double>> signalValues = device.readSignals(signals);
    if (!signalValues) {
        return failure(signalValues.error());
    }
    Result<std::vector<double>> parameterValues = device.readParameters(parameters);
    if (!parameterValues) {
        return failure(parameterValues.error());
    }
    std::vector<NamedValue> values;
    auto nextSignal = signalValues->begin();
    auto nextParameter = parameterValues->begin();
    for (const std::string& name : names) {
        const SignalSpec* signal = device.catalogue().findSignal(name);
        const std::string unit =
            signal != nullptr ? signal->unit : device.catalogue().findParameter(name)->unit;
        values.push_back({name, signal != nullptr ? *nextSignal++ : *nextParameter++, unit});
    }
    return values;
}

CommandResult printValues(CommandContext& context, const devices::Device& device,
                          const std::vector<NamedValue>& values) {
    JsonValue list = JsonValue::array();
    std::string text;
    for (const NamedValue& named : values) {
        JsonValue entry = JsonValue::object();
        entry.set("name", named.name).set("value", finiteOrNull(named.value)).set("unit", named.unit);
        list.push(entry);
        text += fmt::format("{} = {}{}{}\n", named.name, formatNumber(named.value),
                            named.unit.empty() ? "" : " ", named.unit);
    }
    context.console.print(text);
    JsonValue document = toJson(headerFor(context, "halbench.values/1", device));
    if (const Result<void> printed = context.console.printDocument(document.set("values", list)); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

/// "NAME=VALUE": a number, or one of the words of an enumeration.
Result<ParameterValue> parseAssignment(const devices::Catalogue& catalogue, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        return failure(ErrorCode::Usage, fmt::format("'{}' is not NAME=VALUE", text), "write gain.kp=12.5");
    }
    const std::string name = text.substr(0, equals);
    const std::string value = text.substr(equals + 1);
    const ParameterSpec* spec = catalogue.findParameter(name);
    if (spec == nullptr) {
        return failure(catalogue.findSignal(name) != nullptr
                           ? Error{ErrorCode::Usage,
                                   fmt::format("'{}' is a signal and cannot be written", name),
                                   "see 'halbench describe DEVICE' for the parameters"}
                           : unknownName(catalogue, name));
    }
    if (spec->access == ParameterAccess::ReadOnly) {
        return failure(ErrorCode::Usage, fmt::format("parameter '{}' is read only", name), "leave it out");
    }
    const auto choice = std::find(spec->choices.begin(), spec->choices.end(), value);
    const std::optional<double> number = choice != spec->choices.end()
                                             ? std::optional<double>(choice - spec->choices.begin())
                                             : parseNumber(value);
    if (!number) {
        return failure(ErrorCode::Usage, fmt::format("parameter '{}': '{}' is not a number", name, value),
                       spec->choices.empty() ? "write it like 0.5 or 2e-3, with a point"
                                             : fmt::format("use {}", fmt::join(spec->choices, ", ")));
    }
    return ParameterValue{name, *number};
}

Result<std::vector<ParameterValue>> parseAssignments(const devices::Catalogue& catalogue,
                                                     const std::vector<std::string>& texts) {
    std::vector<ParameterValue> values;
    for (const std::string& text : texts) {
        Result<ParameterValue> value = parseAssignment(catalogue, text);
        if (!value) {
            return failure(value.error());
        }
        if (Result<void> checked = checkParameterValue(*catalogue.findParameter(value->name), value->value);
            !checked) {
            return failure(checked.error());
        }
        const bool isRepeated = std::any_of(values.begin(), values.end(), [&](const ParameterValue& earlier) {
            return earlier.name == value->name;
        });
        if (isRepeated) {
            return failure(ErrorCode::Usage, fmt::format("parameter '{}' is given twice", value->name),
                           "name it once");
        }
        values.push_back(*std::move(value));
    }
    return values;
}

CommandResult runGetCommand(CommandContext& context, const GetOptions& options) {
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const Result<std::vector<NamedValue>> values = readNamed(**device, options.names);
    if (!values) {
        return failure(values.error());
    }
    return printValues(context, **device, *values);
}

CommandResult runSetCommand(CommandContext& context, const SetOptions& options) {
    const Result<std::unique_ptr<devices::Device>> opened = openDeviceFor(context, options.device);
    if (!opened) {
        return failure(opened.error());
    }
    devices::Device& device = **opened;
    if (const Result<void> fits = checkStore(options.isSaved, options.device, device); !fits) {
        return failure(fits.error());
    }
    const Result<std::vector<ParameterValue>> values = parseAssignments(device.catalogue(), options.names);
    if (!values) {
        return failure(values.error());
    }
    for (const ParameterValue& value : *values) {
        if (value.name == "hb.arm" && value.value != 0.0) {
            if (const Result<void> consent = requireConsent(context, device); !consent) {
                return failure(consent.error());
            }
        }
    }
    if (options.isSaved) {
        if (const Result<void> kept = backUp(context, device); !kept) {
            return failure(kept.error());
        }
    }
    Result<void> written = writeChosenValues(device, *values);
    if (written && options.isSaved) {
        written = device.saveParameters();
    }
    if (!written) {
        return failure(written.error());
    }
    std::vector<std::string> names;
    for (const ParameterValue& value : *values) {
        names.push_back(value.name);
    }
    const Result<std::vector<NamedValue>> readBack = readNamed(device, names);
    if (!readBack) {
        return failure(readBack.error());
    }
    return printValues(context, device, *readBack);
}

void addOptions(CommandSyntax& syntax, GetOptions& options) {
    syntax.device(options.device);
    syntax.arguments("NAME", options.names, "Signal or parameter");
}

void addOptions(CommandSyntax& syntax, SetOptions& options) {
    syntax.device(options.device);
    syntax.arguments("NAME=VALUE", options.names, "What to write");
    syntax.flag("--save", options.isSaved, "Store in the board's non-volatile memory as well");
}

} // namespace

Command getCommand() {
    return makeCommand<GetOptions>("get", "Read signals and parameters", {addOptions, runGetCommand});
}

Command setCommand() {
    return makeCommand<SetOptions>("set", "Write parameters in one transaction and read them back",
                                   {addOptions, runSetCommand});
}

} // namespace halbench::app
