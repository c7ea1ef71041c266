#pragma once

#include "devices/formats/csv_dialect.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// What the user says of a table that another program wrote. A column is named as its header names it, with
/// or without the unit, or by its number from 1.
struct CsvImportRequest {
    CsvHints hints;
    std::string timeColumn; ///< empty: found by name and unit
    std::optional<double> rate_Hz;
    std::vector<std::pair<std::string, std::string>> map;   ///< signal of ours, column of theirs
    std::vector<std::pair<std::string, std::string>> units; ///< column of theirs, unit as it is written there
};

/// What is said of a table, and an answer to a question about it.
CsvImportRequest answered(CsvImportRequest request, const CsvQuestion::Answer& answer);

struct CsvColumn {
    std::string header;  ///< in UTF-8; empty when the table has no names
    std::string name;    ///< of it, without the unit
    std::string written; ///< its unit as it is written; empty: nowhere
    std::string signal;  ///< what the recording calls it
    std::string unit;    ///< symbol, SI; empty: none or not known
    double factor = 1.0; ///< SI value = written value * factor / divisor + offset
    double divisor = 1.0;
    double offset = 0.0;
    bool isUnitKnown = false;

    double inSi(double value) const { return value * factor / divisor + offset; }
};

/// What a request calls a column: its header, or its number where that is no other's.
std::string columnWord(const std::vector<CsvColumn>& columns, std::size_t index);

struct CsvColumns {
    std::vector<CsvColumn> columns;
    std::optional<std::size_t> time; ///< column; nothing: the rows are counted at a rate, or it is asked
    std::vector<CsvQuestion> questions;
};

/// The columns by the lines of names and units, `width` of them. What becomes a signal of Halbench must have
/// its quantity; a unit that is nowhere is asked for. Errors: UnknownName (a column), Usage (a column or name
/// given twice, a bad name), InvalidInput (a unit of another quantity).
Result<CsvColumns> arrangeColumns(const std::vector<std::string>& names,
                                  const std::vector<std::string>& units, std::size_t width,
                                  const CsvImportRequest& request);

} // namespace halbench::devices
