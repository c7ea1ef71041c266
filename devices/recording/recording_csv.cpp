#include "devices/recording/recording_csv.h"

#include "control/base/unit_conversion.h"
#include "control/base/units.h"
#include "devices/recording/time_axis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace halbench::devices {

namespace {

constexpr std::size_t RowsBetweenChecks = 1000;
constexpr std::size_t MaxLine = std::size_t{1} << 20;
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

/// "time_ms", "time [us]", "time (min)": the first column counts in another unit of time than seconds.
std::optional<UnitConversion> timeConversion(std::string_view header) {
    constexpr std::string_view Name = "time";
    if (header.size() < Name.size() + 2 || header.substr(0, Name.size()) != Name) {
        return std::nullopt;
    }
    std::string_view unit = header.substr(Name.size());
    unit.remove_prefix(unit.front() == '_' || unit.front() == ' ' ? 1 : 0);
    const bool isBracketed = unit.size() > 2 && ((unit.front() == '[' && unit.back() == ']') ||
                                                 (unit.front() == '(' && unit.back() == ')'));
    if (isBracketed) {
        unit = unit.substr(1, unit.size() - 2);
    } else if (header[Name.size()] != '_') {
        return std::nullopt;
    }
    return conversionBetween(unit, "s");
}

Result<StreamLayout> readHeader(const Line& line, const std::string& origin, bool isTime = false) {
    const std::vector<std::string_view> fields = line.fields();
    constexpr const char* Hint =
        "a recording begins with the line time_s,SIGNAL_UNIT,...; read other tables with 'halbench import'";
    if (fields[0] != "time_s" && !isTime) {
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
                                             : fmt::format("column '{}' occurs twice", fields[i]),
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
                           "write numbers like -1.5e-3, with a decimal point");
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

Result<StreamLayout> parseCsvHeader(std::string_view line, const std::string& origin) {
    return readHeader({line, 1}, origin);
}

bool appendCsvRow(std::string_view line, std::size_t columns, Recording& recording) {
    return readPlainRow(line, columns, recording);
}

std::string csvColumnName(const std::string& signal, const std::string& unit) {
    static constexpr std::string_view NotInHeaders = ".,\"\n\r";
    std::string name = signal;
    std::replace_if(
        name.begin(), name.end(),
        [](char character) { return NotInHeaders.find(character) != std::string_view::npos; }, '_');
    const std::optional<Unit> known = findUnit(unit);
    if (known && !known->suffix.empty()) {
        name += '_';
        name += known->suffix;
    }
    return name;
}

std::vector<std::string> csvColumnNames(const StreamLayout& layout) {
    std::set<std::string> taken = {"time_s"};
    std::vector<std::string> names;
    for (const StreamLayout::Column& column : layout.columns) {
        std::string name = csvColumnName(column.name, column.unit);
        for (int number = 2; !taken.insert(name).second; ++number) {
            name = csvColumnName(fmt::format("{}_{}", column.name, number), column.unit);
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::string csvHeader(const StreamLayout& layout) {
    return fmt::format("time_s{}{}\n", layout.columns.empty() ? "" : ",",
                       fmt::join(csvColumnNames(layout), ","));
}

namespace {

/// More than any number takes: 17 digits, sign, point and exponent.
constexpr std::size_t MaxDigits = 40;

/// Behind the digits of `value`; where they would begin for what is no number.
char* putDigits(char* at, double value, CsvNumbers numbers) {
    if (!std::isfinite(value)) {
        return at;
    }
    const auto narrow = static_cast<float>(value);
    const bool isFloat = numbers == CsvNumbers::BoardFloats && static_cast<double>(narrow) == value &&
                         value != std::floor(value);
    return isFloat ? std::to_chars(at, at + MaxDigits, narrow).ptr
                   : std::to_chars(at, at + MaxDigits, value).ptr;
}

} // namespace

void appendCsvNumber(std::string& text, double value, CsvNumbers numbers) {
    char digits[MaxDigits];
    text.append(digits, putDigits(digits, value, numbers));
}

void appendCsvRows(std::string& text, const SampleBlock& block, CsvNumbers numbers) {
    const std::size_t columns = block.layout->columns.size();
    std::vector<char> line((columns + 1) * (MaxDigits + 1)); // a line at once: the text grows once a row
    for (std::size_t row = 0; row < block.rows(); ++row) {
        char* at = putDigits(line.data(), block.time_s[row], numbers);
        for (std::size_t column = 0; column < columns; ++column) {
            *at++ = ',';
            at = putDigits(at, block.value(row, column), numbers);
        }
        *at++ = '\n';
        text.append(line.data(), at);
    }
}

RecordingCsvParser::RecordingCsvParser(std::string origin, std::uint64_t expected_octets,
                                       std::uint64_t most_octets, std::function<Result<void>()> checkAbort)
    : m_origin(std::move(origin)), m_expected_octets(expected_octets), m_most_octets(most_octets),
      m_checkAbort(std::move(checkAbort)) {}

Result<void> RecordingCsvParser::feed(std::string_view piece) {
    while (!piece.empty()) {
        const std::size_t end = piece.find('\n');
        const std::string_view text = piece.substr(0, end);
        if (m_begun.size() + text.size() > MaxLine) {
            return wrongAt(m_origin, m_number + 1, 1,
                           fmt::format("more than {} characters in a line", MaxLine),
                           "the file may be damaged or not a recording");
        }
        if (end == std::string_view::npos) {
            m_begun += text;
            return {};
        }
        piece.remove_prefix(end + 1);
        m_begun += m_begun.empty() ? std::string_view() : text;
        const Result<void> done = takeLine(m_begun.empty() ? text : std::string_view(m_begun));
        if (!done) {
            return done;
        }
        m_begun.clear();
    }
    return {};
}

Result<void> RecordingCsvParser::takeLine(std::string_view text) {
    if (!text.empty() && text.back() == '\r') {
        text.remove_suffix(1);
    }
    if (++m_number == 1) {
        text.remove_prefix(text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
        m_toSeconds = timeConversion(text.substr(0, text.find(','))).value_or(UnitConversion{});
        const bool isTime = !m_toSeconds.isIdentity();
        Result<StreamLayout> layout = readHeader({text, m_number}, m_origin, isTime);
        if (!layout) {
            return failure(layout.error());
        }
        m_layout = *std::move(layout);
        return {};
    }
    if (text.empty()) {
        return {};
    }
    const std::size_t columns = m_layout.columns.size();
    if (!readPlainRow(text, columns, m_recording)) {
        if (const Result<void> row = readRow({text, m_number}, m_origin, columns, m_recording); !row) {
            return row;
        }
    }
    if (m_recording.rows() == 1) {
        makeRoom(text.size());
    }
    return m_recording.rows() % RowsBetweenChecks == 0 ? check() : Result<void>();
}

Result<void> RecordingCsvParser::check() const {
    const std::uint64_t octets =
        sizeof(double) * (std::uint64_t{m_recording.time_s.size()} + m_recording.values.size());
    if (octets > m_most_octets) {
        return wrongAt(m_origin, m_number, 1,
                       fmt::format("its numbers need more than {} MB of memory", m_most_octets >> 20U),
                       "split the file; each part begins with its first line");
    }
    return m_checkAbort ? m_checkAbort() : Result<void>();
}

/// As many rows as there are if all are as long as the first.
void RecordingCsvParser::makeRoom(std::size_t rowOctets) {
    const auto rows = static_cast<std::size_t>(m_expected_octets / (rowOctets + 1) + 1);
    m_recording.time_s.reserve(rows);
    m_recording.values.reserve(std::min(rows * m_layout.columns.size(),
                                        static_cast<std::size_t>(m_expected_octets / OctetsPerValue)));
}

Result<Recording> RecordingCsvParser::finish() {
    if (!m_begun.empty()) {
        const Result<void> done = takeLine(m_begun);
        if (!done) {
            return failure(done.error());
        }
    }
    if (m_number == 0) {
        return wrongAt(m_origin, 1, 1, "the file is empty", "a recording begins with the line time_s,...");
    }
    if (!m_toSeconds.isIdentity()) {
        std::ranges::transform(m_recording.time_s, m_recording.time_s.begin(), m_toSeconds);
    }
    m_layout.period_s = nominalPeriod(m_recording.time_s);
    m_recording.lostRows = countLostRows(m_recording.time_s, m_layout.period_s);
    m_recording.layout = std::make_shared<const StreamLayout>(std::move(m_layout));
    return std::move(m_recording);
}

Result<Recording> parseRecordingCsv(std::string_view text, const std::string& origin,
                                    const std::function<Result<void>()>& checkAbort) {
    RecordingCsvParser parser(origin, text.size(), std::numeric_limits<std::uint64_t>::max(), checkAbort);
    if (const Result<void> done = parser.feed(text); !done) {
        return failure(done.error());
    }
    return parser.finish();
}

} // namespace halbench::devices
