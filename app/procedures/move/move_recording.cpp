#include "app/procedures/move/move_recording.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/move/move_judgement.h"

#include <algorithm>
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

struct Origin {
    std::size_t firstRow = 0; ///< of the reference
    double reference = 0.0;
    double truth = 0.0;
};

Result<std::size_t> firstRowOf(const Recording& recording) {
    const std::vector<double> running = recording.column("reference.running");
    const auto first = std::find_if(running.begin(), running.end(), [](double value) { return value > 0.5; });
    if (first == running.begin() || first == running.end()) {
        return failure(ErrorCode::Protocol, "the board did not start its reference", "Try again.");
    }
    return static_cast<std::size_t>(first - running.begin());
}

Result<Origin> findOrigin(const Recording& recording, const AxisColumns& columns) {
    const std::vector<double> reference = recording.column(columns.reference);
    const std::vector<double> truth = recording.column(columns.truth);
    const auto first = firstRowOf(recording);
    if (!first || reference.empty()) {
        return failure(ErrorCode::Protocol, "the board did not start its reference", "Try again.");
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

double largest(const std::vector<double>& values, bool ofMagnitude) {
    double result = 0.0;
    for (const double value : values) {
        result = std::max(result, ofMagnitude ? std::fabs(value) : value);
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

// From its reference, which stays where it was; the true position from where that was.
CrossAxisPeak crossAxisPeak(const Recording& recording, const devices::AxisSpec& axis,
                            const AxisColumns& columns, const Origin& origin) {
    CrossAxisPeak peak;
    peak.axis = axis;
    peak.measured = largestDistance(recording.column(columns.position), origin.reference);
    if (recording.layout->indexOf(columns.truth) >= 0) {
        peak.truth = largestDistance(recording.column(columns.truth), origin.truth);
    }
    return peak;
}

struct OtherAxis {
    devices::AxisSpec axis;
    AxisColumns columns;
    Origin origin;
};

Result<std::vector<OtherAxis>> otherAxes(const devices::Catalogue& catalogue, const devices::AxisSpec& moved,
                                         const Recording& recording) {
    std::vector<OtherAxis> others;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        const AxisColumns columns = columnsOf(catalogue, axis);
        if (axis.id != moved.id && recording.layout->indexOf(columns.position) >= 0) {
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
double peakCurrent_A(const devices::Catalogue& catalogue, const Recording& recording) {
    double peak_A = largest(recording.column("current_command"), true);
    if (catalogue.axes.size() > 1) {
        for (const SignalSpec& signal : catalogue.signals) {
            const bool isCurrent = signal.role.starts_with("current.");
            peak_A = isCurrent ? std::max(peak_A, largest(recording.column(signal.name), true)) : peak_A;
        }
    }
    return peak_A;
}

double highestTemperature_degC(const devices::Catalogue& catalogue, const Recording& recording) {
    double highest_degC = 0.0;
    for (const SignalSpec& signal : catalogue.signals) {
        if (signal.role.starts_with("coil_temperature.")) {
            highest_degC = std::max(highest_degC, largest(recording.column(signal.name), false));
        }
    }
    return highest_degC;
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

Result<MoveResult> judgeRecording(Recording recording, const MoveConfig& config,
                                  const devices::AxisSpec& axis, const devices::Catalogue& catalogue) {
    const AxisColumns columns = columnsOf(catalogue, axis);
    const auto origin = findOrigin(recording, columns);
    if (!origin) {
        return failure(origin.error());
    }
    const auto others = otherAxes(catalogue, axis, recording);
    if (!others) {
        return failure(others.error());
    }
    cut(recording, *origin, config);
    const auto responseIn = [&](const CountedColumn& column) {
        return responseOf(recording, column, {columns.reference, origin->reference},
                          loopPeriod_s(catalogue) * config.rate_Hz);
    };
    MoveResult result;
    result.axis = axis;
    result.lockThreshold = config.lockThreshold;
    const MoveResponse response = responseIn({columns.position, origin->reference});
    const auto measured = measureMove(response, config);
    if (!measured) {
        return failure(measured.error());
    }
    result.measured = *measured;
    if (recording.layout->indexOf(columns.truth) >= 0) {
        const auto truth = measureMove(responseIn({columns.truth, origin->truth}), config);
        if (!truth) {
            return failure(truth.error());
        }
        result.truth = *truth;
    }
    result.peakEffort = largest(recording.column(columns.effort), true);
    for (const OtherAxis& other : *others) {
        result.others.push_back(crossAxisPeak(recording, other.axis, other.columns, other.origin));
    }
    result.peakCurrent_A = peakCurrent_A(catalogue, recording);
    result.highestTemperature_degC = highestTemperature_degC(catalogue, recording);
    result.recording = std::move(recording);
    result.quality = judgeMotion(response, config, result.recording.lostRows, origin->reference, axis);
    return result;
}

} // namespace halbench::app
