#include "app/procedures/move/move_recording.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/move_judgement.h"
#include "app/procedures/move/row_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace halbench::app {
namespace {

/// Columns of one axis in a recording.
struct AxisColumns {
    std::string position, reference, effort, truth;
};

AxisColumns columnsOf(const devices::Catalogue& catalogue, const devices::AxisSpec& axis) {
    return {signalOf(catalogue, axis.roles.position), signalOf(catalogue, axis.roles.reference),
            signalOf(catalogue, axis.roles.effort), signalOf(catalogue, axis.roles.truePosition)};
}

/// Mean over the last part of the hold, which is long enough to average the noise of readings and short
/// enough to be at rest.
double restPosition(const std::vector<double>& time_s, const std::vector<double>& position,
                    std::size_t firstRow) {
    if (position.empty()) {
        return 0.0; // a board that does not report it has no figures either, and the move fails for that
    }
    constexpr double Longest_s = 0.1;
    constexpr double Hold_ratio = 0.25; // a hold of 50 ms begins with the way to its rest
    const double held_s = time_s[firstRow - 1] - time_s.front();
    const double from_s = time_s[firstRow - 1] - std::min(Longest_s, Hold_ratio * held_s);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t row = firstRow; row > 0 && time_s[row - 1] >= from_s; --row) {
        sum += position[row - 1];
        ++count;
    }
    return sum / count; // one row at least
}

struct Origin {
    std::size_t firstRow = 0; ///< of the reference
    double reference = 0.0;
    double truth = 0.0;
};

Result<std::size_t> firstRowOf(const Recording& recording) {
    const std::vector<double> running = recording.column("reference.running");
    const auto first = std::find_if(running.begin(), running.end(), [](double value) { return value > 0.5; });
    if (first == running.begin() || first == running.end()) {
        return failure(ErrorCode::Protocol, "the device did not start its reference", "Try again.");
    }
    return static_cast<std::size_t>(first - running.begin());
}

Result<Origin> findOrigin(const Recording& recording, const AxisColumns& columns) {
    const std::vector<double> reference = recording.column(columns.reference);
    const std::vector<double> truth = recording.column(columns.truth);
    const auto first = firstRowOf(recording);
    if (!first || reference.empty()) {
        return failure(ErrorCode::Protocol, "the device did not start its reference", "Try again.");
    }
    return Origin{*first, reference[*first - 1], truth.empty() ? 0.0 : truth[*first - 1]};
}

// Keeps the rows of the reference and lets time begin with it.
void cut(Recording& recording, const Origin& origin, const MoveConfig& config) {
    const std::size_t columns = recording.layout->columns.size();
    const double start_s = recording.time_s[origin.firstRow];
    const double end_s = start_s + config.duration_s + 0.5 / config.rate_Hz; // not by count: rows may be lost
    const auto after = std::upper_bound(recording.time_s.begin(), recording.time_s.end(), end_s);
    const auto last = static_cast<std::size_t>(after - recording.time_s.begin());
    Recording part;
    part.layout = recording.layout;
    part.lostRows = recording.lostRows;
    for (std::size_t row = origin.firstRow; row < last; ++row) {
        // Whole milliseconds: the difference of two time stamps carries their rounding.
        part.time_s.push_back(std::round((recording.time_s[row] - start_s) * 1e6) / 1e6);
    }
    const auto begin = recording.values.begin();
    part.values.assign(begin + static_cast<std::ptrdiff_t>(origin.firstRow * columns),
                       begin + static_cast<std::ptrdiff_t>(last * columns));
    recording = std::move(part);
}

/// A column, counted from its value before the reference began.
struct CountedColumn {
    std::string name;
    double origin;
};

MoveResponse responseOf(const Recording& recording, const CountedColumn& position,
                        const CountedColumn& reference, double rowsPerReference) {
    MoveResponse response;
    response.rowsPerReference = static_cast<std::size_t>(std::max(1.0, std::round(rowsPerReference)));
    response.time_s = recording.time_s;
    response.reference = recording.column(reference.name);
    response.position = recording.column(position.name);
    for (double& value : response.reference) {
        value -= reference.origin;
    }
    for (double& value : response.position) {
        value -= position.origin;
    }
    return response;
}

/// Nothing of a column that was not recorded.
std::optional<double> largestMagnitude(const std::vector<double>& values) {
    std::optional<double> result;
    for (const double value : values) {
        result = std::max(std::fabs(value), result.value_or(0.0));
    }
    return result;
}

double largestDistance(const std::vector<double>& values, double origin) {
    double result = 0.0;
    for (const double value : values) {
        result = std::max(result, std::fabs(value - origin));
    }
    return result;
}

// Of the last part of a move.
double restRms(const Recording& recording, const std::vector<double>& values, double window_s) {
    double sum = 0.0;
    double square = 0.0;
    double count = 0.0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (recording.time_s[row] >= recording.time_s.back() - window_s - 1e-9) {
            const double away = values[row] - values.back(); // little beside the position: no digits are lost
            sum += away;
            square += away * away;
            ++count;
        }
    }
    return count > 0.0 ? std::sqrt(std::max(0.0, square / count - sum * sum / (count * count))) : 0.0;
}

// From its reference, which stays where it was; the true position from where that was.
CrossAxisPeak crossAxisPeak(const Recording& recording, const devices::AxisSpec& axis,
                            const AxisColumns& columns, const Origin& origin, double window_s) {
    CrossAxisPeak peak;
    peak.axis = axis;
    peak.measured = largestDistance(recording.column(columns.position), origin.reference);
    if (recording.layout->indexOf(columns.truth) >= 0) {
        peak.truth = largestDistance(recording.column(columns.truth), origin.truth);
        peak.trueRestRms = restRms(recording, recording.column(columns.truth), window_s);
    }
    peak.measuredRestRms = restRms(recording, recording.column(columns.position), window_s);
    return peak;
}

struct OtherAxis {
    devices::AxisSpec axis;
    AxisColumns columns;
    Origin origin;
};

Result<std::vector<OtherAxis>> otherAxes(const devices::Catalogue& catalogue, const MoveTask& task,
                                         const Recording& recording) {
    std::vector<OtherAxis> others;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        const AxisColumns columns = columnsOf(catalogue, axis);
        if (!task.moves(axis) && recording.layout->indexOf(columns.position) >= 0) {
            const auto origin = findOrigin(recording, columns);
            if (!origin) {
                return failure(origin.error());
            }
            others.push_back({axis, columns, *origin});
        }
    }
    return others;
}

// The board's own amplitude where it has one, else that of any coil.
std::optional<double> peakCurrent_A(const devices::Catalogue& catalogue, const Recording& recording) {
    std::optional<double> peak_A = largestMagnitude(recording.column("current_command"));
    if (catalogue.axes.size() > 1) {
        for (const SignalSpec& signal : catalogue.signals) {
            if (signal.role.starts_with("current.")) {
                peak_A = std::max(peak_A, largestMagnitude(recording.column(signal.name)));
            }
        }
    }
    return peak_A;
}

/// An axis that moved, and where it was before.
struct MovedColumns {
    devices::AxisSpec axis;
    AxisColumns columns;
    Origin origin;
};

/// All axes that moved, the one of the task first.
Result<std::vector<MovedColumns>> movedColumns(const devices::Catalogue& catalogue, const MoveTask& task,
                                               const Recording& recording) {
    std::vector<MovedColumns> moved = {{task.axis, columnsOf(catalogue, task.axis), {}}};
    for (const PartnerAxis& partner : task.partners) {
        moved.push_back({partner.axis, columnsOf(catalogue, partner.axis), {}});
    }
    for (MovedColumns& each : moved) {
        const auto origin = findOrigin(recording, each.columns);
        if (!origin) {
            return failure(origin.error());
        }
        each.origin = *origin;
    }
    return moved;
}

struct AxisFigures {
    MoveFigures measured;
    std::optional<MoveFigures> truth;
    std::optional<double> peakEffort;
    MoveResponse response; ///< that was measured
};

/// A window in metres says nothing of an axis that turns.
MoveConfig configOf(const MoveConfig& whole, const devices::AxisSpec& axis) {
    MoveConfig config = whole;
    if (!config.settlingUnit.empty() && config.settlingUnit != axis.positionUnit) {
        config.settlingWindow.reset();
    }
    return config;
}

Result<AxisFigures> figuresOf(const Recording& recording, const MovedColumns& moved, const MoveConfig& whole,
                              double rowsPerReference) {
    const AxisColumns& columns = moved.columns;
    const MoveConfig config = configOf(whole, moved.axis);
    const CountedColumn reference{columns.reference, moved.origin.reference};
    AxisFigures figures;
    figures.response =
        responseOf(recording, {columns.position, moved.origin.reference}, reference, rowsPerReference);
    const auto measured = measureMove(figures.response, config);
    if (!measured) {
        return failure(measured.error());
    }
    figures.measured = *measured;
    figures.measured.rows = measureRows(figures.response, config, moved.axis.id);
    if (recording.layout->indexOf(columns.truth) >= 0) {
        const MoveResponse response =
            responseOf(recording, {columns.truth, moved.origin.truth}, reference, rowsPerReference);
        const auto truth = measureMove(response, config);
        if (!truth) {
            return failure(truth.error());
        }
        figures.truth = *truth;
        figures.truth->rows = measureRows(response, config, moved.axis.id);
    }
    figures.peakEffort = largestMagnitude(recording.column(columns.effort));
    return figures;
}

/// The plane of a path: the first two axes along a line. Both are needed, even when a table moves one only.
using PlaneAxes = std::array<MovedColumns, 2>;

std::optional<PlaneAxes> planeAxesOf(const devices::Catalogue& catalogue, const MoveTask& task,
                                     const Recording& recording) {
    std::vector<MovedColumns> along;
    bool moves = false;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        if (axis.positionUnit != "m" || along.size() == 2) {
            continue;
        }
        const AxisColumns columns = columnsOf(catalogue, axis);
        const auto origin = findOrigin(recording, columns);
        if (!origin || recording.layout->indexOf(columns.position) < 0) {
            return std::nullopt;
        }
        along.push_back({axis, columns, *origin});
        moves = moves || task.moves(axis);
    }
    return along.size() == 2 && moves ? std::optional(PlaneAxes{along[0], along[1]}) : std::nullopt;
}

/// From the nearest point of the way that was commanded.
using DistanceFromWay = std::function<double(double x, double y, double time_s)>;

DistanceFromWay distanceFromWay(const MoveReference& reference, const PlaneAxes& axes) {
    if (!isTable(reference)) {
        return [path = *planePath(reference)](double x, double y, double) { // checked before it moved
            return path.distanceFrom(x, y);
        };
    }
    const TabledMotion& tabled = *reference.table;
    const auto columnOf = [&](const MovedColumns& moved) {
        return tabled.table.columnOf(moved.axis.id).value_or(tabled.motion.axisCount());
    };
    return [trace = control::PlaneTrace(tabled.motion, {columnOf(axes[0]), columnOf(axes[1])})](
               double x, double y, double time_s) { return trace.distanceFrom(x, y, time_s); };
}

/// A path and a table in a plane, from their start to their end.
struct Way {
    DistanceFromWay distance;
    double duration_s;
};

/// Of two columns, while the way lasts.
ContourError contourOf(const Recording& recording, const Way& way,
                       const std::array<CountedColumn, 2>& columns) {
    const std::vector<double> x = recording.column(columns[0].name);
    const std::vector<double> y = recording.column(columns[1].name);
    ContourError error;
    double square = 0.0;
    double count = 0.0;
    for (std::size_t row = 0; row < x.size() && recording.time_s[row] <= way.duration_s + 1e-9; ++row) {
        const double away =
            way.distance(x[row] - columns[0].origin, y[row] - columns[1].origin, recording.time_s[row]);
        error.peak = std::max(error.peak, away);
        square += away * away;
        ++count;
    }
    error.rms = count > 0.0 ? std::sqrt(square / count) : 0.0;
    return error;
}

ContourError contourOf(const Recording& recording, const Way& way, const PlaneAxes& axes,
                       std::string AxisColumns::*name, double Origin::*origin) {
    return contourOf(recording, way,
                     {CountedColumn{axes[0].columns.*name, axes[0].origin.*origin},
                      CountedColumn{axes[1].columns.*name, axes[1].origin.*origin}});
}

ContourResult contourResultOf(const Recording& recording, const Way& way, const PlaneAxes& axes) {
    ContourResult result;
    result.unit = axes[0].axis.positionUnit;
    result.measured = contourOf(recording, way, axes, &AxisColumns::position, &Origin::reference);
    if (recording.layout->indexOf(axes[0].columns.truth) >= 0) {
        result.truth = contourOf(recording, way, axes, &AxisColumns::truth, &Origin::truth);
    }
    return result;
}

/// The board's own references are on the path, but for their resolution.
void judgePath(const ContourError& reference, DataQuality& quality, const devices::AxisSpec& axis) {
    if (reference.peak > 2.0 * axis.referenceTolerance) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back(
            {"reference_differs",
             fmt::format("the board followed another path than commanded, {:.3g} {} away", reference.peak,
                         axis.positionUnit),
             "Check that no other program uses the device, then move again."});
    }
}

} // namespace

double loopPeriod_s(const devices::Catalogue& catalogue) {
    const auto found = catalogue.knownConstants.find("T_s");
    return found == catalogue.knownConstants.end() ? 0.01 : found->second;
}

std::vector<std::string> moveSignals(const devices::Catalogue& catalogue) {
    if (catalogue.axes.size() > 1) {
        std::vector<std::string> names;
        for (const SignalSpec& signal : catalogue.signals) {
            if (!signal.role.empty()) {
                names.push_back(signal.name);
            }
        }
        return names;
    }
    return {"position",
            "speed",
            "reference",
            "current_command",
            "current.a",
            "current.b",
            "hall.a",
            "hall.b",
            "coil_temperature.a",
            "coil_temperature.b",
            "status",
            "fault",
            "torn_count",
            "truth.position",
            "truth.speed",
            "reference.segment",
            "reference.running"};
}

namespace {

PartnerResult partnerOf(const devices::AxisSpec& axis, AxisFigures figures) {
    return {axis, std::move(figures.measured), std::move(figures.truth), figures.peakEffort};
}

void addFindings(DataQuality& quality, const DataQuality& more) {
    quality.verdict = std::max(quality.verdict, more.verdict);
    quality.findings.insert(quality.findings.end(), more.findings.begin(), more.findings.end());
}

/// What lies in the plane, and whether the board's own references do.
void addContour(const Recording& recording, const MoveConfig& config, const PlaneAxes& axes,
                MoveResult& result) {
    const Way way{distanceFromWay(config.reference, axes), travelTime_s(config.reference).value_or(0.0)};
    result.contour = contourResultOf(recording, way, axes);
    if (!isTable(config.reference)) { // whose references were compared axis by axis
        judgePath(contourOf(recording, way, axes, &AxisColumns::reference, &Origin::reference),
                  result.quality, result.axis);
    }
}

/// The further axes of a path or table.
Result<void> addPartners(const Recording& recording, const MoveConfig& config,
                         const std::vector<MovedColumns>& moved, double rowsPerReference,
                         MoveResult& result) {
    for (std::size_t i = 1; i < moved.size(); ++i) {
        auto figures = figuresOf(recording, moved[i], config, rowsPerReference);
        if (!figures) {
            return failure(figures.error());
        }
        if (isTable(config.reference)) {
            addFindings(result.quality, judgeReference(figures->response, config, recording.lostRows,
                                                       moved[i].origin.reference, moved[i].axis));
        }
        result.partners.push_back(partnerOf(moved[i].axis, *std::move(figures)));
    }
    return {};
}

} // namespace

Result<MoveResult> judgeRecording(Recording recording, const MoveConfig& config, const MoveTask& task,
                                  const devices::Catalogue& catalogue) {
    const auto moved = movedColumns(catalogue, task, recording);
    if (!moved) {
        return failure(moved.error());
    }
    const auto others = otherAxes(catalogue, task, recording);
    if (!others) {
        return failure(others.error());
    }
    const MovedColumns& first = moved->front();
    const auto plane =
        movesSeveralAxes(config.reference) ? planeAxesOf(catalogue, task, recording) : std::nullopt;
    const std::vector<double> position = recording.column(first.columns.position);
    const double rest = restPosition(recording.time_s, position, first.origin.firstRow);
    cut(recording, first.origin, config);
    const double rowsPerReference = loopPeriod_s(catalogue) * config.rate_Hz;
    auto figures = figuresOf(recording, first, config, rowsPerReference);
    if (!figures) {
        return failure(figures.error());
    }
    MoveResult result;
    result.axis = task.axis;
    result.restPosition = rest;
    result.lockThreshold = config.lockThreshold;
    result.measured = std::move(figures->measured);
    result.truth = std::move(figures->truth);
    result.peakEffort = figures->peakEffort;
    result.quality =
        judgeMotion(figures->response, config, recording.lostRows, first.origin.reference, task.axis);
    if (auto added = addPartners(recording, config, *moved, rowsPerReference, result); !added) {
        return failure(added.error());
    }
    if (plane) {
        addContour(recording, config, *plane, result);
    }
    for (const OtherAxis& other : *others) {
        result.others.push_back(crossAxisPeak(recording, other.axis, other.columns, other.origin,
                                              restWindow_s(config.reference, config.duration_s)));
    }
    result.peakCurrent_A = peakCurrent_A(catalogue, recording);
    result.highestTemperature_degC = highestCoil_degC(catalogue, recording);
    result.recording = std::move(recording);
    return result;
}

} // namespace halbench::app
