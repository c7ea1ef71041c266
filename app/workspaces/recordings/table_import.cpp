#include "app/workspaces/recordings/table_import.h"

#include "app/documents/import_documents.h"
#include "devices/formats/csv_text.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_writer.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace halbench::app {

namespace {

constexpr std::size_t ShownRows = 8;
constexpr std::size_t RowsPerCheck = 1000; ///< of importCsv()
constexpr std::size_t Head_bytes = std::size_t{1} << 16;

/// Up to the end of the so manieth line that carries something.
std::string_view firstLinesOf(std::string_view text, std::size_t count) {
    devices::CsvLines lines(text);
    devices::CsvLine line;
    std::size_t end = 0;
    for (std::size_t i = 0; i < count && lines.next(line); ++i) {
        end = static_cast<std::size_t>(line.text.data() - text.data()) + line.text.size();
    }
    return text.substr(0, end);
}

} // namespace

Result<TableLook> lookAtTable(const std::string& text, const std::string& origin,
                              const devices::CsvImportRequest& request) {
    Result<devices::CsvPlan> plan = devices::planCsvImport(text, origin, request);
    if (!plan) {
        return failure(plan.error());
    }
    TableLook look{*std::move(plan), {}};
    if (!look.plan.questions.empty() || !look.plan.dialect) {
        return look;
    }
    const std::size_t lines = devices::csvHeaderLines(look.plan.dialect->header) + ShownRows;
    const Result<devices::CsvImport> first = devices::importCsv(firstLinesOf(text, lines), origin, look.plan);
    if (!first) {
        return failure(first.error());
    }
    look.first = first->recording;
    return look;
}

Result<ImportedTable> importTable(const std::string& text, const std::string& origin,
                                  const devices::CsvPlan& plan, const std::string& path,
                                  const ResultHeader& header, ImportProgress& progress) {
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
        return failure(ErrorCode::Usage, path + ": the file exists already",
                       "give the recording another name");
    }
    const auto check = [&progress]() -> Result<void> {
        progress.rows += RowsPerCheck;
        if (progress.isCancelled) {
            return failure(ErrorCode::Interrupted, "the import was cancelled", "nothing was written");
        }
        return {};
    };
    const Result<devices::CsvImport> import = devices::importCsv(text, origin, plan, check);
    if (!import) {
        return failure(import.error());
    }
    if (const Result<void> written = devices::writeExactRecordingFile(
            path, import->recording, importedMeta(header, import->recording));
        !written) {
        return failure(written.error());
    }
    return ImportedTable{path, import->recording.rows(), qualityOf(plan, &*import).findings};
}

Result<bool> isOwnRecording(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(Head_bytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!file && !file.eof()) {
        return failure(ErrorCode::FileSystem, path + ": cannot be read", "check that the file exists");
    }
    head.resize(static_cast<std::size_t>(file.gcount()));
    if (head.size() == Head_bytes) {
        head.resize(head.rfind('\n') == std::string::npos ? 0 : head.rfind('\n') + 1); // whole lines
    }
    return devices::parseRecordingCsv(head, path).has_value();
}

} // namespace halbench::app
