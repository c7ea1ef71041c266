#include "app/procedures/frequency/axes_frequency_judge.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/tune/loop_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::MeasuredMargin;

Result<std::vector<double>> columnOf(const Recording& recording, const std::string& signal) {
    std::vector<double> column = recording.column(signal);
    if (column.size() != recording.rows() || column.empty()) {
        return failure(ErrorCode::InvalidInput, fmt::format("the recording lacks the signal '{}'", signal),
                       "the device must send position and command of every axis");
    }
    return column;
}

Result<void> checkRows(const AxesFrequencyRun& run, const AxesExperiment& experiment, std::size_t rows) {
    const std::vector<double>& time_s = run.recording.time_s;
    const std::size_t first = experiment.firstRow;
    const double expected_s = static_cast<double>(rows - 1) * run.plan.period_s;
    if (first + rows > time_s.size() ||
        std::abs(time_s[first + rows - 1] - time_s[first] - expected_s) > 0.5 * run.plan.period_s) {
        return failure(
            withCause({ErrorCode::Refused,
                       fmt::format("rows are missing in the band from {:.3g} Hz: the periods do not fit "
                                   "together",
                                   run.bands[experiment.band].from_Hz),
                       "measure again"},
                      run.rowLoss));
    }
    return {};
}

/// Commands and positions of all axes, column by column.
struct Columns {
    std::vector<std::vector<double>> commands, positions;
};

Result<Columns> columnsOf(const devices::Catalogue& catalogue, const AxesFrequencyRun& run) {
    Columns columns;
    for (const devices::AxisSpec& axis : run.axes) {
        auto command = columnOf(run.recording, signalOf(catalogue, axis.roles.command));
        auto position = columnOf(run.recording, signalOf(catalogue, axis.roles.position));
        if (!command || !position) {
            return failure(!command ? command.error() : position.error());
        }
        columns.commands.push_back(*std::move(command));
        columns.positions.push_back(*std::move(position));
    }
    return columns;
}

std::vector<std::vector<double>> part(const std::vector<std::vector<double>>& columns, std::size_t first,
                                      std::size_t rows) {
    std::vector<std::vector<double>> parts;
    for (const std::vector<double>& column : columns) {
        const auto begin = column.begin() + static_cast<std::ptrdiff_t>(first);
        parts.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(rows));
    }
    return parts;
}

Result<std::vector<control::MatrixPoint>> pointsOfBand(const AxesFrequencyRun& run, const Columns& columns,
                                                       std::size_t band) {
    const std::size_t rows = static_cast<std::size_t>(run.config.periods) * run.plan.rowsPerPeriod;
    control::MatrixRows matrix{
        run.plan.period_s, run.plan.rowsPerPeriod, run.plan.bands[band].lines(run.axes.size()), {}};
    for (const AxesExperiment& experiment : run.experiments) {
        if (experiment.band != band) {
            continue;
        }
        if (auto whole = checkRows(run, experiment, rows); !whole) {
            return failure(whole.error());
        }
        matrix.experiments.push_back({part(columns.commands, experiment.firstRow, rows),
                                      part(columns.positions, experiment.firstRow, rows)});
    }
    return control::estimateMatrix(matrix);
}

/// Responses of the laws at one frequency with the delay of the loop.
Eigen::VectorXcd lateLaws(const AxesFrequencyRun& run, double frequency_rad_s) {
    Eigen::VectorXcd laws(static_cast<Eigen::Index>(run.laws.size()));
    for (std::size_t i = 0; i < run.laws.size(); ++i) {
        const double late_rad = -frequency_rad_s * run.plan.period_s * run.laws[i].delaySamples;
        laws(static_cast<Eigen::Index>(i)) =
            std::polar(1.0, late_rad) * control::feedbackResponse(run.laws[i], frequency_rad_s);
    }
    return laws;
}

/// The command is told before its delay: the plant is what follows it.
void takeOutDelay(control::MatrixPoint& point, const AxesFrequencyRun& run) {
    for (Eigen::Index j = 0; j < point.value.cols(); ++j) {
        const double late_rad =
            point.frequency_rad_s * run.plan.period_s * run.laws[static_cast<std::size_t>(j)].delaySamples;
        point.value.col(j) *= std::polar(1.0, late_rad);
        point.inverse.col(j) *= std::polar(1.0, late_rad);
    }
}

control::MeasuredMargins marginsOf(const std::vector<AxesFrequencyPoint>& points, std::size_t axis) {
    control::MeasuredLoop loop;
    for (const AxesFrequencyPoint& point : points) {
        if (point.isUsed[axis]) {
            loop.response.frequency_rad_s.push_back(point.plant.frequency_rad_s);
            loop.response.value.push_back(point.loop.loops[axis].value);
            loop.radius.push_back(point.loop.loops[axis].radius);
        }
    }
    return control::measuredMargins(loop, {});
}

MeasuredPeak peakOf(const std::vector<AxesFrequencyPoint>& points,
                    control::LoopFigure control::MatrixLoopPoint::*figure) {
    MeasuredPeak peak;
    const AxesFrequencyPoint* first = nullptr;
    const AxesFrequencyPoint* last = nullptr;
    const AxesFrequencyPoint* highest = nullptr;
    for (const AxesFrequencyPoint& point : points) {
        if (!point.isWhole()) {
            continue;
        }
        first = first == nullptr ? &point : first;
        last = &point;
        if (highest == nullptr || (point.loop.*figure).value.real() > (highest->loop.*figure).value.real()) {
            highest = &point;
        }
    }
    if (highest == nullptr) {
        return peak;
    }
    peak.withheld =
        highest == first || highest == last ? MeasuredPeak::Withheld::Edge : MeasuredPeak::Withheld::No;
    peak.frequency_rad_s = highest->plant.frequency_rad_s;
    peak.value = (highest->loop.*figure).value.real();
    peak.radius = (highest->loop.*figure).radius;
    return peak;
}

double limitedShare(const devices::Catalogue& catalogue, const AxesFrequencyRun& run) {
    const std::vector<double> scale = run.recording.column(signalOf(catalogue, "current_scale"));
    const std::size_t first = run.experiments.empty() ? 0 : run.experiments.front().firstRow;
    std::size_t limited = 0;
    for (std::size_t row = first; row < scale.size(); ++row) {
        limited += scale[row] < 1.0 ? 1U : 0U;
    }
    return scale.size() > first ? static_cast<double>(limited) / static_cast<double>(scale.size() - first)
                                : 0.0;
}

bool wasSensorLeftOut(const devices::Catalogue& catalogue, const Recording& recording) {
    const std::vector<double> leftOut = recording.column(signalOf(catalogue, "sensors_left_out"));
    return std::any_of(leftOut.begin(), leftOut.end(), [](double sensors) { return sensors != 0.0; });
}

/// Whole sentences of each margin, so that each can be said in another language.
struct MarginWords {
    const char* code;
    const char* noCrossing;
    const char* gap;
    const char* uncertain;
    const char* allowed;
};
constexpr MarginWords PhaseWords = {
    "phase_margin_withheld",
    "axis {}: no phase margin: the loop crosses nowhere on the frequencies that are used",
    "axis {}: no phase margin: the loop crosses where frequencies were left out or are far apart",
    "axis {}: no phase margin: its interval is {:.2g} deg to either side",
    "{:.2g} deg are allowed: measure more periods or with more effort"};
constexpr MarginWords GainWords = {
    "gain_margin_withheld",
    "axis {}: no gain margin: the loop crosses nowhere on the frequencies that are used",
    "axis {}: no gain margin: the loop crosses where frequencies were left out or are far apart",
    "axis {}: no gain margin: its interval is {:.2g} dB to either side",
    "{:.2g} dB are allowed: measure more periods or with more effort"};

void addWithheld(DataQuality& quality, const std::string& axis, const MeasuredMargin& margin,
                 const MarginWords& words, double tolerance) {
    switch (margin.withheld) {
    case MeasuredMargin::Withheld::No:
        return;
    case MeasuredMargin::Withheld::NoCrossing:
        quality.findings.push_back({words.code, fmt::format(fmt::runtime(words.noCrossing), axis),
                                    "use a higher end frequency, or a lower start frequency"});
        return;
    case MeasuredMargin::Withheld::Gap:
        quality.findings.push_back({words.code, fmt::format(fmt::runtime(words.gap), axis),
                                    "measure with more periods or more effort there"});
        return;
    case MeasuredMargin::Withheld::Uncertain: {
        const auto [low, high] = *margin.interval;
        quality.findings.push_back({words.code,
                                    fmt::format(fmt::runtime(words.uncertain), axis, 0.5 * (high - low)),
                                    fmt::format(fmt::runtime(words.allowed), tolerance)});
        return;
    }
    }
}

void addUseFinding(DataQuality& quality, const AxesFrequencyResult& result, std::size_t axis) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [axis](const AxesFrequencyPoint& point) { return point.isUsed[axis]; });
    const auto count = static_cast<std::ptrdiff_t>(result.points.size());
    if (2 * used < count) {
        quality.verdict = std::max(quality.verdict, used == 0 ? Verdict::Refused : Verdict::Doubtful);
    }
    if (used < count) {
        quality.findings.push_back(
            {"incoherent_points",
             fmt::format("axis {}: {} of {} frequencies have a coherence below {:.3g} and were left out",
                         result.axes[axis].axis.id, count - used, count, result.config.leastCoherence),
             "measure more periods or with more effort"});
    }
}

void addPeakFinding(DataQuality& quality, const MeasuredPeak& peak, const char* code, const char* atEdge,
                    const char* nowhere) {
    if (peak.withheld != MeasuredPeak::Withheld::No) {
        quality.findings.push_back({code, peak.withheld == MeasuredPeak::Withheld::Edge ? atEdge : nowhere,
                                    "use a higher end frequency, or a lower start frequency"});
    }
}

} // namespace

bool AxesFrequencyPoint::isWhole() const {
    return std::all_of(isUsed.begin(), isUsed.end(), [](bool isAxisUsed) { return isAxisUsed; });
}

Result<AxesFrequencyResult> estimateAxesFrequency(const devices::Catalogue& catalogue, AxesFrequencyRun run) {
    const auto columns = columnsOf(catalogue, run);
    if (!columns) {
        return failure(columns.error());
    }
    AxesFrequencyResult result;
    result.config = run.config;
    result.bands = run.bands;
    result.period_s = run.plan.period_s;
    result.delaySamples = run.laws.front().delaySamples;
    Eigen::VectorXd scale(static_cast<Eigen::Index>(run.axes.size()));
    for (std::size_t i = 0; i < run.axes.size(); ++i) {
        scale(static_cast<Eigen::Index>(i)) = loopAxisOf(run.axes[i]).testStep;
    }
    std::vector<control::MatrixPoint> plant;
    for (std::size_t band = 0; band < run.bands.size(); ++band) {
        const auto more = pointsOfBand(run, *columns, band);
        if (!more) {
            return failure(more.error());
        }
        plant.insert(plant.end(), more->begin(), more->end());
    }
    std::vector<Eigen::VectorXcd> laws;
    for (control::MatrixPoint& point : plant) {
        takeOutDelay(point, run);
        laws.push_back(lateLaws(run, point.frequency_rad_s));
    }
    const auto loops = control::closeMatrixLoops(plant, laws, scale);
    for (std::size_t i = 0; i < plant.size(); ++i) {
        AxesFrequencyPoint point{plant[i], loops[i], {}};
        for (const double coherence : plant[i].coherence) {
            point.isUsed.push_back(coherence >= run.config.leastCoherence);
        }
        result.points.push_back(std::move(point));
    }
    for (std::size_t i = 0; i < run.axes.size(); ++i) {
        result.axes.push_back({run.axes[i], run.laws[i], marginsOf(result.points, i)});
    }
    result.sensitivity = peakOf(result.points, &control::MatrixLoopPoint::sensitivity);
    result.complementary = peakOf(result.points, &control::MatrixLoopPoint::complementary);
    result.limited_ratio = limitedShare(catalogue, run);
    result.wasSensorLeftOut = wasSensorLeftOut(catalogue, run.recording);
    result.highestTemperature_degC = highestCoil_degC(catalogue, run.recording);
    const std::vector<double>& time_s = run.recording.time_s;
    result.duration_s = time_s.empty() ? 0.0 : time_s.back() - time_s.front();
    result.recording = std::move(run.recording);
    return result;
}

DataQuality judgeAxesFrequency(const AxesFrequencyResult& result) {
    DataQuality quality;
    const control::MarginTolerance tolerance;
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        const AxisResponse& response = result.axes[i];
        addUseFinding(quality, result, i);
        addWithheld(quality, response.axis.id, response.margins.phase_deg, PhaseWords, tolerance.phase_deg);
        addWithheld(quality, response.axis.id, response.margins.gain_dB, GainWords, tolerance.gain_dB);
    }
    addPeakFinding(quality, result.sensitivity, "sensitivity_peak_withheld",
                   "no peak of the sensitivity: it is largest at the end of the frequencies that are used",
                   "no peak of the sensitivity: at no frequency all axes are coherent");
    addPeakFinding(quality, result.complementary, "complementary_peak_withheld",
                   "no peak of the complementary sensitivity: it is largest at the end of the frequencies "
                   "that are used",
                   "no peak of the complementary sensitivity: at no frequency all axes are coherent");
    if (result.wasSensorLeftOut) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back({"sensor_left_out",
                                    "the board went on without one of its sensors: the position changed its "
                                    "noise and its errors meanwhile",
                                    "check the sensors and their cables, and measure again"});
    }
    constexpr double NotableShare = 1e-3;
    if (result.limited_ratio > NotableShare) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(
            {"current_limit_reached",
             fmt::format("in {:.2g} % of the samples the currents were at their limit: the command did not "
                         "flow as told",
                         100.0 * result.limited_ratio),
             "measure with less effort"});
    }
    return quality;
}

} // namespace halbench::app
