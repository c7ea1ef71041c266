#include "app/cli/command_output.h"

#include "app/documents/text/output_file.h"
#include "app/headless/console.h"

namespace halbench::app {

Result<void> namingFile(const std::string& path, Result<void> written) {
    if (!written && written.error().message.find(path) == std::string::npos) {
        written.error().message = path + ": " + written.error().message;
    }
    return written;
}

CommandResult endWithResult(CommandContext& context, const CommandOutput& result, const Error& error) {
    Error told = error;
    const Result<std::string> json = toJsonText(result.document);
    const bool isKept = !result.out.empty() && json && writeFile(result.out, *json);
    if (isKept) {
        told.message += "; the result is in " + result.out;
    }
    if (!context.console.style().isJson) {
        context.console.print(isKept ? "" : result.text);
        return failure(told);
    }
    context.console.log(LogLevel::Error, errorLine(told));
    JsonValue document = errorDocument(told);
    document.set("result", result.document);
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return exitCodeFor(told.code);
}

} // namespace halbench::app
