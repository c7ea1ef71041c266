#include "devices/formats/csv_attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace halbench::devices {

namespace {

constexpr std::size_t ShownCells = 4;

/// A line under one attempt.
struct Row {
    std::vector<CsvCell> cells;
    std::size_t numbers = 0;
    std::size_t texts = 0;
    const CsvCell* firstText = nullptr;
    const CsvCell* firstGrouped = nullptr;
    std::vector<double> values;
    bool isCut = false; ///< a quote that is not closed

    /// "1;2;": as many programs end their lines.
    bool endsEmpty() const { return cells.size() > 1 && cells.back().text.empty(); }
};

void readRow(std::string_view line, const CsvAttempt& attempt, Row& row) {
    row.isCut = !splitCsv(line, attempt.dialect.separator, row.cells);
    row.numbers = row.texts = 0;
    row.firstText = row.firstGrouped = nullptr;
    row.values.clear();
    for (const CsvCell& cell : row.cells) {
        double value = std::numeric_limits<double>::quiet_NaN();
        CellKind kind = readCell(cell.text, attempt.dialect.decimal, value);
        if (kind == CellKind::Text && attempt.group != 0 && isGrouped(cell.text, attempt.group)) {
            kind = CellKind::Number;
            value = groupedValue(cell.text, attempt.group);
            row.firstGrouped = row.firstGrouped == nullptr ? &cell : row.firstGrouped;
        }
        row.numbers += kind == CellKind::Number || kind == CellKind::TooLarge ? 1 : 0;
        row.texts += kind == CellKind::Text ? 1 : 0;
        row.firstText = kind == CellKind::Text && row.firstText == nullptr ? &cell : row.firstText;
        row.values.push_back(value);
    }
}

/// Other separators in a unit, or in the name of a single column, tell that the line is cut wrongly.
bool hasSeparators(const CsvLine& line, const CsvAttempt& attempt) {
    Row row;
    readRow(line.text, attempt, row);
    return std::any_of(row.cells.begin(), row.cells.end(), [](const CsvCell& cell) {
        return cell.text.find_first_of(",;\t") != std::string_view::npos;
    });
}

/// What the first two lines can be: more than one possibility where a line is neither all numbers nor without
/// any.
std::vector<CsvHeader> possibleHeaders(const std::vector<CsvLine>& lines, const CsvAttempt& attempt) {
    Row first;
    readRow(lines[0].text, attempt, first);
    if (first.texts == 0) {
        return first.numbers > 0 ? std::vector{CsvHeader::None}
                                 : std::vector{CsvHeader::None, CsvHeader::Names};
    }
    Row second;
    if (lines.size() > 1) {
        readRow(lines[1].text, attempt, second);
    }
    std::vector<CsvHeader> headers;
    if (first.numbers > 0) {
        headers.push_back(CsvHeader::None);
    }
    const bool mayBeUnits =
        lines.size() > 1 && (second.numbers == 0 || second.texts > 0) && !hasSeparators(lines[1], attempt);
    if (second.texts == 0 || second.numbers > 0 || !mayBeUnits) {
        headers.push_back(CsvHeader::Names);
    }
    if (mayBeUnits) {
        headers.push_back(CsvHeader::NamesAndUnits);
    }
    return headers;
}

void mix(std::uint64_t& hash, double value) { // FNV-1a
    std::uint64_t bits = 0;
    const double canonical = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
    std::memcpy(&bits, &canonical, sizeof bits);
    hash = (hash ^ bits) * 0x100000001B3ULL;
}

std::string sampleOf(const std::vector<double>& values, std::size_t width) {
    std::string text = fmt::format("{} column{}:", width, width == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(width, ShownCells); ++i) {
        text += fmt::format("{} {}", i == 0 ? "" : " |", values[i]);
    }
    return text + (width > ShownCells ? " ..." : "");
}

/// How many cells a row has, by the header or else by the first row.
std::size_t widthOf(const std::vector<CsvLine>& lines, const CsvAttempt& attempt, std::size_t dataBegin) {
    Row row;
    readRow(lines[0].text, attempt, row);
    bool endEmpty = row.endsEmpty();
    const std::size_t cells = row.cells.size();
    for (std::size_t i = dataBegin; dataBegin == 0 && endEmpty && i < lines.size(); ++i) {
        readRow(lines[i].text, attempt, row);
        endEmpty = row.endsEmpty();
    }
    return cells - (endEmpty ? 1 : 0);
}

/// "column 2" or, below a line of names, "column 2, 'state'".
std::string columnWords(const CsvLine& names, const CsvAttempt& attempt, std::size_t column) {
    std::string words = fmt::format("column {}", column + 1);
    if (attempt.headers.back() != CsvHeader::None) {
        Row row;
        readRow(names.text, attempt, row);
        words += column < row.cells.size() ? fmt::format(", '{}'", row.cells[column].text.substr(0, 40)) : "";
    }
    return words;
}

bool acceptRow(CsvAttempt& attempt, const CsvLine& names, const CsvLine& line, const Row& row) {
    const std::size_t cells = row.cells.size();
    if (row.isCut) {
        return attempt.fail(line.number, row.cells.back().column, "a quoted cell does not end as it should");
    }
    if (cells != attempt.width && !(cells == attempt.width + 1 && row.endsEmpty())) {
        return attempt.fail(line.number, 1,
                            fmt::format("{} cells where there are {} before", cells, attempt.width));
    }
    if (row.firstText != nullptr) {
        const auto column = static_cast<std::size_t>(row.firstText - row.cells.data());
        attempt.isCell = true;
        return attempt.fail(line.number, row.firstText->column,
                            fmt::format("'{}' is not a number ({})", row.firstText->text.substr(0, 40),
                                        columnWords(names, attempt, column)));
    }
    return true;
}

} // namespace

bool tryToRead(CsvAttempt& attempt, const std::vector<CsvLine>& lines, const CsvLine* shown,
               const CsvHints& hints) {
    attempt.line = attempt.column = 0;
    attempt.headers = hints.header ? std::vector{*hints.header} : possibleHeaders(lines, attempt);
    const std::size_t dataBegin = csvHeaderLines(attempt.headers.back());
    attempt.width = widthOf(lines, attempt, dataBegin);
    attempt.hash = attempt.width;
    const bool isOneByChance = attempt.dialect.separator == 0 && !hints.separator && dataBegin > 0;
    if (isOneByChance && lines[0].text.front() != '"' && hasSeparators(lines[0], attempt)) {
        return attempt.fail(lines[0].number, 1, "the names of several columns where there is one");
    }
    if (dataBegin >= lines.size()) {
        return attempt.fail(lines.back().number, 1, "there are no rows of numbers");
    }
    Row row;
    bool hasGroups = false;
    for (std::size_t i = dataBegin; i < lines.size(); ++i) {
        readRow(lines[i].text, attempt, row);
        if (!acceptRow(attempt, lines.front(), lines[i], row)) {
            return false;
        }
        for (std::size_t cell = 0; cell < attempt.width; ++cell) {
            mix(attempt.hash, row.values[cell]);
        }
        if (i == dataBegin || &lines[i] == shown) {
            attempt.sample = sampleOf(row.values, attempt.width);
        }
        if (row.firstGrouped != nullptr && !hasGroups) {
            hasGroups = true;
            attempt.fail(lines[i].number, row.firstGrouped->column,
                         fmt::format("'{}' is written with thousands separators",
                                     row.firstGrouped->text.substr(0, 40)));
        }
    }
    return attempt.group == 0 || hasGroups; // without groups it is another attempt once more
}

} // namespace halbench::devices
