#pragma once

#include "control/base/sample_block.h"
#include "devices/formats/csv_columns.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

/// How a table will be read, or what is missing for that: a table is read only without questions.
struct CsvPlan {
    CsvSight sight;
    std::optional<CsvDialect> dialect; ///< absent: one of the questions
    std::vector<CsvColumn> columns;    ///< none without a dialect
    std::optional<std::size_t> time;   ///< column; nothing: by rate_Hz
    std::optional<double> rate_Hz;
    std::vector<CsvQuestion> questions;
    std::vector<std::string> firstLines; ///< as they are, in UTF-8
};

/// Looks at a table and at what the user says of it. Errors: InvalidInput with line and column; those of
/// detectDialect() and arrangeColumns().
Result<CsvPlan> planCsvImport(std::string_view text, const std::string& origin,
                              const CsvImportRequest& request);

/// A table as a recording, in SI.
struct CsvImport {
    Recording recording;
    std::uint64_t missing = 0;   ///< cells without a number: NaN
    std::string firstMissing;    ///< "line 3, column 2, 'angle'"; empty: none
    double shortestStep_s = 0.0; ///< of the time axis
    double longestStep_s = 0.0;
    bool isUniform = true; ///< no step is more than 1 % off the median
};

/// Reads all rows; every number is the double nearest to what is written, before its unit is converted.
/// Memory: eight octets a number. Errors: InvalidInput with line and column (another number of cells, what is
/// no number, thousands separators, time that is missing or does not increase); that of `checkAbort`, which
/// is asked every thousand rows. Our bug: a plan with questions.
Result<CsvImport> importCsv(std::string_view text, const std::string& origin, const CsvPlan& plan,
                            const std::function<Result<void>()>& checkAbort = {});

} // namespace halbench::devices
