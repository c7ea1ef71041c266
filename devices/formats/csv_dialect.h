#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halbench::devices {

enum class CsvHeader { None, Names, NamesAndUnits };

/// How a table is written.
struct CsvDialect {
    char separator = ','; ///< ',', ';', tab, a blank; 0: one column
    char decimal = '.';   ///< '.' or ','
    CsvHeader header = CsvHeader::Names;
};

/// What the user says of it.
struct CsvHints {
    std::optional<char> separator;
    std::optional<char> decimal;
    std::optional<CsvHeader> header;
};

/// What only the user can tell, and the options that tell it.
struct CsvQuestion {
    struct Answer {
        std::string option;  ///< "--separator none --decimal ,"
        std::string meaning; ///< "1 column: 1.5"
        // What the options say, for answered():
        CsvHints hints = {};
        std::string timeColumn = {};
        std::pair<std::string, std::string> unit = {}; ///< column of theirs, unit
        bool isRate = false;                           ///< the rows of a second are still to be told
    };
    std::string about; ///< "numbers", "header", "time", "unit"
    std::string text;
    std::vector<Answer> answers;
};

/// What the first lines say.
struct CsvSight {
    std::vector<CsvDialect> candidates; ///< never empty; the dialect, when there are no questions
    std::vector<CsvQuestion> questions;
    std::size_t comments = 0; ///< lines skipped
    bool hasByteOrderMark = false;
    bool hasCrLf = false;
};

/// How a separator is written on the command line: ",", ";", "tab", "space", "none".
std::string separatorWord(char separator);
/// "0", "1", "units"
std::string headerWord(CsvHeader header);
std::size_t csvHeaderLines(CsvHeader header);

constexpr std::size_t DialectLines = 100; ///< what counts as the first lines of a table

/// Tries every dialect on the first lines of a text: each that reads them as numbers in equal columns is
/// possible. Several that read the same numbers are one; several that read different numbers, among them
/// those with thousands separators, which are not read, are a question: nothing is guessed. What the first
/// lines leave open of the decimal sign is looked for in the rest. Errors: InvalidInput with line and column
/// of `origin` where no dialect reads on, or with thousands separators as the only way to read it.
Result<CsvSight> detectDialect(std::string_view text, const std::string& origin, const CsvHints& hints);

} // namespace halbench::devices
