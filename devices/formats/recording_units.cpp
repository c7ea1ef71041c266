#include "devices/formats/recording_units.h"

#include "control/base/unit_conversion.h"
#include "control/base/units.h"
#include "devices/formats/foreign_unit.h"
#include "devices/formats/known_signals.h"
#include "devices/recording/recording_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace halbench::devices {

namespace {

/// Units of raw values, which no table converts; "grad" is a degree in German, else a gon.
constexpr std::array RawUnits = {"count", "counts", "tick", "ticks", "step", "steps",
                                 "lsb",   "digits", "inc",  "grad",  "Grad", "pulses"};

constexpr const char* UnitWarning = "unit"; // begins every warning about one

struct WrittenUnit {
    std::string signal;
    std::string unit; ///< as it is written
};

std::string headerOf(const StreamLayout::Column& column) {
    const std::optional<Unit> unit = findUnit(column.unit);
    return unit && !unit->suffix.empty() ? column.name + '_' + std::string(unit->suffix) : column.name;
}

/// Words in a column's name have '_' where a unit has '/': "deg_s", "r_min".
std::string unitOfWord(const std::string& word, const std::string& due) {
    if (const auto foreign = readForeignUnit(word); foreign && foreign->symbol == due) {
        return word;
    }
    std::string quotient = word;
    if (quotient.find("_per_") == std::string::npos) {
        std::replace(quotient.begin(), quotient.end(), '_', '/');
    }
    return quotient;
}

bool isUnitWord(const std::string& word, const std::string& due) {
    const bool isStatistic = word == "min"; // of a minute nobody counts angles: the smallest
    const bool isRaw = std::find(RawUnits.begin(), RawUnits.end(), word) != RawUnits.end();
    const bool isNumber =
        !word.empty() && word.front() >= '0' && word.front() <= '9'; // "position_1": the first of several
    return !isStatistic && !isNumber && (isRaw || isReadableUnit(unitOfWord(word, due)));
}

/// "speed_rpm", "position [deg]": a known signal and what stands behind it, if it is a unit.
std::optional<WrittenUnit> takeApart(const std::string& header) {
    for (const KnownSignal& known : knownSignals()) {
        const std::string signal(known.name);
        for (const std::string& name : {signal, csvColumnName(signal, "")}) {
            if (known.unit.empty() || header.size() <= name.size() + 1 || !header.starts_with(name)) {
                continue;
            }
            std::string rest = header.substr(name.size());
            rest.erase(0, rest.find_first_not_of(' '));
            const bool isBracketed = rest.size() > 2 && ((rest.front() == '[' && rest.back() == ']') ||
                                                         (rest.front() == '(' && rest.back() == ')'));
            if (isBracketed) {
                return WrittenUnit{signal, rest.substr(1, rest.size() - 2)};
            }
            const std::string word = rest.substr(1);
            if (rest.front() == '_' && isUnitWord(word, std::string(known.unit))) {
                return WrittenUnit{signal, unitOfWord(word, std::string(known.unit))};
            }
        }
    }
    return std::nullopt;
}

std::optional<UnitConversion> conversionOf(const std::string& written, const std::string& due) {
    if (const auto conversion = conversionBetween(written, due)) {
        return conversion;
    }
    const auto foreign = readForeignUnit(written); // what only tables of other programs write
    return foreign && foreign->symbol == due
               ? std::optional(UnitConversion{foreign->factor, foreign->divisor, foreign->offset})
               : std::nullopt;
}

tl::unexpected<Error> notTheUnit(const std::string& origin, const std::string& header,
                                 const WrittenUnit& written, const std::string& due) {
    const std::string hint =
        due == "degC" && written.unit == "deg"
            ? "deg is an angle unit; write degrees Celsius as degC"
            : fmt::format(
                  "name the column with its quantity, e.g. {}, or give the unit with halbench import --unit",
                  csvColumnName(written.signal, due));
    return failure(ErrorCode::InvalidInput,
                   fmt::format("{}:1: column '{}' is in '{}', but {} is in {}", origin, header, written.unit,
                               written.signal, due),
                   hint);
}

/// The sidecar says one unit, the column's name another.
bool contradicts(const RecordingMeta::SignalNote& note, const StreamLayout& noted, std::size_t index) {
    const std::string natural = csvColumnName(note.name, note.unit);
    if (note.column == natural || note.column == csvColumnNames(noted)[index]) {
        return false;
    }
    const Result<StreamLayout> read = parseCsvHeader("time_s," + note.column, "");
    return read && read->columns.size() == 1 && !read->columns[0].unit.empty() &&
           read->columns[0].unit != note.unit;
}

Result<void> checkNotes(const RecordingMeta& meta, const std::string& origin) {
    StreamLayout noted;
    for (const RecordingMeta::SignalNote& note : meta.signals) {
        noted.columns.push_back({note.name, note.unit});
    }
    for (std::size_t i = 0; i < meta.signals.size(); ++i) {
        const RecordingMeta::SignalNote& note = meta.signals[i];
        if (contradicts(note, noted, i)) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: signals[{}].unit: '{}' contradicts the column '{}'",
                                       metaPathOf(origin), i, note.unit, note.column),
                           "correct the unit, or remove the .meta.json file to read the data without it");
        }
    }
    return {};
}

void convertColumn(Recording& recording, std::size_t index, const UnitConversion& conversion) {
    const std::size_t width = recording.layout->columns.size();
    for (std::size_t at = index; !conversion.isIdentity() && at < recording.values.size(); at += width) {
        recording.values[at] = conversion(recording.values[at]);
    }
}

} // namespace

Result<void> convertToSi(RecordedFile& file, const std::vector<bool>& isNoted, const std::string& origin) {
    if (const Result<void> fits = checkNotes(file.meta, origin); !fits) {
        return fits;
    }
    const std::string name = std::filesystem::path(origin).filename().string(); // no folder in a result
    StreamLayout layout = *file.recording.layout;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const StreamLayout::Column column = layout.columns[i];
        const std::string header = headerOf(column);
        WrittenUnit written{column.name, column.unit};
        if (const auto apart = takeApart(header); apart && !isNoted[i] && !unitOfKnownSignal(column.name)) {
            written = *apart;
        }
        if (isTemperatureName(column.name) && column.unit == "deg" && !unitOfKnownSignal(column.name)) {
            file.warnings.push_back(
                fmt::format("unit of column '{}' in '{}': deg is an angle; degrees Celsius are written degC",
                            header, name));
        }
        const std::optional<std::string> due = unitOfKnownSignal(written.signal);
        if (!due || due->empty() || written.unit == *due) {
            continue;
        }
        if (written.unit.empty() && isNoted[i]) { // raw values of a board
            continue;
        }
        if (written.unit.empty()) {
            file.warnings.push_back(
                fmt::format("unit of column '{}' in '{}': missing, {} is assumed", header, name, *due));
            layout.columns[i].unit = *due;
            continue;
        }
        const std::optional<UnitConversion> conversion = conversionOf(written.unit, *due);
        if (!conversion && isNoted[i]) {
            continue;
        }
        if (!conversion) {
            return notTheUnit(origin, csvColumnName(column.name, column.unit), written, *due);
        }
        convertColumn(file.recording, i, *conversion);
        layout.columns[i] = {written.signal, *due};
        for (RecordingMeta::SignalNote& note : file.meta.signals) {
            const bool isOfColumn = note.name == column.name && note.unit == column.unit;
            note.unit = isOfColumn ? *due : note.unit;
        }
    }
    nameColumnsOf(layout, file.meta);
    file.recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return {};
}

bool isUnitWarning(const std::string& warning) {
    return warning.starts_with(UnitWarning);
}

} // namespace halbench::devices
