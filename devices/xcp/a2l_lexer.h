#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace halbench::devices::xcp {

enum class A2lTokenKind { Word, String, Begin, End, EndOfText };

struct A2lToken {
    A2lTokenKind kind = A2lTokenKind::EndOfText;
    std::string text;      ///< word, string without quotes (UTF-8), or name after /begin and /end
    std::size_t place = 0; ///< octet of its first character

    bool isWord(std::string_view word) const { return kind == A2lTokenKind::Word && text == word; }
};

/// Cuts a description into tokens, one ahead. The first error sticks: from then on only EndOfText comes, so
/// that every loop over tokens ends.
class A2lLexer {
public:
    explicit A2lLexer(std::string_view text);

    const A2lToken& peek() const { return m_next; }
    A2lToken take();
    bool isAtEnd() const { return m_next.kind == A2lTokenKind::EndOfText; }

    /// Remembers an error at a place unless there is one.
    void fail(std::size_t place, const std::string& what);
    const std::optional<Error>& error() const { return m_error; }

    /// Takes one token that must be a word, a string or a number; fails otherwise.
    std::string takeWord(std::string_view what);
    std::string takeString(std::string_view what);
    double takeNumber(std::string_view what);
    /// A whole number in [0, max].
    std::uint64_t takeUnsigned(std::string_view what, std::uint64_t max);

    /// After `/begin NAME` was taken: skips to behind its matching `/end`.
    void skipBlock(const A2lToken& begin);

private:
    void advance();
    bool skipBlanks();
    bool skipComment();
    void readString();
    void readWord();
    std::string_view wordAt(std::size_t place) const;

    std::string_view m_text;
    std::size_t m_place = 0;
    A2lToken m_next;
    std::optional<Error> m_error;
};

/// Decimal, hexadecimal (0x) or floating point; nothing when the text is none of them or not finite.
std::optional<double> a2lNumber(std::string_view text);

} // namespace halbench::devices::xcp
