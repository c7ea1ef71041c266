#include "devices/formats/csv_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace halbench::devices {

namespace {

constexpr std::size_t LongestNumber = 400; // characters of a number with a decimal comma

bool isBlank(char character) {
    return character == ' ' || character == '\t';
}

bool isDigit(char character) {
    return character >= '0' && character <= '9';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// Blanks that are no separators.
std::size_t skipBlanks(std::string_view line, std::size_t at, char separator) {
    while (at < line.size() && line[at] != separator && isBlank(line[at])) {
        ++at;
    }
    return at;
}

std::size_t skipSpaces(std::string_view line, std::size_t at) {
    while (at < line.size() && line[at] == ' ') {
        ++at;
    }
    return at;
}

/// Behind the quote that ends the cell whose quote opened at `at`; npos: there is none.
std::size_t closingQuote(std::string_view line, std::size_t at) {
    for (std::size_t i = at + 1; i < line.size(); ++i) {
        if (line[i] != '"') {
            continue;
        }
        if (i + 1 < line.size() && line[i + 1] == '"') {
            ++i;
            continue;
        }
        return i;
    }
    return std::string_view::npos;
}

bool isMissingWord(std::string_view text) {
    constexpr std::array Words = {"nan",     "na",      "n/a",      "#n/a",     "null",      "none",
                                  "inf",     "-inf",    "+inf",     "infinity", "-nan",      "-infinity",
                                  "1.#inf",  "-1.#inf", "+nan",     "<na>",     "1.#qnan",   "-1.#qnan",
                                  "-1.#ind", "1.#ind",  "nan(ind)", "#nv",      "-nan(ind)", "+infinity"};
    std::string small(text.substr(0, 16));
    std::transform(small.begin(), small.end(), small.begin(), [](char character) {
        return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
    });
    return text.empty() || (text.size() <= 16 && std::find(Words.begin(), Words.end(), small) != Words.end());
}

/// With the point; a sign, then at least one digit, so that no word is taken for a number.
CellKind readPointNumber(std::string_view text, double& value) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
    const bool hasDigit =
        text.size() > sign &&
        (isDigit(text[sign]) || (text[sign] == '.' && text.size() > sign + 1 && isDigit(text[sign + 1])));
    if (!hasDigit) {
        return CellKind::Text;
    }
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ptr != text.data() + text.size()) {
        return CellKind::Text;
    }
    return parsed.ec == std::errc{} && std::isfinite(value) ? CellKind::Number : CellKind::TooLarge;
}

/// A comma is a decimal sign only between two digits: "1," and ",5" are pieces of a list.
CellKind readCommaNumber(std::string_view text, double& value) {
    const std::size_t comma = text.find(',');
    if (text.find('.') != std::string_view::npos || text.size() > LongestNumber) {
        return CellKind::Text;
    }
    if (comma == std::string_view::npos) {
        return readPointNumber(text, value);
    }
    if (comma == 0 || comma + 1 == text.size() || !isDigit(text[comma - 1]) || !isDigit(text[comma + 1])) {
        return CellKind::Text;
    }
    std::array<char, LongestNumber> copy{};
    std::copy(text.begin(), text.end(), copy.begin());
    copy[comma] = '.';
    return readPointNumber({copy.data(), text.size()}, value);
}

std::string withoutMark(std::string_view text, char mark) {
    std::string plain;
    for (const char character : text) {
        if (character != mark) {
            plain += character == ',' ? '.' : character;
        }
    }
    return plain;
}

} // namespace

CsvLines::CsvLines(std::string_view text) : m_rest(text) {
    if (m_rest.substr(0, 3) == "\xEF\xBB\xBF") {
        m_rest.remove_prefix(3);
        m_hasMark = true;
    }
}

bool CsvLines::next(CsvLine& line) {
    while (!m_rest.empty()) {
        const std::size_t end = m_rest.find('\n');
        line.text = m_rest.substr(0, end);
        m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
        line.number = ++m_number;
        const bool isCrLf = !line.text.empty() && line.text.back() == '\r';
        if (isCrLf) {
            line.text.remove_suffix(1);
        }
        m_hasCrLf = m_hasCrLf || isCrLf;
        m_hasLf = m_hasLf || (!isCrLf && end != std::string_view::npos);
        const std::string_view content = trimmed(line.text);
        if (!content.empty() && (content[0] == '#' || content[0] == '%')) {
            ++m_comments;
        } else if (!content.empty()) {
            return true;
        }
    }
    return false;
}

bool splitCsv(std::string_view line, char separator, std::vector<CsvCell>& cells) {
    cells.clear();
    const bool areRuns = separator == ' ';
    std::size_t at = areRuns ? skipSpaces(line, 0) : 0;
    for (;;) {
        const std::size_t begin = skipBlanks(line, at, separator);
        std::size_t end = 0;
        if (begin < line.size() && line[begin] == '"') {
            const std::size_t close = closingQuote(line, begin);
            const std::size_t text = begin + 1;
            cells.push_back(
                {line.substr(text, close == std::string_view::npos ? close : close - text), begin + 1});
            end = close == std::string_view::npos ? line.size() : skipBlanks(line, close + 1, separator);
            if (close == std::string_view::npos || (end < line.size() && line[end] != separator)) {
                return false;
            }
        } else {
            end = separator == 0 ? line.size() : std::min(line.find(separator, begin), line.size());
            cells.push_back({trimmed(line.substr(begin, end - begin)), begin + 1});
        }
        at = areRuns ? skipSpaces(line, end) : end + 1;
        if (end >= line.size() || (areRuns && at >= line.size())) {
            return true;
        }
    }
}

CellKind readCell(std::string_view text, char decimal, double& value) {
    const CellKind kind = decimal == ',' ? readCommaNumber(text, value) : readPointNumber(text, value);
    if (kind == CellKind::Text && isMissingWord(text)) {
        value = std::numeric_limits<double>::quiet_NaN();
        return CellKind::Missing;
    }
    return kind;
}

bool isGrouped(std::string_view text, char mark) {
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
        text.remove_prefix(1);
    }
    std::size_t first = 0;
    while (first < text.size() && isDigit(text[first])) {
        ++first;
    }
    if (first == 0 || first > 3 || text[0] == '0') {
        return false;
    }
    text.remove_prefix(first);
    std::size_t groups = 0;
    while (text.size() >= 4 && text[0] == mark && isDigit(text[1]) && isDigit(text[2]) && isDigit(text[3])) {
        text.remove_prefix(4);
        ++groups;
    }
    if (groups > 0 && !text.empty() && text[0] == (mark == ',' ? '.' : ',')) {
        text.remove_prefix(1);
        while (!text.empty() && isDigit(text[0])) {
            text.remove_prefix(1);
        }
    }
    return groups > 0 && text.empty();
}

double groupedValue(std::string_view text, char mark) {
    const std::string plain = withoutMark(text, mark);
    double value = std::numeric_limits<double>::quiet_NaN();
    return readPointNumber(plain, value) == CellKind::Number ? value
                                                             : std::numeric_limits<double>::quiet_NaN();
}

} // namespace halbench::devices
