#include "devices/acquisition/recording_csv.h"

#include "control/base/units.h"
#include "devices/acquisition/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace halbench::devices {

namespace {

constexpr std::size_t RowsBetweenChecks = 1000;
constexpr std::size_t MaxFile = std::size_t{256} << 20;
constexpr std::size_t MaxColumns = 1024;
/// Numbers are seldom shorter: no more room than this is taken before it is needed.
constexpr std::size_t OctetsPerValue = 4;

tl::unexpected<Error> wrongAt(const std::string& origin, std::size_t line, std::size_t column,
                              const std::string& what, const std::string& hint) {
    return failure(ErrorCode::InvalidInput, fmt::format("{}:{}:{}: {}", origin, line, column, what), hint);
}

/// One line cut into fields, without copying.
struct Line {
    std::string_view text;
    std::size_t number = 0;

    std::vector<std::string_view> fields() const {
        std::vector<std::string_view> result;
        std::size_t begin = 0;
        for (;;) {
            const std::size_t end = text.find(',', begin);
            result.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
            if (end == std::string_view::npos) {
                return result;
            }
            begin = end + 1;
        }
    }
};

class LineReader {
public:
    explicit LineReader(std::string_view text) : m_rest(text) {
        if (m_rest.substr(0, 3) == "\xEF\xBB\xBF") {
            m_rest.remove_prefix(3);
        }
    }
    bool next(Line& line) {
        if (m_rest.empty()) {
            return false;
        }
        const std::size_t end = m_rest.find('\n');
        line.text = m_rest.substr(0, end);
        m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
        if (!line.text.empty() && line.text.back() == '\r') {
            line.text.remove_suffix(1);
        }
        line.number = ++m_number;
        return true;
    }

private:
    std::string_view m_rest;
    std::size_t m_number = 0;
};

/// "hall_a_T" -> {"hall_a", "T"}: the longest unit suffix that fits.
StreamLayout::Column columnOf(std::string_view header) {
    StreamLayout::Column column{std::string(header), ""};
    std::size_t longest = 0;
    for (const Unit& unit : units()) {
        const std::size_t size = unit.suffix.size();
        const bool fits = size > longest && header.size() > size + 1 &&
                          header.substr(header.size() - size) == unit.suffix &&
                          header[header.size() - size - 1] == '_';
        if (fits) {
            longest = size;
            column = {std::string(header.substr(0, header.size() - size - 1)), std::string(unit.symbol)};
        }
    }
    return column;
}

bool readNumber(std::string_view field, double& value) {
    if (field.empty()) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    const auto parsed = std::from_chars(field.data(), field.data() + field.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != field.data() + field.size()) {
        return false;
    }
    if (!std::isfinite(value)) {
        value = std::numeric_limits<double>::quiet_NaN();
    }
    return true;
}

std::size_t columnPlace(const std::vector<std::string_view>& fields, std::size_t index) {
    return static_cast<std::size_t>(fields[index].data() - fields[0].data()) + 1;
}

Result<StreamLayout> readHeader(const Line& line, const std::string& origin) {
    const std::vector<std::string_view> fields = line.fields();
    constexpr const char* Hint = "a recording begins with the line time_s,SIGNAL_UNIT,...";
    if (fields[0] != "time_s") {
        return wrongAt(origin, line.number, 1, "the first column is not time_s", Hint);
    }
    if (fields.size() > MaxColumns) {
        return wrongAt(origin, line.number, 1, fmt::format("{} columns", fields.size()),
                       fmt::format("at most {} are read", MaxColumns));
    }
    StreamLayout layout;
    std::set<std::string_view> seen;
    for (std::size_t i = 1; i < fields.size(); ++i) {
        if (fields[i].empty() || !seen.insert(fields[i]).second) {
            return wrongAt(origin, line.number, columnPlace(fields, i),
                           fields[i].empty() ? std::string("a column has no name")
                                             : fmt::format("column '{}' is there twice", fields[i]),
                           Hint);
        }
        layout.columns.push_back(columnOf(fields[i]));
    }
    return layout;
}

/// The usual row, without a copy of its fields; false leaves the recording as it was: readRow() finds out
/// why.
bool readPlainRow(std::string_view line, std::size_t columns, Recording& recording) {
    const std::size_t values = recording.values.size();
    const char* at = line.data();
    const char* const end = at + line.size();
    double time_s = 0.0;
    bool isGood = true;
    for (std::size_t i = 0; isGood && i <= columns; ++i) {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (at != end && *at != ',') {
            const auto parsed = std::from_chars(at, end, value);
            isGood = parsed.ec == std::errc{} && std::isfinite(value);
            at = parsed.ptr;
        }
        const bool isEnd = at == end;
        isGood = isGood && isEnd == (i == columns) && (isEnd || *at == ',');
        at += isGood && !isEnd ? 1 : 0;
        if (i == 0) {
            time_s = value;
        } else {
            recording.values.push_back(value);
        }
    }
    isGood =
        isGood && std::isfinite(time_s) && (recording.time_s.empty() || time_s > recording.time_s.back());
    if (isGood) {
        recording.time_s.push_back(time_s);
    } else {
        recording.values.resize(values);
    }
    return isGood;
}

Result<void> readRow(const Line& line, const std::string& origin, std::size_t columns, Recording& recording) {
    const std::vector<std::string_view> fields = line.fields();
    if (fields.size() != columns + 1) {
        return wrongAt(origin, line.number, 1,
                       fmt::format("{} fields where the header has {}", fields.size(), columns + 1),
                       "the file may be cut off or damaged");
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        double value = 0.0;
        if (!readNumber(fields[i], value)) {
            return wrongAt(origin, line.number, columnPlace(fields, i),
                           fmt::format("'{}' is not a number", fields[i].substr(0, 40)),
                           "numbers are written like -1.5e-3, with a point");
        }
        (i == 0 ? recording.time_s : recording.values).push_back(value);
    }
    const std::size_t rows = recording.rows();
    const double time_s = recording.time_s.back();
    if (!std::isfinite(time_s) || (rows > 1 && time_s <= recording.time_s[rows - 2])) {
        return wrongAt(origin, line.number, 1, "the time does not increase", "sort the rows by time_s");
    }
    return {};
}

} // namespace

std::string csvColumnName(const std::string& signal, const std::string& unit) {
    std::string name = signal;
    std::replace(name.begin(), name.end(), '.', '_');
    const std::optional<Unit> known = findUnit(unit);
    if (known && !known->suffix.empty()) {
        name += '_';
        name += known->suffix;
    }
    return name;
}

std::string csvHeader(const StreamLayout& layout) {
    std::string text = "time_s";
    for (const StreamLayout::Column& column : layout.columns) {
        text += ',' + csvColumnName(column.name, column.unit);
    }
    return text + '\n';
}

void appendCsvNumber(std::string& text, double value, CsvNumbers numbers) {
    if (!std::isfinite(value)) {
        return;
    }
    char digits[40];
    std::to_chars_result end{};
    const auto narrow = static_cast<float>(value);
    const bool isFloat = numbers == CsvNumbers::BoardFloats && static_cast<double>(narrow) == value &&
                         value != std::floor(value);
    end = isFloat ? std::to_chars(digits, digits + sizeof digits, narrow)
                  : std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

void appendCsvRows(std::string& text, const SampleBlock& block, CsvNumbers numbers) {
    const std::size_t columns = block.layout->columns.size();
    for (std::size_t row = 0; row < block.rows(); ++row) {
        appendCsvNumber(text, block.time_s[row], numbers);
        for (std::size_t column = 0; column < columns; ++column) {
            text += ',';
            appendCsvNumber(text, block.value(row, column), numbers);
        }
        text += '\n';
    }
}

Result<Recording> parseRecordingCsv(std::string_view text, const std::string& origin,
                                    const std::function<Result<void>()>& checkAbort) {
    if (text.size() > MaxFile) {
        return failure(
            ErrorCode::InvalidInput, fmt::format("{}: {} octets", origin, text.size()),
            fmt::format("at most {} are read; cut the file into pieces that each begin with its first line",
                        MaxFile));
    }
    LineReader lines(text);
    Line line;
    if (!lines.next(line)) {
        return wrongAt(origin, 1, 1, "the file is empty", "a recording begins with the line time_s,...");
    }
    Result<StreamLayout> layout = readHeader(line, origin);
    if (!layout) {
        return failure(layout.error());
    }
    Recording recording;
    while (lines.next(line)) {
        if (line.text.empty()) {
            continue;
        }
        if (!readPlainRow(line.text, layout->columns.size(), recording)) {
            const Result<void> row = readRow(line, origin, layout->columns.size(), recording);
            if (!row) {
                return failure(row.error());
            }
        }
        if (recording.time_s.size() == 1) { // as many as there are if all are as long as the first
            const std::size_t rows = text.size() / (line.text.size() + 1) + 1;
            recording.time_s.reserve(rows);
            recording.values.reserve(std::min(rows * layout->columns.size(), text.size() / OctetsPerValue));
        }
        if (checkAbort && recording.time_s.size() % RowsBetweenChecks == 0) {
            if (const Result<void> goesOn = checkAbort(); !goesOn) {
                return failure(goesOn.error());
            }
        }
    }
    layout->period_s = nominalPeriod(recording.time_s);
    recording.lostRows = countLostRows(recording.time_s, layout->period_s);
    recording.layout = std::make_shared<const StreamLayout>(*std::move(layout));
    return recording;
}

} // namespace halbench::devices
