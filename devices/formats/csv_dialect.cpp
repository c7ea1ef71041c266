#include "devices/formats/csv_dialect.h"

#include "devices/formats/csv_attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace halbench::devices {

namespace {

constexpr std::array Separators = {',', ';', '\t', ' '};

/// The first row in which a decimal sign or a thousands separator may stand shows the difference.
const CsvLine* tellingLine(const std::vector<CsvLine>& lines) {
    for (const CsvLine& line : lines) {
        const bool begins = line.text.find_first_of("0123456789") == line.text.find_first_not_of(" \t\"+-");
        if (begins && line.text.find_first_of(".,") != std::string_view::npos) {
            return &line;
        }
    }
    return nullptr;
}

std::vector<CsvAttempt> attemptsFor(const std::vector<CsvLine>& lines, const CsvHints& hints) {
    std::vector<char> separators;
    for (const char separator : Separators) {
        const bool occurs = std::any_of(lines.begin(), lines.end(), [&](const CsvLine& line) {
            return line.text.find(separator) != std::string_view::npos;
        });
        if (hints.separator ? *hints.separator == separator : occurs) {
            separators.push_back(separator);
        }
    }
    if (hints.separator.value_or(0) == 0) {
        separators.push_back(0);
    }
    std::vector<CsvAttempt> attempts;
    for (const bool isGroupedToo : {false, true}) {
        for (const char separator : separators) {
            for (const char decimal : {'.', ','}) {
                const char other = decimal == ',' ? '.' : ',';
                if (hints.decimal.value_or(decimal) == decimal) {
                    attempts.emplace_back();
                    attempts.back().dialect = {separator, decimal, CsvHeader::Names};
                    attempts.back().group = static_cast<char>(isGroupedToo ? other : 0);
                }
            }
        }
    }
    return attempts;
}

void dropEqualReadings(std::vector<CsvAttempt>& alive) {
    for (std::size_t i = 0; i < alive.size(); ++i) {
        const auto isSame = [&](const CsvAttempt& other) {
            return other.hash == alive[i].hash && other.width == alive[i].width;
        };
        alive.erase(std::remove_if(alive.begin() + static_cast<std::ptrdiff_t>(i) + 1, alive.end(), isSame),
                    alive.end());
    }
}

bool isDecimalOpen(const std::vector<CsvAttempt>& alive) {
    for (const CsvAttempt& one : alive) {
        for (const CsvAttempt& other : alive) {
            if (one.dialect.separator == other.dialect.separator &&
                one.dialect.decimal != other.dialect.decimal) {
                return true;
            }
        }
    }
    return false;
}

struct Trials {
    std::vector<CsvAttempt> alive;
    std::vector<CsvAttempt> open;       ///< also those that have found no group so far
    std::optional<CsvAttempt> farthest; ///< of those that failed
};

/// The one that led farthest, and there the one with most columns, is most likely what was meant.
std::tuple<std::size_t, std::size_t, std::size_t> place(const CsvAttempt& attempt) {
    return {attempt.line, attempt.column, attempt.width};
}

Trials tryAll(std::vector<CsvAttempt> attempts, const std::vector<CsvLine>& lines, const CsvHints& hints) {
    Trials trials;
    const CsvLine* shown = tellingLine(lines);
    for (CsvAttempt& attempt : attempts) {
        const bool reads = tryToRead(attempt, lines, shown, hints);
        if (reads || attempt.line == 0) {
            trials.open.push_back(attempt);
        }
        if (reads) {
            trials.alive.push_back(attempt);
        } else if (!trials.farthest || place(attempt) > place(*trials.farthest)) {
            trials.farthest = attempt;
        }
    }
    return trials;
}

CsvQuestion numbersQuestion(const std::vector<CsvAttempt>& alive) {
    CsvQuestion question{"numbers", "the format of columns and numbers is uncertain", {}};
    const auto differs = [&](auto member) {
        return std::any_of(alive.begin(), alive.end(), [&](const CsvAttempt& attempt) {
            return attempt.dialect.*member != alive.front().dialect.*member;
        });
    };
    const bool isSeparatorOpen = differs(&CsvDialect::separator);
    const bool isDecimalAsked = differs(&CsvDialect::decimal) || !isSeparatorOpen;
    for (const CsvAttempt& attempt : alive) {
        std::string option;
        CsvHints hints;
        if (isSeparatorOpen) {
            option = "--separator '" + separatorWord(attempt.dialect.separator) + "'";
            hints.separator = attempt.dialect.separator;
        }
        if (isDecimalAsked) {
            option += fmt::format("{}--decimal {}", option.empty() ? "" : " ", attempt.dialect.decimal);
            hints.decimal = attempt.dialect.decimal;
        }
        question.answers.push_back(
            {option,
             attempt.sample +
                 (attempt.group != 0 ? " (thousands separators are not supported: remove them)" : ""),
             hints});
    }
    return question;
}

CsvQuestion headerQuestion(const CsvAttempt& attempt, const std::vector<CsvLine>& lines) {
    const bool hasNames = attempt.headers.front() != CsvHeader::None;
    CsvQuestion question{"header",
                         fmt::format("line {} may be a row of numbers or of {}",
                                     lines[hasNames && lines.size() > 1 ? 1 : 0].number,
                                     hasNames ? "units" : "names"),
                         {}};
    for (const CsvHeader header : attempt.headers) {
        const char* const meaning = header == CsvHeader::None    ? "no header: numbers from the first line on"
                                    : header == CsvHeader::Names ? "one line of names"
                                                                 : "a line of names, then one of units";
        question.answers.push_back({"--header " + headerWord(header), meaning, {{}, {}, header}});
    }
    return question;
}

tl::unexpected<Error> wrongAt(const std::string& origin, const CsvAttempt& attempt) {
    return failure(
        ErrorCode::InvalidInput,
        fmt::format("{}:{}:{}: {}", origin, attempt.line, attempt.column, attempt.problem),
        attempt.group != 0 ? "write numbers without thousands separators"
        : attempt.isCell
            ? "write a number, or leave the cell empty where a value is missing; remove a column of words; "
              "or "
              "set the format with --separator, --decimal and --header"
            : "a table has rows of equal length, up to two lines of names and units above, and comments "
              "beginning with #; set the format with --separator, --decimal and --header");
}

bool isInside(std::string_view text, char character) {
    const std::size_t at = text.find(character);
    return at != std::string_view::npos && at + 1 < text.size();
}

/// What is no text at all, or of another kind.
Result<void> checkText(std::string_view text, const std::string& origin) {
    const std::string_view head = text.substr(0, std::size_t{1} << 16);
    const bool isWide = head.substr(0, 2) == "\xFF\xFE" || head.substr(0, 2) == "\xFE\xFF";
    if (isWide || head.find('\0') != std::string_view::npos) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: {}", origin, isWide ? "UTF-16 text" : "zero bytes: not a text file"),
                       "save it as text in UTF-8");
    }
    if (head.find('\n') == std::string_view::npos && isInside(head, '\r')) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}:1:1: lines end with CR only", origin),
                       "save it with line ends LF or CR LF");
    }
    return {};
}

/// All lines up to a number of them; the first ones even when they are few.
std::vector<CsvLine> linesOf(CsvLines& reader, std::size_t limit) {
    std::vector<CsvLine> lines;
    CsvLine line;
    while (lines.size() < limit && reader.next(line)) {
        lines.push_back(line);
    }
    return lines;
}

Result<void> checkLines(const std::vector<CsvLine>& lines, const std::string& origin) {
    if (lines.empty()) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}:1:1: there are no rows", origin),
                       "give a file with rows of numbers");
    }
    for (const CsvLine& line : lines) {
        if (line.text.size() > MaxCsvLine) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format("{}:{}:1: the line has {} characters", origin, line.number, line.text.size()),
                fmt::format("at most {} are read", MaxCsvLine));
        }
    }
    return {};
}

} // namespace

std::string separatorWord(char separator) {
    switch (separator) {
    case '\t':
        return "tab";
    case ' ':
        return "space";
    case 0:
        return "none";
    default:
        return {separator};
    }
}

std::string headerWord(CsvHeader header) {
    return header == CsvHeader::None ? "0" : header == CsvHeader::Names ? "1" : "units";
}

std::size_t csvHeaderLines(CsvHeader header) {
    return header == CsvHeader::None ? 0 : header == CsvHeader::Names ? 1 : 2;
}

Result<CsvSight> detectDialect(std::string_view text, const std::string& origin, const CsvHints& hints) {
    if (const Result<void> isText = checkText(text, origin); !isText) {
        return failure(isText.error());
    }
    CsvLines reader(text);
    std::vector<CsvLine> lines = linesOf(reader, DialectLines);
    if (const Result<void> checked = checkLines(lines, origin); !checked) {
        return failure(checked.error());
    }
    Trials trials = tryAll(attemptsFor(lines, hints), lines, hints);
    if (isDecimalOpen(trials.alive) && lines.size() == DialectLines) {
        const std::vector<CsvLine> rest = linesOf(reader, text.size());
        lines.insert(lines.end(), rest.begin(), rest.end());
        if (const Result<void> checked = checkLines(lines, origin); !checked) {
            return failure(checked.error());
        }
        trials = tryAll(std::move(trials.open), lines, hints);
    }
    dropEqualReadings(trials.alive);
    if (trials.alive.empty()) {
        return wrongAt(origin, *trials.farthest);
    }
    CsvSight sight;
    sight.comments = reader.comments();
    sight.hasByteOrderMark = reader.hasByteOrderMark();
    sight.hasCrLf = reader.hasCrLf();
    for (const CsvAttempt& attempt : trials.alive) {
        for (const CsvHeader header : attempt.headers) {
            if (attempt.group == 0) {
                sight.candidates.push_back({attempt.dialect.separator, attempt.dialect.decimal, header});
            }
        }
    }
    if (sight.candidates.empty()) {
        return wrongAt(origin, trials.alive.front());
    }
    if (trials.alive.size() > 1) {
        sight.questions.push_back(numbersQuestion(trials.alive));
    } else if (trials.alive.front().headers.size() > 1) {
        sight.questions.push_back(headerQuestion(trials.alive.front(), lines));
    }
    return sight;
}

} // namespace halbench::devices
