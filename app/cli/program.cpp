#include "app/cli/program.h"

#include "app/cli/command_line.h"
#include "app/documents/result_header.h"
#include "control/base/matrix_blocks.h"

#include <QtCore/QLocale>

#include <exception>

namespace halbench::app {

namespace {

CommandResult printVersion(CommandContext& context) {
    context.console.print("halbench " HALBENCH_VERSION "\n");
    JsonValue document = JsonValue::object();
    document.set("schema", "halbench.version/1").set("halbench", HALBENCH_VERSION);
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

CommandResult dispatch(CommandContext& context, const CommandLine& line) {
    if (line.command == "help") {
        if (context.global.style.isJson) {
            return failure(ErrorCode::Usage, "--json needs a command", "see 'halbench --help'");
        }
        context.console.print(line.helpText);
        return ExitCode::Done;
    }
    return line.command == "version" ? printVersion(context) : line.run(context);
}

CommandResult runArguments(const std::vector<std::string>& arguments, Console& console,
                           const std::atomic<int>& interruptSignal) {
    const Result<CommandLine> line = parseCommandLine(arguments);
    if (!line) {
        return failure(line.error());
    }
    console.setStyle(line->global.style);
    if (const Result<void> free = checkOutputs(line->outputs, line->global.mayOverwrite); !free) {
        return failure(free.error());
    }
    CommandContext context{line->global, console, interruptSignal};
    CommandResult result = dispatch(context, *line);
    if (result) {
        if (const Result<void> finished = console.finish(); !finished) {
            return failure(finished.error());
        }
    }
    return result;
}

} // namespace

int runProgram(const std::vector<std::string>& arguments, const std::atomic<int>& interruptSignal) noexcept {
    try {
        fixMatrixBlocks();
        QLocale::setDefault(QLocale::c()); // titles of pictures hold numbers: no comma where the user has one
        Console console(styleFromArguments(arguments));
        CommandResult result = failure(ErrorCode::Internal, "nothing ran");
        try {
            result = runArguments(arguments, console, interruptSignal);
        } catch (const std::exception& exception) {
            result = failure(ErrorCode::Internal, std::string("internal error: ") + exception.what(),
                             "report this with the command line used");
        }
        if (result) {
            return static_cast<int>(*result);
        }
        const ExitCode code = exitCodeFor(result.error().code, interruptSignal.load());
        console.error(result.error(), code);
        static_cast<void>(console.finish());
        return static_cast<int>(code);
    } catch (...) {
        return static_cast<int>(ExitCode::Internal);
    }
}

} // namespace halbench::app
