#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "control/base/unit_conversion.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

// Recordings as text: resources/help/command-line.md, "Recording (CSV)". Pure functions of text; the locale
// plays no part.

/// Column of a signal: '.' becomes '_', then '_' and the unit's suffix: "hall.a", "T" -> "hall_a_T".
std::string csvColumnName(const std::string& signal, const std::string& unit);

/// Columns of all signals, in their order: one that another signal or the time has already gets a number,
/// "a_b_A" and "a_b_2_A". The sidecar tells the signals.
std::vector<std::string> csvColumnNames(const StreamLayout& layout);

/// "time_s,position_rad,...\n"
std::string csvHeader(const StreamLayout& layout);

/// How a value that is exactly a 4-octet float is written.
enum class CsvNumbers {
    BoardFloats, ///< in the precision of that type: what boards send
    Exact        ///< as every other: what was read from a file goes back to the last bit
};

/// Appends the rows of a block. Numbers are the shortest that read back to the same value. A value that is no
/// number is an empty field.
void appendCsvRows(std::string& text, const SampleBlock& block, CsvNumbers numbers = CsvNumbers::BoardFloats);

/// Shortest decimal of one value, as in the rows above.
void appendCsvNumber(std::string& text, double value, CsvNumbers numbers = CsvNumbers::BoardFloats);

/// Reads such a text. Columns become signals named by the column without its unit suffix; an empty field,
/// "nan" and "inf" read as NaN. A first column in another unit of time ("time_ms", "time [us]") is converted.
/// Rows missing in the time axis are counted as lost. Errors: InvalidInput with line and column of `origin`
/// (no time_s column, wrong number of fields, text where a number is due, time that does not increase, a line
/// of more than a megabyte); that of `checkAbort`, which is asked every thousand rows.
Result<Recording> parseRecordingCsv(std::string_view text, const std::string& origin,
                                    const std::function<Result<void>()>& checkAbort = {});

/// "time_s,position_rad,..." without its end. Errors: InvalidInput with line 1 and column of `origin`.
Result<StreamLayout> parseCsvHeader(std::string_view line, const std::string& origin);
/// Appends a row as appendCsvRows() writes it, without its end; false leaves the recording as it was: another
/// number of fields, text, or a time that does not increase.
bool appendCsvRow(std::string_view line, std::size_t columns, Recording& recording);

/// The same piece by piece: of a long file only the numbers are in memory, never its text.
class RecordingCsvParser {
public:
    /// `expected_octets`: of the whole text, for taking room once. `most_octets`: of memory for the numbers;
    /// a recording that needs more is refused (InvalidInput, with the line).
    RecordingCsvParser(std::string origin, std::uint64_t expected_octets, std::uint64_t most_octets,
                       std::function<Result<void>()> checkAbort = {});

    /// Errors: as parseRecordingCsv(). After one nothing more is fed.
    Result<void> feed(std::string_view piece);
    Result<Recording> finish();

private:
    Result<void> takeLine(std::string_view text);
    Result<void> check() const;
    void makeRoom(std::size_t rowOctets);

    std::string m_origin;
    std::uint64_t m_expected_octets;
    std::uint64_t m_most_octets;
    std::function<Result<void>()> m_checkAbort;
    std::string m_begun; ///< of a line whose end has not come
    std::size_t m_number = 0;
    UnitConversion m_toSeconds; ///< of the first column
    StreamLayout m_layout;
    Recording m_recording;
};

} // namespace halbench::devices
