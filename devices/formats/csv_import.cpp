#include "devices/formats/csv_import.h"

#include "control/base/assert.h"
#include "devices/formats/csv_text.h"
#include "devices/recording/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace halbench::devices {

namespace {

constexpr std::size_t RowsBetweenChecks = 1000;
constexpr double UniformShare = 0.01;

bool isDigit(char character) {
    return character >= '0' && character <= '9';
}

/// A number with a decimal comma at `at`; behind it, or nullptr for anything that is not quite plain.
const char* readComma(const char* at, const char* end, char separator, double& value) {
    std::array<char, 64> copy{};
    std::size_t size = 0;
    bool hasComma = false;
    for (; at != end && *at != separator && *at != ' '; ++at) {
        char character = *at;
        if (size == copy.size() || character == '.') {
            return nullptr;
        }
        if (character == ',') {
            const bool isBetweenDigits =
                size > 0 && isDigit(copy[size - 1]) && at + 1 != end && isDigit(at[1]);
            if (hasComma || !isBetweenDigits) {
                return nullptr;
            }
            hasComma = true;
            character = '.';
        }
        copy[size++] = character;
    }
    const auto parsed = std::from_chars(copy.data(), copy.data() + size, value);
    return parsed.ec == std::errc{} && parsed.ptr == copy.data() + size ? at : nullptr;
}

const char* readPoint(const char* at, const char* end, double& value) {
    const auto parsed = std::from_chars(at, end, value);
    return parsed.ec == std::errc{} ? parsed.ptr : nullptr;
}

const char* skipBlanks(const char* at, const char* end) {
    while (at != end && *at == ' ') {
        ++at;
    }
    return at;
}

/// A line of plain numbers only; false for any other, which splitCsv() and readCell() then judge.
bool readPlainLine(std::string_view line, const CsvDialect& dialect, std::vector<double>& values) {
    const char* at = line.data();
    const char* const end = at + line.size();
    const char separator = dialect.separator;
    for (std::size_t i = 0; i < values.size(); ++i) {
        at = skipBlanks(at, end);
        at =
            dialect.decimal == ',' ? readComma(at, end, separator, values[i]) : readPoint(at, end, values[i]);
        if (at == nullptr || !std::isfinite(values[i])) {
            return false;
        }
        const char* const next = skipBlanks(at, end);
        if (i + 1 == values.size()) {
            const bool hasEmptyEnd = separator != 0 && next != end && *next == separator && next + 1 == end;
            return next == end || hasEmptyEnd;
        }
        if (separator == ' ' ? next == at || next == end : next == end || *next != separator) {
            return false;
        }
        at = separator == ' ' ? next : next + 1;
    }
    return true;
}

class RowReader {
public:
    RowReader(const CsvPlan& plan, const std::string& origin)
        : m_plan(plan), m_origin(origin), m_values(plan.columns.size()) {}

    Result<void> read(const CsvLine& line, CsvImport& import);

private:
    tl::unexpected<Error> wrongAt(const CsvLine& line, std::size_t column, const std::string& what,
                                  const std::string& hint) const;
    tl::unexpected<Error> wrongCell(const CsvLine& line, const CsvCell& cell, CellKind kind) const;
    Result<void> readCells(const CsvLine& line);
    Result<void> appendTime(const CsvLine& line, CsvImport& import) const;

    const CsvPlan& m_plan;
    const std::string& m_origin;
    std::vector<double> m_values;
    std::vector<CsvCell> m_cells;
};

tl::unexpected<Error> RowReader::wrongAt(const CsvLine& line, std::size_t column, const std::string& what,
                                         const std::string& hint) const {
    return failure(ErrorCode::InvalidInput, fmt::format("{}:{}:{}: {}", m_origin, line.number, column, what),
                   hint);
}

tl::unexpected<Error> RowReader::wrongCell(const CsvLine& line, const CsvCell& cell, CellKind kind) const {
    const std::string text(cell.text.substr(0, 40));
    if (kind == CellKind::TooLarge) {
        return wrongAt(line, cell.column, fmt::format("'{}' is out of the number range", text),
                       "numbers range from about 1e-308 to 1e308");
    }
    for (const char mark : {',', '.', ' ', '\''}) {
        const bool isDecimal = mark == m_plan.dialect->decimal;
        if (!isDecimal && isGrouped(cell.text, mark)) {
            return wrongAt(line, cell.column, fmt::format("'{}' is written with thousands separators", text),
                           "write numbers without thousands separators");
        }
    }
    const auto column = static_cast<std::size_t>(&cell - m_cells.data());
    return wrongAt(
        line, cell.column,
        fmt::format("'{}' is not a number (column {}, '{}')", text, column + 1,
                    m_plan.columns[column].header),
        fmt::format("write numbers like -1{}5e-3, leave the cell empty where a value is missing, or "
                    "set --decimal",
                    m_plan.dialect->decimal));
}

Result<void> RowReader::readCells(const CsvLine& line) {
    if (line.text.size() > MaxCsvLine) {
        return wrongAt(line, 1, fmt::format("the line has {} characters", line.text.size()),
                       fmt::format("at most {} are read", MaxCsvLine));
    }
    if (!splitCsv(line.text, m_plan.dialect->separator, m_cells)) {
        return wrongAt(line, m_cells.back().column, "a quoted cell does not end as it should",
                       "a quote inside a quoted cell is written twice");
    }
    const std::size_t width = m_values.size();
    const bool hasEmptyEnd = m_cells.size() == width + 1 && m_cells.back().text.empty();
    if (m_cells.size() != width && !hasEmptyEnd) {
        return wrongAt(line, m_cells.size() > width ? m_cells[width].column : 1,
                       fmt::format("{} cells where the table has {} columns", m_cells.size(), width),
                       "the file may be cut off or damaged");
    }
    for (std::size_t i = 0; i < width; ++i) {
        const CellKind kind = readCell(m_cells[i].text, m_plan.dialect->decimal, m_values[i]);
        if (kind == CellKind::Text || kind == CellKind::TooLarge) {
            return wrongCell(line, m_cells[i], kind);
        }
    }
    return {};
}

Result<void> RowReader::appendTime(const CsvLine& line, CsvImport& import) const {
    std::vector<double>& times = import.recording.time_s;
    if (!m_plan.time) {
        times.push_back(static_cast<double>(times.size()) / *m_plan.rate_Hz);
        return {};
    }
    const CsvColumn& column = m_plan.columns[*m_plan.time];
    const double time_s = column.inSi(m_values[*m_plan.time]);
    if (!std::isfinite(time_s)) {
        return wrongAt(line, m_cells[*m_plan.time].column,
                       fmt::format("the time is missing (column {}, '{}')", *m_plan.time + 1, column.header),
                       "remove the row, or give --rate_Hz instead");
    }
    if (!times.empty() && time_s <= times.back()) {
        return wrongAt(line, 1,
                       fmt::format("the time does not increase: {} s after {} s", time_s, times.back()),
                       "sort the rows by time, choose another column with --time, or give --rate_Hz");
    }
    times.push_back(time_s);
    return {};
}

Result<void> RowReader::read(const CsvLine& line, CsvImport& import) {
    const bool isPlain =
        line.text.size() <= MaxCsvLine && readPlainLine(line.text, *m_plan.dialect, m_values);
    if (const Result<void> cells = isPlain ? Result<void>() : readCells(line); !cells) {
        return cells;
    }
    if (const Result<void> time = appendTime(line, import); !time) {
        return time;
    }
    for (std::size_t i = 0; i < m_values.size(); ++i) {
        if (m_plan.time != i) {
            const CsvColumn& column = m_plan.columns[i];
            const double value = column.inSi(m_values[i]);
            if (!std::isfinite(value) && import.missing++ == 0) {
                import.firstMissing =
                    fmt::format("line {}, column {}, '{}'", line.number, i + 1, column.header);
            }
            import.recording.values.push_back(
                std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN());
        }
    }
    return {};
}

StreamLayout layoutOf(const CsvPlan& plan) {
    StreamLayout layout;
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        if (plan.time != i) {
            layout.columns.push_back({plan.columns[i].signal, plan.columns[i].unit});
        }
    }
    return layout;
}

void judgeTime(CsvImport& import, double period_s) {
    const std::vector<double>& times = import.recording.time_s;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step_s = times[i] - times[i - 1];
        import.shortestStep_s = i == 1 ? step_s : std::min(import.shortestStep_s, step_s);
        import.longestStep_s = std::max(import.longestStep_s, step_s);
    }
    const double longestAllowed_s = (1.0 + UniformShare) * period_s;
    const double shortestAllowed_s = (1.0 - UniformShare) * period_s;
    import.isUniform = times.size() < 2 || (import.shortestStep_s >= shortestAllowed_s &&
                                            import.longestStep_s <= longestAllowed_s);
}

} // namespace

Result<CsvImport> importCsv(std::string_view text, const std::string& origin, const CsvPlan& plan,
                            const std::function<Result<void>()>& checkAbort) {
    HB_ASSERT(plan.dialect.has_value() && plan.questions.empty());
    CsvLines lines(text);
    CsvLine line;
    for (std::size_t i = 0; i < csvHeaderLines(plan.dialect->header); ++i) {
        lines.next(line);
    }
    CsvImport import;
    RowReader reader(plan, origin);
    while (lines.next(line)) {
        if (const Result<void> row = reader.read(line, import); !row) {
            return failure(row.error());
        }
        if (checkAbort && import.recording.rows() % RowsBetweenChecks == 0) {
            if (const Result<void> goesOn = checkAbort(); !goesOn) {
                return failure(goesOn.error());
            }
        }
    }
    StreamLayout layout = layoutOf(plan);
    layout.period_s = nominalPeriod(import.recording.time_s);
    import.recording.lostRows = countLostRows(import.recording.time_s, layout.period_s);
    judgeTime(import, layout.period_s);
    import.recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return import;
}

} // namespace halbench::devices
