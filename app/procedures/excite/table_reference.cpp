#include "app/procedures/excite/table_reference.h"

#include "app/procedures/base/axis_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

using Shape = MoveReference::Shape;

constexpr const char* PieceNumber = "table.number";
constexpr const char* PieceDuration = "table.duration";
constexpr const char* PathShape = "path.shape";
constexpr double TableCode = 5.0; ///< of the board's path.shape
constexpr std::array Quantities = {"m", "rad"};

/// Limits of the lengths or of the angles; without a jerk the acceleration may jump.
control::TravelLimits limitsOf(const MoveReference& reference, std::string_view unit) {
    const auto& turning = reference.turning;
    return unit == "m" ? control::TravelLimits{reference.rate, reference.acceleration, reference.jerk}
                       : control::TravelLimits{turning.rate, turning.acceleration, turning.jerk};
}

/// Columns of one quantity.
std::vector<std::size_t> columnsIn(const PoseTable& table, std::string_view unit) {
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].unit == unit) {
            columns.push_back(i);
        }
    }
    return columns;
}

/// Some row is another than 0.
bool moves(const PoseTable& table, std::span<const std::size_t> columns) {
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<double>& row) {
        return std::any_of(columns.begin(), columns.end(),
                           [&row](std::size_t column) { return row[column] != 0.0; });
    });
}

tl::unexpected<Error> atHeader(const PoseTable& table, const std::string& what, const std::string& hint) {
    return failure(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", table.origin, table.headerLine, what),
                   hint);
}

Result<control::PoseMotion> visit(const MoveReference& reference, const PoseTable& table) {
    std::vector<control::AxisGroup> groups;
    for (const char* unit : Quantities) {
        const std::vector<std::size_t> columns = columnsIn(table, unit);
        if (!moves(table, columns)) {
            continue;
        }
        const control::TravelLimits limits = limitsOf(reference, unit);
        const char* missing = !(limits.speed > 0.0)          ? "rate_{}_s"
                              : !(limits.acceleration > 0.0) ? "acceleration_{}_s2"
                                                             : nullptr;
        if (missing != nullptr) {
            const std::string key = fmt::format(fmt::runtime(missing), unit);
            return atHeader(
                table,
                fmt::format("without time_s the way to {} needs {}", table.columns[columns.front()].name,
                            key),
                fmt::format("Add {}=... to the reference, or a column time_s to the table.", key));
        }
        groups.push_back({columns, limits});
    }
    return control::PoseMotion::visiting(table.rows, groups, reference.dwell_s);
}

/// What a limit is of, in the words of an error.
struct Bound {
    const char* verb; ///< "moves at"
    double limit;
    std::string name;
    const char* per; ///< of the unit
};

/// A spline swings out between rows whose times are uneven.
bool isBetweenRows(const PoseTable& table, const control::MotionPiece& piece, std::size_t column,
                   double limit) {
    const double before = piece.row > 0 ? table.rows[piece.row - 1][column] : 0.0;
    return std::fabs(table.rows[piece.row][column]) < limit && std::fabs(before) < limit;
}

std::string remedyOf(const PoseTable& table, const control::MotionPiece& piece, std::size_t column,
                     const Bound& bound) {
    if (*bound.per != '\0') {
        return "Give the row more time, or bring it nearer to the one before. Nothing moved.";
    }
    return isBetweenRows(table, piece, column, bound.limit)
               ? "It swings out between two rows: use more even times, or a pause. Nothing moved."
               : "Use poses nearer to the start, or a wider window. Nothing moved.";
}

/// What a row exceeds on its way; a piece that only says the row.
tl::unexpected<Error> beyond(const PoseTable& table, const control::MotionPiece& piece, std::size_t column,
                             double value, const Bound& bound) {
    const PoseTable::Column& of = table.columns[column];
    return failure(ErrorCode::OutOfRange,
                   fmt::format("{}: row {}: axis {} {} {:.4g} {}{}, the limit is {:.4g} {}{} ({})",
                               table.placeOf(piece.row), piece.row + 1, of.axis, bound.verb, value, of.unit,
                               bound.per, bound.limit, of.unit, bound.per, bound.name),
                   remedyOf(table, piece, column, bound));
}

constexpr double Rounding_ratio = 1e-9; // a travel at its limit is within it

bool isBeyond(double value, double limit) {
    return value > limit * (1.0 + Rounding_ratio);
}

/// The limits that the reference gives a table with times.
Result<void> checkGiven(const MoveReference& reference, const TabledMotion& tabled) {
    for (const control::MotionPiece& piece : tabled.motion.pieces()) {
        for (std::size_t column = 0; column < tabled.table.columns.size(); ++column) {
            const std::string& unit = tabled.table.columns[column].unit;
            const control::TravelLimits limits = limitsOf(reference, unit);
            const control::PiecePeaks peaks = piece.peaks(column);
            if (limits.speed > 0.0 && isBeyond(peaks.speed, limits.speed)) {
                return beyond(tabled.table, piece, column, peaks.speed,
                              {"moves at", limits.speed, "rate of the reference", "/s"});
            }
            if (limits.acceleration > 0.0 && isBeyond(peaks.acceleration, limits.acceleration)) {
                return beyond(
                    tabled.table, piece, column, peaks.acceleration,
                    {"accelerates at", limits.acceleration, "acceleration of the reference", "/s^2"});
            }
            if (limits.jerk && isBeyond(peaks.jerk, *limits.jerk)) {
                return beyond(tabled.table, piece, column, peaks.jerk,
                              {"has a jerk of", *limits.jerk, "jerk of the reference", "/s^3"});
            }
        }
    }
    return {};
}

Result<control::PoseMotion> motionOf(const MoveReference& reference, const PoseTable& table) {
    if (table.time_s.empty()) {
        return visit(reference, table);
    }
    if (reference.dwell_s > 0.0) {
        return atHeader(table, "dwell_s is for tables without time_s",
                        "Leave it out: two rows with the same pose are a pause.");
    }
    return control::PoseMotion::through(table.time_s, table.rows);
}

std::string axisNames(const std::vector<devices::AxisSpec>& axes) {
    std::string names;
    for (const devices::AxisSpec& axis : axes) {
        names += (names.empty() ? "" : ", ") + axis.id;
    }
    return names;
}

Result<void> checkColumn(const PoseTable& table, const PoseTable::Column& column,
                         const std::vector<devices::AxisSpec>& axes) {
    const auto axis = std::find_if(axes.begin(), axes.end(),
                                   [&](const devices::AxisSpec& each) { return each.id == column.axis; });
    const std::string place = fmt::format("{}:{}:{}", table.origin, table.headerLine, column.place);
    if (axis == axes.end()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: the device has no axis '{}' ({})", place, column.axis, column.name),
                       fmt::format("Its axes: {}.", axisNames(axes)));
    }
    if (axis->positionUnit != column.unit) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: axis {} is in {}, not in {} ({})", place, column.axis,
                                   axis->positionUnit, column.unit, column.name),
                       fmt::format("Name the column {}_{}.", column.axis, axis->positionUnit));
    }
    return {};
}

Result<void> checkRoom(const devices::Catalogue& catalogue, const TabledMotion& tabled) {
    const ParameterSpec* number = catalogue.findParameter(PieceNumber);
    const ParameterSpec* duration = catalogue.findParameter(PieceDuration);
    const auto pieces = static_cast<double>(tabled.motion.pieces().size());
    if (pieces > number->max) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: the way takes {:.0f} pieces, the board has room for {:.0f}",
                                   tabled.table.origin, pieces, number->max),
                       "Split the table, or use fewer rows.");
    }
    for (const control::MotionPiece& piece : tabled.motion.pieces()) {
        if (piece.duration_s > duration->max) {
            return failure(ErrorCode::OutOfRange,
                           fmt::format("{}: row {}: the way takes {:.4g} s, the board takes up to {:.4g} s",
                                       tabled.table.placeOf(piece.row), piece.row + 1, piece.duration_s,
                                       duration->max),
                           "Add rows in between.");
        }
    }
    return {};
}

/// In the order in which the board stores them: the number comes last.
std::vector<ParameterValue> pieceParameters(const TabledMotion& tabled, std::size_t index,
                                            const std::vector<devices::AxisSpec>& axes) {
    const control::MotionPiece& piece = tabled.motion.pieces()[index];
    std::vector<ParameterValue> values;
    for (const devices::AxisSpec& axis : axes) {
        const auto column = tabled.table.columnOf(axis.id);
        const control::PieceStart start = column ? piece.axes[*column] : control::PieceStart{};
        const std::string stem = "table." + axis.id;
        values.push_back({stem + ".value", start.value});
        values.push_back({stem + ".speed", start.speed});
        values.push_back({stem + ".acceleration", start.acceleration});
        values.push_back({stem + ".jerk", start.jerk});
    }
    values.push_back({PieceDuration, piece.duration_s});
    values.push_back({PieceNumber, static_cast<double>(index + 1)});
    return values;
}

} // namespace

bool isTable(const MoveReference& reference) {
    return reference.shape == Shape::Table;
}

bool movesSeveralAxes(const MoveReference& reference) {
    return isTable(reference) || reference.shape == Shape::Circle || reference.shape == Shape::Raster ||
           reference.shape == Shape::Arc || reference.shape == Shape::Line;
}

Result<void> checkTableKeys(const MoveReference& reference) {
    if (reference.file.empty()) {
        return failure(ErrorCode::InvalidInput, "a table needs file", "Add file=POSES.csv to the reference.");
    }
    if (reference.rate < 0.0 || reference.turning.rate < 0.0) {
        return failure(ErrorCode::InvalidInput, "the rate of a table is negative",
                       "Give the largest speed without a sign; the rows say the direction.");
    }
    if (reference.base != 0.0 || reference.amplitude != 0.0) {
        return failure(ErrorCode::InvalidInput, "a table has no amplitude and no constant motion",
                       "Write both into its rows.");
    }
    return {};
}

Result<void> attachTable(MoveReference& reference, PoseTable table) {
    auto motion = motionOf(reference, table);
    if (!motion) {
        Error error = motion.error();
        const bool hasPlace = error.message.starts_with(table.origin);
        error.message = hasPlace ? error.message : table.placeOf(0) + ": " + error.message;
        return failure(std::move(error));
    }
    const auto tabled =
        std::make_shared<const TabledMotion>(TabledMotion{std::move(table), *std::move(motion)});
    if (!tabled->table.time_s.empty()) {
        if (auto kept = checkGiven(reference, *tabled); !kept) {
            return kept;
        }
    }
    reference.table = tabled;
    return {};
}

Result<std::vector<devices::AxisSpec>> tableAxes(const devices::Catalogue& catalogue,
                                                 const MoveReference& reference) {
    if (catalogue.findParameter(PieceNumber) == nullptr ||
        catalogue.findParameter(PieceDuration) == nullptr) {
        return failure(ErrorCode::InvalidInput, "this device follows no table of poses",
                       "Move one axis: a step, a ramp, a staircase.");
    }
    if (!reference.table) {
        return failure(ErrorCode::InvalidInput, "the table of the reference was not read",
                       "Read the file before the move.");
    }
    const TabledMotion& tabled = *reference.table;
    const std::vector<devices::AxisSpec> axes = axesOf(catalogue);
    for (const PoseTable::Column& column : tabled.table.columns) {
        if (auto known = checkColumn(tabled.table, column, axes); !known) {
            return failure(known.error());
        }
    }
    if (auto fits = checkRoom(catalogue, tabled); !fits) {
        return failure(fits.error());
    }
    std::vector<devices::AxisSpec> moved;
    for (const devices::AxisSpec& axis : axes) {
        if (tableReach(reference, axis.id) > 0.0) {
            moved.push_back(axis);
        }
    }
    return moved;
}

Result<void> checkTableLimits(const MoveReference& reference, const std::vector<TableAxisLimits>& limits) {
    const TabledMotion& tabled = *reference.table;
    for (std::size_t row = 0; row < tabled.table.rows.size(); ++row) {
        for (const TableAxisLimits& limit : limits) {
            const auto column = tabled.table.columnOf(limit.axis);
            const double away = column ? std::fabs(limit.from + tabled.table.rows[row][*column]) : 0.0;
            if (column && !(away < limit.window)) {
                return beyond(tabled.table, {0.0, 0.0, row, {}}, *column, away,
                              {"goes as far as", limit.window, limit.windowName, ""});
            }
        }
    }
    for (const control::MotionPiece& piece : tabled.motion.pieces()) {
        for (const TableAxisLimits& limit : limits) {
            const auto column = tabled.table.columnOf(limit.axis);
            if (!column) {
                continue;
            }
            const control::PiecePeaks peaks = piece.peaks(*column);
            const double away = std::max(-(limit.from + peaks.least), limit.from + peaks.most);
            if (!(away < limit.window)) {
                return beyond(tabled.table, piece, *column, away,
                              {"goes as far as", limit.window, limit.windowName, ""});
            }
            if (!(peaks.speed < limit.speed)) {
                return beyond(tabled.table, piece, *column, peaks.speed,
                              {"moves at", limit.speed, limit.speedName, "/s"});
            }
            if (limit.acceleration && isBeyond(peaks.acceleration, *limit.acceleration)) {
                return beyond(tabled.table, piece, *column, peaks.acceleration,
                              {"accelerates at", *limit.acceleration, "largest force over inertia", "/s^2"});
            }
        }
    }
    return {};
}

Result<void> checkTableEnds(const MoveReference& reference, const std::vector<AxisTravel>& ends) {
    const PoseTable& table = reference.table->table;
    for (const control::MotionPiece& piece : reference.table->motion.pieces()) {
        for (const AxisTravel& end : ends) {
            const auto column = table.columnOf(end.axis);
            const control::PiecePeaks peaks = column ? piece.peaks(*column) : control::PiecePeaks{};
            const auto place = placeBeyondEnd(end, {peaks.least, peaks.most});
            if (column && place) {
                const std::string& unit = table.columns[*column].unit;
                return failure(
                    ErrorCode::OutOfRange,
                    fmt::format("{}: row {}: axis {} would come to {:.4g} {}, its travel ends at {:.4g} {}",
                                table.placeOf(piece.row), piece.row + 1, end.axis, *place, unit,
                                std::copysign(end.travel, *place), unit),
                    "Poses count from where the axes stand: move them nearer to the middle first. Nothing "
                    "moved.");
            }
        }
    }
    return {};
}

std::optional<double> tablePointAt(const MoveReference& reference, double time_s, std::string_view axis) {
    const auto column = reference.table ? reference.table->table.columnOf(axis) : std::nullopt;
    return column ? std::optional(reference.table->motion.at(*column, time_s).value) : std::nullopt;
}

double tableReach(const MoveReference& reference, std::string_view axis) {
    double reach = 0.0;
    if (reference.table) {
        const auto& columns = reference.table->table.columns;
        for (std::size_t column = 0; column < columns.size(); ++column) {
            if (axis.empty() || columns[column].axis == axis) {
                reach = std::max(reach, reference.table->motion.reach(column));
            }
        }
    }
    return reach;
}

Result<void> writeTable(devices::Device& device, const MoveReference& reference,
                        const std::function<Result<void>()>& keepGoing) {
    const TabledMotion& tabled = *reference.table;
    const std::vector<devices::AxisSpec> axes = axesOf(device.catalogue());
    for (std::size_t index = 0; index < tabled.motion.pieces().size(); ++index) {
        if (auto going = keepGoing ? keepGoing() : Result<void>(); !going) {
            return going;
        }
        if (auto written = device.writeParameters(pieceParameters(tabled, index, axes)); !written) {
            return written;
        }
    }
    return {};
}

std::vector<ParameterValue> tableParameters(const MoveReference& reference) {
    return {{PathShape, TableCode},
            {"table.count", static_cast<double>(reference.table->motion.pieces().size())}};
}

} // namespace halbench::app
