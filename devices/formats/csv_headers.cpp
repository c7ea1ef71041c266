#include "devices/formats/csv_headers.h"

#include "devices/formats/foreign_unit.h"
#include "devices/formats/known_signals.h"
#include "devices/recording/recording_csv.h"

#include <algorithm>
#include <array>

namespace halbench::devices {

namespace {

std::string lowered(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char character) {
        return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
    });
    return text;
}

/// "speed [rpm]", "speed (rpm)"; round brackets only around a unit that is known, others belong to the name.
void cutUnit(CsvColumn& column) {
    const std::string& header = column.header;
    const bool isSquare = header.size() > 2 && header.back() == ']';
    const bool isRound = header.size() > 2 && header.back() == ')';
    const std::size_t open = isSquare ? header.rfind('[') : isRound ? header.rfind('(') : std::string::npos;
    if (open == std::string::npos) {
        return;
    }
    const std::string unit = header.substr(open + 1, header.size() - open - 2);
    std::string name = header.substr(0, open);
    while (!name.empty() && name.back() == ' ') {
        name.pop_back();
    }
    const bool isSmallest = unit == "min" && !isTimeName(name); // "speed (min)"
    if (isRound && (isSmallest || !readForeignUnit(unit))) {
        return;
    }
    column.name = name;
    setUnit(column, unit);
}

/// What stands behind "NAME_" in a column, if it is a unit of that quantity: "rpm" of "speed_rpm".
std::optional<std::string> unitBehind(const std::string& signal, const KnownSignal& known,
                                      const std::string& name) {
    const std::string begin = csvColumnName(signal, "") + "_";
    if (known.unit.empty() || name.size() <= begin.size() || name.compare(0, begin.size(), begin) != 0) {
        return std::nullopt;
    }
    std::string written = name.substr(begin.size());
    const std::optional<ForeignUnit> unit = readForeignUnit(written);
    const bool isKelvin = unit && unit->symbol == "K" && known.unit == "degC";
    return unit && (unit->symbol == known.unit || isKelvin) ? std::optional(std::move(written))
                                                            : std::nullopt;
}

/// Our own names tell their unit ("hall_a_T"), in another unit too ("hall_a_mT"), and so does the time
/// ("t_ms"); other names are not taken apart.
void readName(CsvColumn& column) {
    const bool hasUnit = !column.written.empty();
    for (const KnownSignal& known : knownSignals()) {
        const std::string signal(known.name);
        if (column.name == signal || column.name == csvColumnName(signal, "")) {
            column.signal = signal;
        } else if (column.name == csvColumnName(signal, std::string(known.unit))) {
            column.signal = signal;
            if (!hasUnit) {
                setUnit(column, known.unit);
            }
        } else if (const auto written = unitBehind(signal, known, column.name); written && !hasUnit) {
            column.signal = signal;
            setUnit(column, *written);
        }
    }
    const std::size_t line = column.name.rfind('_');
    if (line != std::string::npos && !hasUnit && isTimeName(column.name.substr(0, line))) {
        const std::optional<ForeignUnit> unit = readForeignUnit(column.name.substr(line + 1));
        if (unit && unit->symbol == "s") {
            setUnit(column, column.name.substr(line + 1));
            column.name.resize(line);
        }
    }
}

} // namespace

bool isTimeName(const std::string& name) {
    constexpr std::array Names = {"time", "t", "zeit", "timestamp", "temps", "tiempo", "tempo"};
    return std::find(Names.begin(), Names.end(), lowered(name)) != Names.end();
}

void setUnit(CsvColumn& column, std::string_view written) {
    const std::optional<ForeignUnit> unit = readForeignUnit(written);
    column.written = written;
    column.isUnitKnown = unit.has_value();
    if (unit) {
        column.unit = unit->symbol;
        column.factor = unit->factor;
        column.divisor = unit->divisor;
        column.offset = unit->offset;
    }
}

std::vector<CsvColumn> readHeaders(const std::vector<std::string>& names,
                                   const std::vector<std::string>& units, std::size_t width) {
    std::vector<CsvColumn> columns(width);
    for (std::size_t i = 0; i < width; ++i) {
        CsvColumn& column = columns[i];
        column.header = column.name = i < names.size() ? names[i] : "";
        cutUnit(column);
        if (i < units.size() && !units[i].empty()) {
            setUnit(column, units[i]);
        }
        readName(column);
    }
    return columns;
}

} // namespace halbench::devices
