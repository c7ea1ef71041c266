#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

// Lines, cells and numbers of tables that other programs wrote: resources/help/command-line.md, "Import".
// The locale plays no part.

constexpr std::size_t MaxCsvLine = std::size_t{1} << 16; ///< characters; longer lines are refused

/// A line that carries something, and its number in the file, from 1.
struct CsvLine {
    std::string_view text;
    std::size_t number = 0;
};

/// Walks over a text line by line (LF or CR LF) past its byte order mark, empty lines and comments, which are
/// lines that begin with # or %.
class CsvLines {
public:
    explicit CsvLines(std::string_view text);
    bool next(CsvLine& line);

    bool hasByteOrderMark() const { return m_hasMark; }
    std::size_t comments() const { return m_comments; } ///< skipped so far
    /// Of the lines seen so far.
    bool hasCrLf() const { return m_hasCrLf; }
    bool hasLf() const { return m_hasLf; }

private:
    std::string_view m_rest;
    std::size_t m_number = 0;
    std::size_t m_comments = 0;
    bool m_hasMark = false;
    bool m_hasCrLf = false;
    bool m_hasLf = false;
};

/// One cell without the blanks around it and without its quotes; doubled quotes inside stay doubled.
struct CsvCell {
    std::string_view text;
    std::size_t column = 1; ///< of its first character in the line, from 1
};

/// Cuts a line. `separator`: ',', ';', tab, a blank (any number of blanks is one, those around the line are
/// none), or 0: the whole line is one cell. False: a quote is not closed, or something follows it; the last
/// cell then says where.
bool splitCsv(std::string_view line, char separator, std::vector<CsvCell>& cells);

enum class CellKind {
    Number,
    Missing, ///< empty, or a word for "no number" (nan, NA, null, inf ...)
    Text,
    TooLarge, ///< a number that no 64-bit floating point number can hold
};

/// Reads a cell as the double nearest to what is written. `decimal`: '.' or ','. NaN for Missing.
CellKind readCell(std::string_view text, char decimal, double& value);

/// "1,234" or "-12,345,678.5" with the mark ',': groups of three digits, as thousands are written.
bool isGrouped(std::string_view text, char mark);
/// The number of a grouped cell whose decimal sign is the other one of '.' and ','; only for saying what it
/// would mean.
double groupedValue(std::string_view text, char mark);

} // namespace halbench::devices
