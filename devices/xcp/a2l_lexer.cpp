#include "devices/xcp/a2l_lexer.h"

#include "devices/xcp/a2l.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t MaxWord = 1024;
constexpr std::size_t MaxString = 65536;
constexpr double ExactIntegerLimit =
    9007199254740992.0; // 2^53: larger whole numbers are not exact in a double

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v' || c == '\0';
}

/// Length of the UTF-8 sequence that starts here, 0 if it is none.
std::size_t sequenceLength(std::string_view text, std::size_t place) {
    const auto first = static_cast<unsigned char>(text[place]);
    std::size_t length = 0;
    if (first < 0x80) {
        return 1;
    } else if (first >= 0xC2 && first < 0xE0) {
        length = 2;
    } else if (first >= 0xE0 && first < 0xF0) {
        length = 3;
    } else if (first >= 0xF0 && first < 0xF5) {
        length = 4;
    } else {
        return 0;
    }
    if (place + length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((static_cast<unsigned char>(text[place + i]) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    return length;
}

bool isUtf8(std::string_view text) {
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = sequenceLength(text, place);
        if (length == 0) {
            return false;
        }
        place += length;
    }
    return true;
}

/// Texts that are not UTF-8 are taken as Latin-1 (3.13).
std::string asUtf8(std::string text) {
    if (isUtf8(text)) {
        return text;
    }
    std::string converted;
    for (const char c : text) {
        const auto octet = static_cast<unsigned char>(c);
        if (octet < 0x80) {
            converted += c;
        } else {
            converted += static_cast<char>(0xC0U | (octet >> 6));
            converted += static_cast<char>(0x80U | (octet & 0x3FU));
        }
    }
    return converted;
}

} // namespace

A2lLexer::A2lLexer(std::string_view text) : m_text(text) {
    if (text.size() > MaxA2lSize) {
        fail(MaxA2lSize, fmt::format("{} bytes exceed the allowed {}", text.size(), MaxA2lSize));
        return;
    }
    advance();
}

A2lToken A2lLexer::take() {
    A2lToken token = std::move(m_next);
    advance();
    return token;
}

void A2lLexer::fail(std::size_t place, const std::string& what) {
    if (!m_error) {
        m_error =
            Error{ErrorCode::InvalidInput, fmt::format("description of the device, byte {}: {}", place, what),
                  "update the board's firmware or report the description to its maker"};
    }
    m_place = m_text.size();
    m_next = A2lToken{A2lTokenKind::EndOfText, {}, place};
}

void A2lLexer::advance() {
    m_next = A2lToken{};
    while (skipBlanks() || skipComment()) {
    }
    if (m_error) {
        return;
    }
    m_next.place = m_place;
    if (m_place >= m_text.size()) {
        return;
    }
    if (m_text[m_place] == '"') {
        readString();
    } else {
        readWord();
    }
}

bool A2lLexer::skipBlanks() {
    const std::size_t start = m_place;
    while (m_place < m_text.size() && isBlank(m_text[m_place])) {
        ++m_place;
    }
    return m_place != start;
}

bool A2lLexer::skipComment() {
    const std::string_view rest = m_text.substr(m_place);
    if (rest.substr(0, 2) == "//") {
        const std::size_t end = rest.find('\n');
        m_place = end == std::string_view::npos ? m_text.size() : m_place + end;
        return true;
    }
    if (rest.substr(0, 2) == "/*") {
        const std::size_t end = rest.find("*/", 2);
        if (end == std::string_view::npos) {
            fail(m_place, "a comment does not end");
            return false;
        }
        m_place += end + 2;
        return true;
    }
    return false;
}

void A2lLexer::readString() {
    const std::size_t start = m_place;
    std::string text;
    for (std::size_t i = start + 1; i < m_text.size() && text.size() <= MaxString; ++i) {
        const char c = m_text[i];
        const char following = i + 1 < m_text.size() ? m_text[i + 1] : '\0';
        if ((c == '\\' && (following == '"' || following == '\\')) || (c == '"' && following == '"')) {
            text += following;
            ++i;
        } else if (c == '"') {
            m_place = i + 1;
            m_next.kind = A2lTokenKind::String;
            m_next.text = asUtf8(std::move(text));
            return;
        } else {
            text += c;
        }
    }
    fail(start, text.size() > MaxString ? "a text is too long" : "a text does not end");
}

std::string_view A2lLexer::wordAt(std::size_t place) const {
    std::size_t end = place;
    while (end < m_text.size() && !isBlank(m_text[end]) && m_text[end] != '"') {
        const bool isComment = m_text[end] == '/' && end > place && end + 1 < m_text.size() &&
                               (m_text[end + 1] == '*' || m_text[end + 1] == '/');
        if (isComment) {
            break;
        }
        ++end;
    }
    return m_text.substr(place, end - place);
}

void A2lLexer::readWord() {
    std::string_view word = wordAt(m_place);
    if (word.size() > MaxWord) {
        fail(m_place, "a word is too long");
        return;
    }
    m_place += word.size();
    m_next.kind = A2lTokenKind::Word;
    if (word == "/begin" || word == "/end") {
        m_next.kind = word == "/begin" ? A2lTokenKind::Begin : A2lTokenKind::End;
        const std::size_t start = m_place;
        while (skipBlanks() || skipComment()) {
        }
        if (m_error) {
            return;
        }
        word = wordAt(m_place);
        if (word.empty() || word.size() > MaxWord || word[0] == '/') {
            fail(start, "the name of a block is missing");
            return;
        }
        m_place += word.size();
    }
    m_next.text = asUtf8(std::string(word));
}

std::string A2lLexer::takeWord(std::string_view what) {
    if (m_next.kind != A2lTokenKind::Word) {
        fail(m_next.place, fmt::format("{} is missing", what));
        return {};
    }
    return take().text;
}

std::string A2lLexer::takeString(std::string_view what) {
    if (m_next.kind != A2lTokenKind::String) {
        fail(m_next.place, fmt::format("{} is missing (a text in quotes)", what));
        return {};
    }
    return take().text;
}

double A2lLexer::takeNumber(std::string_view what) {
    const std::size_t place = m_next.place;
    const std::string word = takeWord(what);
    const std::optional<double> number = a2lNumber(word);
    if (!number && !m_error) {
        fail(place, fmt::format("{}: '{}' is not a number", what, word));
    }
    return number.value_or(0.0);
}

std::uint64_t A2lLexer::takeUnsigned(std::string_view what, std::uint64_t max) {
    const std::size_t place = m_next.place;
    const double number = takeNumber(what);
    if (m_error) {
        return 0;
    }
    if (number < 0.0 || number != std::floor(number) || number >= ExactIntegerLimit ||
        number > static_cast<double>(max)) {
        fail(place, fmt::format("{}: {} is not a whole number from 0 to {}", what, number, max));
        return 0;
    }
    return static_cast<std::uint64_t>(number);
}

void A2lLexer::skipBlock(const A2lToken& begin) {
    std::vector<std::string> open = {begin.text};
    while (!open.empty()) {
        if (isAtEnd()) {
            fail(begin.place, fmt::format("block {} does not end", begin.text));
            return;
        }
        const A2lToken token = take();
        if (token.kind == A2lTokenKind::Begin) {
            open.push_back(token.text);
            if (open.size() > static_cast<std::size_t>(MaxA2lNesting)) {
                fail(token.place, fmt::format("blocks are nested deeper than {}", MaxA2lNesting));
                return;
            }
        } else if (token.kind == A2lTokenKind::End) {
            if (token.text != open.back()) {
                fail(token.place,
                     fmt::format("found /end {} where /end {} is expected", token.text, open.back()));
                return;
            }
            open.pop_back();
        }
    }
}

std::optional<double> a2lNumber(std::string_view text) {
    const bool isNegative = !text.empty() && text[0] == '-';
    std::string_view digits = isNegative || (!text.empty() && text[0] == '+') ? text.substr(1) : text;
    if (digits.empty()) {
        return std::nullopt;
    }
    double value = 0.0;
    const char* end = digits.data() + digits.size();
    std::from_chars_result result{};
    if (digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
        std::uint64_t whole = 0;
        result = std::from_chars(digits.data() + 2, end, whole, 16);
        value = static_cast<double>(whole);
    } else {
        if (digits[0] == '-' || digits[0] == '+') {
            return std::nullopt;
        }
        result = std::from_chars(digits.data(), end, value);
    }
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return isNegative ? -value : value;
}

} // namespace halbench::devices::xcp
