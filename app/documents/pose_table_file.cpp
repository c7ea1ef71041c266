#include "app/documents/pose_table_file.h"

#include "app/documents/text/output_file.h"
#include "control/base/unit_conversion.h"
#include "devices/formats/csv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace halbench::app {
namespace {

using devices::CellKind;
using devices::CsvCell;
using devices::CsvLine;

constexpr std::string_view Example = "Write a header like time_s,x_mm,y_mm,phi_mrad.";

tl::unexpected<Error> wrongAt(const std::string& origin, std::size_t line, std::size_t column,
                              const std::string& what, std::string_view hint) {
    return failure(ErrorCode::InvalidInput, fmt::format("{}:{}:{}: {}", origin, line, column, what),
                   std::string(hint));
}

/// What one column of the file is.
struct Heading {
    bool isTime = false;
    UnitConversion toSi;
    PoseTable::Column column;
};

/// How the cells of a file are written.
struct Dialect {
    char separator = ',';
    char decimal = '.';
};

char separatorOf(std::string_view header) {
    for (const char separator : {';', '\t'}) {
        if (header.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    return ',';
}

Result<Heading> readHeading(const std::string& origin, const CsvLine& line, const CsvCell& cell) {
    Heading heading;
    heading.column.name = std::string(cell.text);
    heading.column.place = cell.column;
    const std::size_t mark = cell.text.rfind('_');
    const bool hasUnit = mark != std::string_view::npos && mark > 0 && mark + 1 < cell.text.size();
    if (!hasUnit) {
        return wrongAt(origin, line.number, cell.column,
                       fmt::format("column '{}' has no unit in its name", cell.text), Example);
    }
    heading.column.axis = std::string(cell.text.substr(0, mark));
    const std::string_view unit = cell.text.substr(mark + 1);
    heading.isTime = heading.column.axis == "time";
    const std::vector<std::string_view> quantities =
        heading.isTime ? std::vector<std::string_view>{"s"} : std::vector<std::string_view>{"m", "rad"};
    for (const std::string_view quantity : quantities) {
        if (const auto conversion = conversionBetween(unit, quantity)) {
            heading.toSi = *conversion;
            heading.column.unit = std::string(quantity);
            return heading;
        }
    }
    return wrongAt(origin, line.number, cell.column,
                   fmt::format("column '{}': '{}' is no unit of a {}", cell.text, unit,
                               heading.isTime ? "time" : "length or an angle"),
                   heading.isTime ? "Write time_s or time_ms."
                                  : "Write e.g. x_mm, x_m, phi_mrad or phi_deg.");
}

class TableReader {
public:
    TableReader(std::string_view text, std::string origin) : m_lines(text) {
        m_table.origin = std::move(origin);
    }

    Result<PoseTable> read();

private:
    Result<void> readHeader();
    Result<void> readRow(const CsvLine& line);
    Result<double> numberIn(const CsvLine& line, const CsvCell& cell, const Heading& heading);
    Result<void> split(const CsvLine& line);
    Result<void> checkTime(const CsvLine& line, std::size_t column) const;
    Result<void> checkHeadings(std::size_t line) const;

    devices::CsvLines m_lines;
    Dialect m_dialect;
    bool m_isDecimalKnown = false;
    std::vector<Heading> m_headings;
    std::vector<CsvCell> m_cells;
    PoseTable m_table;
};

Result<void> TableReader::split(const CsvLine& line) {
    if (line.text.size() > devices::MaxCsvLine) {
        return wrongAt(m_table.origin, line.number, 1,
                       fmt::format("the line has {} characters", line.text.size()),
                       fmt::format("At most {} are read.", devices::MaxCsvLine));
    }
    if (!devices::splitCsv(line.text, m_dialect.separator, m_cells)) {
        return wrongAt(m_table.origin, line.number, m_cells.back().column, "a quoted cell does not end",
                       "Write numbers without quotes.");
    }
    return {};
}

Result<void> TableReader::checkHeadings(std::size_t line) const {
    for (auto heading = m_headings.begin(); heading != m_headings.end(); ++heading) {
        const auto same = std::find_if(m_headings.begin(), heading, [&](const Heading& before) {
            return before.column.axis == heading->column.axis;
        });
        if (same != heading) {
            return wrongAt(m_table.origin, line, heading->column.place,
                           heading->isTime
                               ? std::string("the time is given twice")
                               : fmt::format("axis {} is given twice, as {} and {}", heading->column.axis,
                                             same->column.name, heading->column.name),
                           "Keep one of the columns.");
        }
    }
    const bool hasAxis = std::any_of(m_headings.begin(), m_headings.end(),
                                     [](const Heading& heading) { return !heading.isTime; });
    return hasAxis ? Result<void>()
                   : wrongAt(m_table.origin, line, 1, "the table has no column of an axis", Example);
}

Result<void> TableReader::readHeader() {
    CsvLine line;
    if (!m_lines.next(line)) {
        return wrongAt(m_table.origin, 1, 1, "the file is empty", Example);
    }
    m_dialect.separator = separatorOf(line.text);
    if (auto cut = split(line); !cut) {
        return cut;
    }
    if (m_cells.size() > 1 && m_cells.back().text.empty()) {
        m_cells.pop_back(); // a separator at the end of the line
    }
    for (const CsvCell& cell : m_cells) {
        auto heading = readHeading(m_table.origin, line, cell);
        if (!heading) {
            return failure(heading.error());
        }
        m_headings.push_back(*std::move(heading));
    }
    m_table.headerLine = line.number;
    for (const Heading& heading : m_headings) {
        if (!heading.isTime) {
            m_table.columns.push_back(heading.column);
        }
    }
    return checkHeadings(line.number);
}

/// With a separator that is no comma, the first number with a comma or a point says which is the decimal sign
/// of the file: rows of whole numbers before it say nothing.
Result<double> TableReader::numberIn(const CsvLine& line, const CsvCell& cell, const Heading& heading) {
    const std::size_t sign = cell.text.find_first_of(",.");
    if (m_dialect.separator != ',' && !m_isDecimalKnown && sign != std::string_view::npos) {
        m_dialect.decimal = cell.text[sign];
        m_isDecimalKnown = true;
    }
    double value = 0.0;
    const CellKind kind = devices::readCell(cell.text, m_dialect.decimal, value);
    if (kind == CellKind::Number && std::isfinite(value)) {
        return heading.toSi(value);
    }
    const std::string_view shown = cell.text.substr(0, 40);
    return wrongAt(m_table.origin, line.number, cell.column,
                   cell.text.empty()
                       ? fmt::format("{} has no value", heading.column.name)
                       : fmt::format("'{}' is not a finite number ({})", shown, heading.column.name),
                   fmt::format("Write numbers like -1{}5e-3 in every cell.", m_dialect.decimal));
}

Result<void> TableReader::checkTime(const CsvLine& line, std::size_t column) const {
    const std::vector<double>& time_s = m_table.time_s;
    if (time_s.back() < 0.0) {
        return wrongAt(m_table.origin, line.number, column, "the time is negative",
                       "Times count from the start of the motion.");
    }
    const std::size_t rows = time_s.size();
    if (rows > 1 && time_s[rows - 1] <= time_s[rows - 2]) {
        return wrongAt(m_table.origin, line.number, column,
                       fmt::format("time {} s comes after {} s", time_s[rows - 1], time_s[rows - 2]),
                       "Sort the rows by time, each time once.");
    }
    return {};
}

Result<void> TableReader::readRow(const CsvLine& line) {
    if (m_table.rows.size() == MaxPoseRows) {
        return wrongAt(m_table.origin, line.number, 1, fmt::format("more than {} rows", MaxPoseRows),
                       "Split the table.");
    }
    if (auto cut = split(line); !cut) {
        return cut;
    }
    const std::size_t width = m_headings.size();
    if (m_cells.size() == width + 1 && m_cells.back().text.empty()) {
        m_cells.pop_back(); // a separator at the end of the line
    }
    if (m_cells.size() != width) {
        return wrongAt(m_table.origin, line.number, m_cells.size() > width ? m_cells[width].column : 1,
                       fmt::format("{} cells, but the header has {} columns", m_cells.size(), width),
                       "Give every column a value; the separator is that of the header.");
    }
    std::vector<double> pose;
    for (std::size_t i = 0; i < width; ++i) {
        const auto value = numberIn(line, m_cells[i], m_headings[i]);
        if (!value) {
            return failure(value.error());
        }
        if (!m_headings[i].isTime) {
            pose.push_back(*value);
            continue;
        }
        m_table.time_s.push_back(*value);
        if (auto sorted = checkTime(line, m_cells[i].column); !sorted) {
            return sorted;
        }
    }
    m_table.rows.push_back(std::move(pose));
    m_table.lines.push_back(line.number);
    return {};
}

Result<PoseTable> TableReader::read() {
    if (auto header = readHeader(); !header) {
        return failure(header.error());
    }
    CsvLine line;
    while (m_lines.next(line)) {
        if (auto row = readRow(line); !row) {
            return failure(row.error());
        }
    }
    const std::size_t rows = m_table.rows.size();
    if (rows < 2) {
        return wrongAt(m_table.origin, m_table.headerLine + rows, 1,
                       rows == 0 ? "the table has no rows" : "the table has one row only",
                       "Give two poses or more, a line each. For one pose use a travel, e.g. s-curve.");
    }
    return std::move(m_table);
}

} // namespace

Result<PoseTable> parsePoseTable(std::string_view text, const std::string& origin) {
    if (text.size() > MaxPoseTableOctets) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("{}: the table has {} octets, {} are read", origin, text.size(), MaxPoseTableOctets),
            fmt::format("Split the table; {} rows are the most.", MaxPoseRows));
    }
    if (text.find('\0') != std::string_view::npos) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: the file is no text", origin),
                       std::string(Example));
    }
    return TableReader(text, origin).read();
}

Result<void> readTableOf(MoveReference& reference) {
    if (!isTable(reference)) {
        return {};
    }
    const Result<std::string> text = readFile(reference.file);
    if (!text) {
        return failure(text.error());
    }
    Result<PoseTable> table = parsePoseTable(*text, reference.file);
    return table ? attachTable(reference, *std::move(table)) : failure(table.error());
}

} // namespace halbench::app
