#include "app/cli/command_line.h"

#include "app/cli/commands.h"
#include "app/documents/text/numbers.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace halbench::app {

namespace {

/// Texts that CLI11 fills before they are judged.
struct RawGlobals {
    std::string seed;
    std::string level = "info";
    bool isJson = false;
    bool isVersion = false;
    bool isColorless = false;
    bool isQuiet = false;
    bool isRealtime = false;
    bool mayArm = false;
    bool mayOverwrite = false;
};

void addGlobalOptions(CLI::App& app, RawGlobals& raw) {
    app.add_flag("--json", raw.isJson, "One JSON document on stdout, nothing else there");
    app.add_option("--seed", raw.seed, "Seed of a simulated device; wins over ?seed=, default 1")
        ->type_name("N");
    app.add_flag("--realtime", raw.isRealtime, "Pace a simulated device by the wall clock");
    app.add_flag("--arm", raw.mayArm, "Consent: a device that is not simulated may be armed and move");
    app.add_flag("--force", raw.mayOverwrite, "Consent: output files that are there already are overwritten");
    app.add_flag("--quiet", raw.isQuiet, "Warnings and errors only on stderr");
    app.add_option("--log-level", raw.level, "error, warning, info or debug")->type_name("LEVEL");
    app.add_flag("--no-color", raw.isColorless, "No colours on a terminal");
    app.add_flag("--version", raw.isVersion, "Print the version and exit");
}

/// A command that understands the global options behind its name too.
void addCommand(CLI::App& app, const Command& command) {
    CLI::App* added = app.add_subcommand(command.name, command.help);
    added->fallthrough();
    CommandSyntax syntax(*added);
    command.addOptions(syntax);
}

Result<GlobalOptions> globalsFrom(const RawGlobals& raw, ConsoleStyle style) {
    GlobalOptions global;
    const std::map<std::string, LogLevel> levels = {{"error", LogLevel::Error},
                                                    {"warning", LogLevel::Warning},
                                                    {"info", LogLevel::Info},
                                                    {"debug", LogLevel::Debug}};
    const auto level = levels.find(raw.level);
    if (level == levels.end()) {
        return failure(ErrorCode::Usage, "--log-level: '" + raw.level + "' is not a level",
                       "use error, warning, info or debug");
    }
    if (!raw.seed.empty()) {
        const std::optional<std::int64_t> seed = parseInteger(raw.seed);
        if (!seed || *seed < 0) {
            return failure(ErrorCode::Usage, "--seed: '" + raw.seed + "' is not a whole number from 0",
                           "give a number like 7");
        }
        global.seed = static_cast<std::uint64_t>(*seed);
    }
    style.level = level->second;
    style.isQuiet = raw.isQuiet;
    global.style = style;
    global.isRealtime = raw.isRealtime;
    global.mayArm = raw.mayArm;
    global.mayOverwrite = raw.mayOverwrite;
    return global;
}

/// An option that was given must say something: an empty text never means "as if it were not there".
Result<void> refuseEmptyValues(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& value : option->results()) {
            if (value.empty()) {
                return failure(ErrorCode::Usage, option->get_name() + " is given without a value",
                               "give a value or leave it out");
            }
        }
    }
    return {};
}

/// What was given to the options and arguments of a command, but for free text, which names no file.
std::vector<std::string> valuesOf(const CLI::App& command) {
    std::vector<std::string> values;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_type_name() == "TITLE") {
            continue;
        }
        values.insert(values.end(), option->results().begin(), option->results().end());
    }
    return values;
}

std::string withoutNewlines(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

ConsoleStyle styleFromArguments(const std::vector<std::string>& arguments) {
    const auto has = [&](const char* flag) {
        return std::find(arguments.begin(), arguments.end(), flag) != arguments.end();
    };
    ConsoleStyle style;
    style.isJson = has("--json");
    style.isQuiet = has("--quiet");
    style.isTerminal = isatty(STDERR_FILENO) != 0;
    style.useColor = style.isTerminal && !has("--no-color") && std::getenv("NO_COLOR") == nullptr;
    return style;
}

Result<CommandLine> parseCommandLine(const std::vector<std::string>& arguments) {
    CLI::App app("Identify and retune precision Lorentz-force actuators.", "halbench");
    CommandLine line;
    RawGlobals raw;
    addGlobalOptions(app, raw);
    const std::vector<Command> known = allCommands();
    for (const Command& command : known) {
        addCommand(app, command);
    }
    app.footer("Help: resources/help/command-line.md. Without a command the window opens; it takes --project "
               "FILE and --connect DEVICE.");
    line.helpText = app.help();
    try {
        std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const std::vector<CLI::App*> commands = app.get_subcommands();
        line.command = "help";
        line.helpText = commands.empty() ? line.helpText : commands.front()->help();
        return line;
    } catch (const CLI::ParseError& error) {
        return failure(ErrorCode::Usage, withoutNewlines(error.what()), "see 'halbench --help'");
    }
    Result<GlobalOptions> global = globalsFrom(raw, styleFromArguments(arguments));
    if (!global) {
        return failure(global.error());
    }
    line.global = *global;
    const std::vector<CLI::App*> commands = app.get_subcommands();
    if (commands.size() > 1) {
        return failure(ErrorCode::Usage,
                       "'" + commands[0]->get_name() + "' and '" + commands[1]->get_name() +
                           "' are two commands",
                       "give one");
    }
    for (const CLI::App* given :
         {static_cast<const CLI::App*>(&app),
          commands.empty() ? nullptr : static_cast<const CLI::App*>(commands.front())}) {
        if (const Result<void> valid = given == nullptr ? Result<void>() : refuseEmptyValues(*given);
            !valid) {
            return failure(valid.error());
        }
    }
    line.command = raw.isVersion ? "version" : commands.empty() ? "help" : commands.front()->get_name();
    for (const Command& command : known) {
        if (command.name == line.command) {
            line.run = command.run;
            line.outputs = command.outputs();
            line.outputs.inputs = namedInputs(line.outputs, valuesOf(*commands.front()));
        }
    }
    return line;
}

} // namespace halbench::app
