#include "devices/formats/csv_columns.h"

#include "control/base/unit_conversion.h"
#include "devices/formats/csv_headers.h"
#include "devices/formats/foreign_unit.h"
#include "devices/formats/known_signals.h"
#include "devices/recording/recording_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace halbench::devices {

namespace {

constexpr std::size_t NamedColumns = 8; // of a question

bool isLetter(char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

/// Letters, digits, '_' and '.', whatever the header says: what a recording's first line can hold.
std::string plainName(const std::string& text) {
    std::string plain;
    for (const char character : text) {
        const bool isKept = isLetter(character) || (character >= '0' && character <= '9') || character == '.';
        if (isKept) {
            plain += character;
        } else if (!plain.empty() && plain.back() != '_') {
            plain += '_';
        }
    }
    while (!plain.empty() && plain.back() == '_') {
        plain.pop_back();
    }
    return plain;
}

std::string listOf(const std::vector<CsvColumn>& columns) {
    std::string list;
    for (std::size_t i = 0; i < std::min(columns.size(), NamedColumns); ++i) {
        list += (i == 0 ? "" : ", ") +
                (columns[i].header.empty() ? std::to_string(i + 1) : "'" + columns[i].header + "'");
    }
    return list + (columns.size() > NamedColumns ? ", ..." : "");
}

/// By header, by its name without the unit, or by number.
Result<std::size_t> findColumn(const std::vector<CsvColumn>& columns, const std::string& text) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!text.empty() && (columns[i].header == text || columns[i].name == text)) {
            found.push_back(i);
        }
    }
    if (found.size() > 1) {
        return failure(ErrorCode::Usage, fmt::format("{} columns are called '{}'", found.size(), text),
                       fmt::format("give its number: {} or {}", found[0] + 1, found[1] + 1));
    }
    std::size_t number = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
    if (found.empty() && isNumber && number >= 1 && number <= columns.size()) {
        found.push_back(number - 1);
    }
    if (found.empty()) {
        return failure(
            ErrorCode::UnknownName, fmt::format("the table has no column '{}'", text),
            fmt::format("it has {}; a number from 1 to {} also names one", listOf(columns), columns.size()));
    }
    return found.front();
}

Result<void> applyUnits(std::vector<CsvColumn>& columns, const CsvImportRequest& request) {
    for (const auto& [theirs, unit] : request.units) {
        const Result<std::size_t> column = findColumn(columns, theirs);
        if (!column) {
            return failure(column.error());
        }
        if (!readForeignUnit(unit)) {
            return failure(ErrorCode::UnknownName, fmt::format("'{}' is not a known unit", unit),
                           "for example s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, or - for none");
        }
        setUnit(columns[*column], unit);
    }
    return {};
}

Result<void> checkName(const std::string& signal) {
    if (isTimeName(signal)) {
        return failure(ErrorCode::Usage,
                       fmt::format("'{}' is not allowed as a signal name: it is the time", signal),
                       "choose the time column with --time, or give --rate_Hz");
    }
    if (plainName(signal) != signal || signal.empty() || !isLetter(signal[0])) {
        return failure(ErrorCode::Usage, fmt::format("'{}' is not allowed as a signal name", signal),
                       "a name has letters, digits, '.' and '_' and begins with a letter");
    }
    return {};
}

Result<void> applyMap(std::vector<CsvColumn>& columns, const CsvImportRequest& request) {
    std::set<std::string> ours;
    std::set<std::size_t> theirs;
    for (const auto& [signal, header] : request.map) {
        const Result<std::size_t> column = findColumn(columns, header);
        if (!column) {
            return failure(column.error());
        }
        if (const Result<void> name = checkName(signal); !name) {
            return name;
        }
        if (!ours.insert(signal).second) {
            return failure(ErrorCode::Usage, fmt::format("the name '{}' is given to two columns", signal),
                           "use a different name for each column");
        }
        if (!theirs.insert(*column).second) {
            return failure(ErrorCode::Usage, fmt::format("column '{}' is given two names", header),
                           "give every column one name");
        }
        columns[*column].signal = signal;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) { // a mapped name wins over one of the table
        if (theirs.count(i) == 0 && ours.count(columns[i].signal) != 0) {
            columns[i].signal.clear();
        }
    }
    return {};
}

bool isTime(const CsvColumn& column) {
    return column.isUnitKnown && column.unit == "s";
}

/// By its name; or the first column, when it alone is in a unit of time.
std::vector<std::size_t> timeCandidates(const std::vector<CsvColumn>& columns) {
    std::vector<std::size_t> byName;
    std::size_t inTime = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (isTimeName(columns[i].name)) {
            byName.push_back(i);
        }
        inTime += isTime(columns[i]) ? 1 : 0;
    }
    if (byName.empty() && inTime == 1 && isTime(columns[0])) {
        byName.push_back(0);
    }
    return byName;
}

std::string shellWord(const std::string& text) {
    const bool isPlain = std::all_of(text.begin(), text.end(), [](char character) {
        return isLetter(character) || (character >= '0' && character <= '9') || character == '_';
    });
    return isPlain ? text : "'" + text + "'";
}

void askForTime(CsvColumns& result) {
    CsvQuestion question{"time", "the time column is uncertain", {}};
    for (std::size_t i = 0; i < std::min(result.columns.size(), NamedColumns); ++i) {
        const std::string word = columnWord(result.columns, i);
        question.answers.push_back({"--time " + shellWord(word), fmt::format("column {}", i + 1), {}, word});
    }
    question.answers.push_back({"--rate_Hz F", "no time column: F rows per second", {}, {}, {}, true});
    result.questions.push_back(std::move(question));
}

void askForUnit(CsvColumns& result, std::size_t index, const std::vector<std::string>& units) {
    const std::string word = columnWord(result.columns, index);
    CsvQuestion question{"unit", fmt::format("the unit of column '{}' is unknown", word), {}};
    for (const std::string& unit : units) {
        question.answers.push_back(
            {"--unit " + shellWord(word + "=" + unit), "unit of its numbers: " + unit, {}, {}, {word, unit}});
    }
    result.questions.push_back(std::move(question));
}

Result<void> chooseTime(CsvColumns& result, const CsvImportRequest& request) {
    if (request.rate_Hz) {
        return {};
    }
    if (!request.timeColumn.empty()) {
        const Result<std::size_t> column = findColumn(result.columns, request.timeColumn);
        if (!column) {
            return failure(column.error());
        }
        result.time = *column;
    } else {
        const std::vector<std::size_t> candidates = timeCandidates(result.columns);
        if (candidates.size() != 1) {
            askForTime(result);
            return {};
        }
        result.time = candidates[0];
    }
    const CsvColumn& time = result.columns[*result.time];
    if (!time.isUnitKnown) {
        askForUnit(result, *result.time, {"s", "ms", "us"});
    } else if (time.unit != "s") {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("column '{}' is in {}, which is not a time unit",
                                   columnWord(result.columns, *result.time), time.written),
                       "choose another column with --time, or give its unit with --unit");
    }
    return {};
}

/// Somebody said the unit: the header is not asked again.
bool isUnitGiven(const CsvColumns& result, std::size_t index, const CsvImportRequest& request) {
    return std::any_of(request.units.begin(), request.units.end(), [&](const auto& given) {
        const Result<std::size_t> column = findColumn(result.columns, given.first);
        return column && *column == index;
    });
}

Result<void> checkQuantities(CsvColumns& result, const CsvImportRequest& request) {
    for (std::size_t i = 0; i < result.columns.size(); ++i) {
        CsvColumn& column = result.columns[i];
        if (isTemperatureName(column.name) && column.isUnitKnown && column.unit == "rad" &&
            !isUnitGiven(result, i, request)) { // "temp [deg]"
            askForUnit(result, i, {"degC", column.written});
            continue;
        }
        const std::optional<std::string> due = unitOfKnownSignal(column.signal);
        if (!due || due->empty() || result.time == i) {
            continue;
        }
        if (*due == "degC" && column.unit == "K") { // of a temperature, no difference
            column.unit = *due;
            column.offset = conversionBetween("K", *due)->offset;
        }
        if (!column.isUnitKnown) {
            askForUnit(result, i,
                       *due == "rad/s"  ? std::vector<std::string>{"rad/s", "rpm", "deg/s"}
                       : *due == "rad"  ? std::vector<std::string>{"rad", "deg"}
                       : *due == "degC" ? std::vector<std::string>{"degC"}
                                        : std::vector<std::string>{*due, "m" + *due});
        } else if (column.unit != *due) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("column '{}' is in {}, but {} is in {}", columnWord(result.columns, i),
                                       column.written.empty() ? "no unit" : column.written, column.signal,
                                       *due),
                           "map another column with --map, or give its unit with --unit");
        }
    }
    return {};
}

/// Every signal has a name that its column in a recording keeps apart from the others.
void nameSignals(CsvColumns& result) {
    std::set<std::string> taken = {"time_s"};
    const auto take = [&](const CsvColumn& column, const std::string& name) {
        return taken.insert(csvColumnName(name, column.unit)).second;
    };
    for (CsvColumn& column : result.columns) { // those that are sure of their name come first
        if (!column.signal.empty() && !take(column, column.signal)) {
            column.signal.clear();
        }
    }
    for (std::size_t i = 0; i < result.columns.size(); ++i) {
        CsvColumn& column = result.columns[i];
        if (!column.signal.empty() || result.time == i) {
            continue;
        }
        const std::string plain = plainName(column.name);
        const bool isName = !plain.empty() && isLetter(plain[0]);
        const std::string base = isName          ? plain
                                 : plain.empty() ? fmt::format("column_{}", i + 1)
                                                 : "column_" + plain; // "1x": a number would not be a name
        std::string name = base;
        for (int number = 2; !take(column, name); ++number) {
            name = fmt::format("{}_{}", base, number);
        }
        column.signal = name;
    }
}

} // namespace

std::string columnWord(const std::vector<CsvColumn>& columns, std::size_t index) {
    const Result<std::size_t> found = findColumn(columns, columns[index].header);
    return found && *found == index ? columns[index].header : std::to_string(index + 1);
}

CsvImportRequest answered(CsvImportRequest request, const CsvQuestion::Answer& answer) {
    const CsvHints& hints = answer.hints;
    request.hints.separator = hints.separator ? hints.separator : request.hints.separator;
    request.hints.decimal = hints.decimal ? hints.decimal : request.hints.decimal;
    request.hints.header = hints.header ? hints.header : request.hints.header;
    if (!answer.timeColumn.empty()) {
        request.timeColumn = answer.timeColumn;
    }
    if (!answer.unit.first.empty()) {
        request.units.push_back(answer.unit);
    }
    return request;
}

Result<CsvColumns> arrangeColumns(const std::vector<std::string>& names,
                                  const std::vector<std::string>& units, std::size_t width,
                                  const CsvImportRequest& request) {
    CsvColumns result;
    result.columns = readHeaders(names, units, width);
    if (const Result<void> done = applyUnits(result.columns, request); !done) {
        return failure(done.error());
    }
    if (const Result<void> done = applyMap(result.columns, request); !done) {
        return failure(done.error());
    }
    if (const Result<void> done = chooseTime(result, request); !done) {
        return failure(done.error());
    }
    if (result.time) {
        CsvColumn& time = result.columns[*result.time];
        for (const auto& [signal, theirs] : request.map) {
            if (signal == time.signal) {
                return failure(
                    ErrorCode::Usage,
                    fmt::format("column '{}' is the time and cannot be called '{}'", theirs, signal),
                    "choose the time column with --time, or give --rate_Hz");
            }
        }
        time.signal.clear();
    }
    if (const Result<void> done = checkQuantities(result, request); !done) {
        return failure(done.error());
    }
    nameSignals(result);
    return result;
}

} // namespace halbench::devices
