#include "app/procedures/move/move_recording.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/move_judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
        const bool isMoved = axis.id == task.axis.id || (task.second && axis.id == task.second->id);
        if (!isMoved && recording.layout->indexOf(columns.position) >= 0) {
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
    AxisColumns columns;
    Origin origin;
};

Result<MovedColumns> withOrigin(const Recording& recording, MovedColumns moved) {
    const auto origin = findOrigin(recording, moved.columns);
    if (!origin) {
        return failure(origin.error());
    }
    moved.origin = *origin;
    return moved;
}

struct AxisFigures {
    MoveFigures measured;
    std::optional<MoveFigures> truth;
    std::optional<double> peakEffort;
    MoveResponse response; ///< that was measured
};

Result<AxisFigures> figuresOf(const Recording& recording, const MovedColumns& moved, const MoveConfig& config,
                              double rowsPerReference) {
    const AxisColumns& columns = moved.columns;
    const CountedColumn reference{columns.reference, moved.origin.reference};
    AxisFigures figures;
    figures.response =
        responseOf(recording, {columns.position, moved.origin.reference}, reference, rowsPerReference);
    const auto measured = measureMove(figures.response, config);
    if (!measured) {
        return failure(measured.error());
    }
    figures.measured = *measured;
    if (recording.layout->indexOf(columns.truth) >= 0) {
        const auto truth = measureMove(
            responseOf(recording, {columns.truth, moved.origin.truth}, reference, rowsPerReference), config);
        if (!truth) {
            return failure(truth.error());
        }
        figures.truth = *truth;
    }
    figures.peakEffort = largestMagnitude(recording.column(columns.effort));
    return figures;
}

using PathColumns = std::array<CountedColumn, 2>;

PathColumns referencesOf(const MovedColumns& first, const MovedColumns& second) {
    return {CountedColumn{first.columns.reference, first.origin.reference},
            CountedColumn{second.columns.reference, second.origin.reference}};
}

/// Of two columns, while the path lasts.
ContourError contourOf(const Recording& recording, const MoveConfig& config, const PathColumns& columns) {
    const auto path = planePath(config.reference); // checked before it moved
    const std::vector<double> x = recording.column(columns[0].name);
    const std::vector<double> y = recording.column(columns[1].name);
    ContourError error;
    double square = 0.0;
    double count = 0.0;
    for (std::size_t row = 0; row < x.size() && recording.time_s[row] <= path->duration_s() + 1e-9; ++row) {
        const double away = path->distanceFrom(x[row] - columns[0].origin, y[row] - columns[1].origin);
        error.peak = std::max(error.peak, away);
        square += away * away;
        ++count;
    }
    error.rms = count > 0.0 ? std::sqrt(square / count) : 0.0;
    return error;
}

PathResult pathResultOf(const Recording& recording, const MoveConfig& config, const devices::AxisSpec& axis,
                        const std::array<MovedColumns, 2>& moved, AxisFigures figures) {
    PathResult result;
    result.axis = axis;
    result.measured = std::move(figures.measured);
    result.truth = std::move(figures.truth);
    result.peakEffort = figures.peakEffort;
    const auto columnsOfBoth = [&](std::string AxisColumns::*name, double Origin::*origin) {
        return PathColumns{CountedColumn{moved[0].columns.*name, moved[0].origin.*origin},
                           CountedColumn{moved[1].columns.*name, moved[1].origin.*origin}};
    };
    result.measuredContour =
        contourOf(recording, config, columnsOfBoth(&AxisColumns::position, &Origin::reference));
    if (result.truth) {
        result.trueContour = contourOf(recording, config, columnsOfBoth(&AxisColumns::truth, &Origin::truth));
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

Result<MoveResult> judgeRecording(Recording recording, const MoveConfig& config, const MoveTask& task,
                                  const devices::Catalogue& catalogue) {
    const MovedColumns first{columnsOf(catalogue, task.axis), {}};
    auto moved = withOrigin(recording, first);
    if (!moved) {
        return failure(moved.error());
    }
    const auto second = task.second ? withOrigin(recording, {columnsOf(catalogue, *task.second), {}})
                                    : Result<MovedColumns>(first);
    const auto others = otherAxes(catalogue, task, recording);
    if (!second || !others) {
        return failure(!second ? second.error() : others.error());
    }
    const std::vector<double> position = recording.column(first.columns.position);
    const double rest = restPosition(recording.time_s, position, moved->origin.firstRow);
    cut(recording, moved->origin, config);
    const double rowsPerReference = loopPeriod_s(catalogue) * config.rate_Hz;
    auto figures = figuresOf(recording, *moved, config, rowsPerReference);
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
        judgeMotion(figures->response, config, recording.lostRows, moved->origin.reference, task.axis);
    if (task.second) {
        auto partner = figuresOf(recording, *second, config, rowsPerReference);
        if (!partner) {
            return failure(partner.error());
        }
        result.path = pathResultOf(recording, config, *task.second, {*moved, *second}, *std::move(partner));
        judgePath(contourOf(recording, config, referencesOf(*moved, *second)), result.quality, task.axis);
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
