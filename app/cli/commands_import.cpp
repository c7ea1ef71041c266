#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/import_documents.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_writer.h"

#include <fmt/format.h>

#include <array>

namespace halbench::app {

namespace {

struct ImportOptions {
    std::string input, out;
    std::string separator, decimal, header;
    std::string timeColumn; ///< --time
    std::string rate;
    std::vector<std::string> mappings;    ///< --map OUR=THEIR
    std::vector<std::string> columnUnits; ///< --unit COLUMN=UNIT
    bool isPreview = false;
};

Result<std::optional<char>> separatorFrom(const std::string& text) {
    if (text.empty()) {
        return std::optional<char>();
    }
    for (const char separator : {',', ';', '\t', ' ', '\0'}) {
        if (text == devices::separatorWord(separator) || text == std::string(1, separator)) {
            return std::optional<char>(separator);
        }
    }
    return failure(ErrorCode::Usage, "--separator: '" + text + "' is none",
                   "use ',', ';', tab, space, or none for a single column");
}

Result<devices::CsvHints> hintsFrom(const ImportOptions& options) {
    devices::CsvHints hints;
    const Result<std::optional<char>> separator = separatorFrom(options.separator);
    if (!separator) {
        return failure(separator.error());
    }
    hints.separator = *separator;
    if (!options.decimal.empty()) {
        if (options.decimal != "." && options.decimal != ",") {
            return failure(ErrorCode::Usage, "--decimal: '" + options.decimal + "' is no decimal sign",
                           "use . or ,");
        }
        hints.decimal = options.decimal[0];
    }
    using devices::CsvHeader;
    for (const CsvHeader header : {CsvHeader::None, CsvHeader::Names, CsvHeader::NamesAndUnits}) {
        if (options.header == devices::headerWord(header)) {
            hints.header = header;
        }
    }
    if (!options.header.empty() && !hints.header) {
        return failure(ErrorCode::Usage, "--header: '" + options.header + "' is not known",
                       "use 0 (no header), 1 (a line of names) or units (names, then units)");
    }
    return hints;
}

/// "OUR=THEIR" at the first '=', "THEIR=UNIT" at the last: neither a name of ours nor a unit has one.
Result<std::pair<std::string, std::string>> pairFrom(const std::string& option, const std::string& text,
                                                     std::size_t at) {
    if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
        return failure(ErrorCode::Usage, option + ": '" + text + "' is not of the form A=B",
                       option == "--map" ? "give OUR=THEIR, e.g. speed=omega_mech"
                                         : "give COLUMN=UNIT, e.g. omega_mech=rpm");
    }
    return std::pair(text.substr(0, at), text.substr(at + 1));
}

Result<devices::CsvImportRequest> requestFrom(const ImportOptions& options) {
    devices::CsvImportRequest request;
    const Result<devices::CsvHints> hints = hintsFrom(options);
    if (!hints) {
        return failure(hints.error());
    }
    request.hints = *hints;
    request.timeColumn = options.timeColumn;
    if (!options.rate.empty()) {
        const Result<double> rate = numberOption("--rate_Hz", options.rate);
        if (!rate) {
            return failure(rate.error());
        }
        request.rate_Hz = *rate;
    }
    for (const std::string& text : options.mappings) {
        const auto mapping = pairFrom("--map", text, text.find('='));
        if (!mapping) {
            return failure(mapping.error());
        }
        request.map.push_back(*mapping);
    }
    for (const std::string& text : options.columnUnits) {
        const auto unit = pairFrom("--unit", text, text.rfind('='));
        if (!unit) {
            return failure(unit.error());
        }
        request.units.push_back(*unit);
    }
    return request;
}

Result<void> checkOut(const ImportOptions& options) {
    if (options.isPreview) {
        return {};
    }
    if (options.out.empty()) {
        return failure(ErrorCode::Usage, "--out is missing",
                       "give --out FILE.csv, or --preview to look only");
    }
    return {};
}

/// One line that asks everything there is to ask.
Error errorFor(const std::string& input, const devices::CsvPlan& plan) {
    std::string message = input + ": ";
    std::string hint = "add ";
    for (std::size_t i = 0; i < plan.questions.size(); ++i) {
        const devices::CsvQuestion& question = plan.questions[i];
        message += (i == 0 ? "" : "; ") + question.text;
        hint += i == 0 ? "" : ", and ";
        for (std::size_t answer = 0; answer < question.answers.size(); ++answer) {
            hint += fmt::format("{}{} ({})", answer == 0 ? "" : " or ", question.answers[answer].option,
                                question.answers[answer].meaning);
        }
    }
    return {ErrorCode::Usage, message, hint};
}

CommandResult finish(CommandContext& context, const JsonValue& document, const std::string& text) {
    context.console.print(text);
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

CommandResult runImportCommand(CommandContext& context, const ImportOptions& options) {
    const Result<devices::CsvImportRequest> request = requestFrom(options);
    if (!request) {
        return failure(request.error());
    }
    if (const Result<void> out = checkOut(options); !out) {
        return failure(out.error());
    }
    const Result<std::string> text = devices::readTableText(options.input);
    if (!text) {
        return failure(text.error());
    }
    const Result<devices::CsvPlan> plan = devices::planCsvImport(*text, options.input, *request);
    if (!plan) {
        return failure(plan.error());
    }
    ResultHeader header = headerFor(context, "halbench.import/1");
    if (options.isPreview) {
        header.quality = qualityOf(*plan, nullptr);
        return finish(context, importDocument(header, *plan, nullptr), previewText(*plan));
    }
    if (!plan->questions.empty()) {
        return failure(errorFor(options.input, *plan));
    }
    const Result<devices::CsvImport> import =
        devices::importCsv(*text, options.input, *plan, [&context] { return checkInterrupt(context); });
    if (!import) {
        return failure(import.error());
    }
    header.quality = qualityOf(*plan, &*import);
    const Result<void> written = devices::writeExactRecordingFile(options.out, import->recording,
                                                                  importedMeta(header, import->recording));
    if (!written) {
        return failure(written.error());
    }
    for (const Finding& finding : header.quality.findings) {
        context.console.log(LogLevel::Warning, finding.message + "; " + finding.hint);
    }
    context.console.log(LogLevel::Info,
                        fmt::format("wrote {} ({} rows)", options.out, import->recording.rows()));
    return finish(context, importDocument(header, *plan, &*import), "");
}

void addOptions(CommandSyntax& syntax, ImportOptions& options) {
    syntax.argument("FILE", options.input, "Text with columns of numbers");
    syntax.recording("--out", options.out, "Recording");
    syntax.option("--separator", options.separator, "',', ';', tab, space, or none for one column", "SIGN");
    syntax.option("--decimal", options.decimal, "Decimal sign: . or ,", "SIGN");
    syntax.option("--header", options.header, "0, 1, or units for a line of names and one of units", "LINES");
    syntax.option("--time", options.timeColumn, "Name or number of the time's column", "COLUMN");
    syntax.option("--rate_Hz", options.rate, "Rows per second of a table without a time", "F");
    syntax.repeatable("--map", options.mappings, "Name of ours for a column of theirs; repeatable",
                      "OUR=THEIR");
    syntax.repeatable("--unit", options.columnUnits, "Unit that a column is written in; repeatable",
                      "COLUMN=UNIT");
    syntax.flag("--preview", options.isPreview, "Say how the table would be read, write nothing");
}

CommandOutputs outputsOf(const ImportOptions& options) {
    return {{}, {options.out}};
}

} // namespace

Command importCommand() {
    return makeCommand<ImportOptions>("import", "Make a recording of another program's table",
                                      {addOptions, runImportCommand, outputsOf});
}

} // namespace halbench::app
