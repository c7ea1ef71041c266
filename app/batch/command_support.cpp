#include "app/batch/command_support.h"

#include "app/batch/output_file.h"

#include <fmt/format.h>

namespace halbench::app {

Result<void> deliver(CommandContext& context, const JsonValue& document, const std::string& text,
                     const std::string& out) {
    if (!out.empty()) {
        const Result<std::string> json = toJsonText(document);
        if (!json) {
            return failure(json.error());
        }
        if (const Result<void> written = writeFile(out, *json); !written) {
            return written;
        }
        context.console.log(LogLevel::Info, "wrote " + out);
    } else {
        context.console.print(text);
    }
    return context.console.printDocument(document);
}

ExitCode exitCodeFor(const DataQuality& quality) {
    return quality.verdict == Verdict::Refused ? ExitCode::CheckFailed : ExitCode::Done;
}

std::string findingLines(const DataQuality& quality) {
    std::string text = fmt::format("data quality: {}\n", verdictName(quality.verdict));
    for (const Finding& finding : quality.findings) {
        text += fmt::format("  {}: {}; {}\n", finding.code, finding.message, finding.hint);
    }
    return text;
}

} // namespace halbench::app
