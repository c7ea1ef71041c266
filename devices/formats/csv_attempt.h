#pragma once

#include "devices/formats/csv_dialect.h"
#include "devices/formats/csv_text.h"

#include <cstdint>
#include <string>
#include <vector>

namespace halbench::devices {

/// One way to read a text, and how far it led.
struct CsvAttempt {
    CsvDialect dialect;
    char group = 0; ///< thousands separator that is tolerated to see what would come out; 0: none
    std::vector<CsvHeader> headers;
    std::size_t width = 0;
    std::uint64_t hash = 0;           ///< of all values
    std::string sample;               ///< one row as it is read
    std::size_t line = 0, column = 0; ///< where it failed, or of the first grouped cell
    std::string problem;
    bool isCell = false; ///< the problem is that of one cell

    bool fail(std::size_t atLine, std::size_t atColumn, std::string what) {
        line = atLine;
        column = atColumn;
        problem = std::move(what);
        return false;
    }
};

/// Reads all lines; the attempt knows afterwards what they are or where it failed. `shown` becomes the sample
/// when it is a row of numbers, else the first row. False: it failed, or it found none of the groups that it
/// tolerates.
bool tryToRead(CsvAttempt& attempt, const std::vector<CsvLine>& lines, const CsvLine* shown,
               const CsvHints& hints);

} // namespace halbench::devices
