#pragma once

#include "app/documents/result_header.h"
#include "devices/formats/csv_import.h"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace halbench::app {

// A table of another program on its way to a recording, without the window: for a thread of its own. The same
// functions and numbers as `halbench import`.

/// How a table would be read with what is said of it so far.
struct TableLook {
    devices::CsvPlan plan;
    Recording first; ///< its first rows as they would be read; none while something is asked
};

/// Errors: those of planCsvImport(), and of the first rows.
Result<TableLook> lookAtTable(const std::string& text, const std::string& origin,
                              const devices::CsvImportRequest& request);

/// What became of it.
struct ImportedTable {
    std::string path;
    std::size_t rows = 0;
    std::vector<Finding> findings;
};

/// Seen from both threads while it works.
struct ImportProgress {
    std::atomic<bool> isCancelled = false;
    std::atomic<std::size_t> rows = 0; ///< read so far, to the thousand
};

/// Reads all rows and writes the recording beside its sidecar. Errors: those of importCsv(), FileSystem,
/// Usage (there is a file of that name already), Interrupted; nothing is left behind then.
Result<ImportedTable> importTable(const std::string& text, const std::string& origin,
                                  const devices::CsvPlan& plan, const std::string& path,
                                  const ResultHeader& header, ImportProgress& progress);

/// Whether our own reader takes the beginning of a file; else it is a table of another program. Errors:
/// FileSystem.
Result<bool> isOwnRecording(const std::string& path);

} // namespace halbench::app
