#include "app/actuators/spherical/sensing_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace halbench::app {
namespace {

/// "field.0.r" and "field_0_r" are one signal: a recording without a sidecar knows the column alone.
std::string plainName(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

/// "field_0_r_mT", "field.0.r [mT]": what stands behind the name; nothing when it is another name.
std::optional<std::string> unitBehind(const std::string& column, const std::string& wanted) {
    if (!column.starts_with(wanted) || column.size() <= wanted.size() + 1) {
        return std::nullopt;
    }
    std::string rest = column.substr(wanted.size());
    if (rest.find_first_of(" _[(") != 0) {
        return std::nullopt;
    }
    rest.erase(0, rest.find_first_not_of(" _"));
    const bool isBracketed = rest.size() > 2 && ((rest.front() == '[' && rest.back() == ']') ||
                                                 (rest.front() == '(' && rest.back() == ')'));
    return isBracketed ? rest.substr(1, rest.size() - 2) : rest;
}

} // namespace

std::vector<double> SensingColumn::values(const Recording& recording) const {
    const std::size_t width = recording.layout->columns.size();
    std::vector<double> values;
    values.reserve(recording.rows());
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        values.push_back(toUnit(recording.values[row * width + index]));
    }
    return values;
}

std::string columnNames(const Recording& recording) {
    std::string names;
    for (const StreamLayout::Column& column : recording.layout->columns) {
        names += (names.empty() ? "" : ", ") + column.name;
        names += column.unit.empty() ? "" : fmt::format(" [{}]", column.unit);
    }
    return names.empty() ? "none" : names;
}

Result<SensingColumn> sensingColumn(const Recording& recording, const std::string& name,
                                    const std::string& unit, ColumnsWithoutUnit withoutUnit) {
    const auto& columns = recording.layout->columns;
    const std::string wanted = plainName(name);
    std::optional<Error> misfit;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string column = plainName(columns[i].name);
        const std::optional<std::string> written =
            column == wanted ? columns[i].unit : unitBehind(column, wanted);
        if (written && written->empty() && withoutUnit == ColumnsWithoutUnit::Taken) {
            return SensingColumn{i, {}};
        }
        if (const auto conversion = written ? conversionBetween(*written, unit) : std::nullopt) {
            return SensingColumn{i, *conversion};
        }
        const bool isUnit = written && (column == wanted || isReadableUnit(*written));
        if (isUnit && !misfit) {
            misfit = Error{ErrorCode::InvalidInput, fmt::format("'{}' is not in {}", columns[i].name, unit),
                           fmt::format("give the unit of its numbers, e.g. {}: halbench import --unit "
                                       "COLUMN=UNIT --map {}=COLUMN",
                                       unit == "rad" ? "deg" : "m" + unit, name)};
        }
    }
    if (misfit) {
        return failure(*misfit);
    }
    return failure(ErrorCode::UnknownName, fmt::format("there is no signal '{}'", name),
                   fmt::format("there are {}", columnNames(recording)));
}

} // namespace halbench::app
