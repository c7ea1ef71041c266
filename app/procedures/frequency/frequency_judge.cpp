#include "app/procedures/frequency/frequency_judge.h"

#include "app/procedures/base/coil_forecast.h"
#include "control/base/units.h"
#include "control/identify/swept_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halbench::app {
namespace {

using control::MeasuredMargin;
using Complex = std::complex<double>;

/// Gain class of Hall sensors that nobody calibrated (help: htm-theory.md 9): the compensation of the stray
/// field is as wrong as they are.
constexpr double UncalibratedStray_ratio = 0.05;

/// What the compensation of the stray field may be wrong by, from the class of the sensors or a calibration
/// and the sensors' heat.
double knownStrayError_rad_per_A(const FrequencyRun& run) {
    const StrayField& stray = *run.stray;
    const double coefficient_T_per_A = std::abs(stray.coefficient_T_per_A);
    const double heat_ratio = std::abs(stray.sensorTemperature_per_K) * run.sensorExcess_K;
    const double error_T_per_A = stray.error_T_per_A.value_or(UncalibratedStray_ratio * coefficient_T_per_A);
    return (error_T_per_A + heat_ratio * coefficient_T_per_A) / stray.amplitude_T;
}

void doubtCompensation(FrequencyResult& result) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    result.quality.findings.push_back(
        {"stray_field_wrong",
         fmt::format("the compensation of the stray field leaves {:.2g} deg per ampere, more than it should",
                     radiansToDegrees(*result.fit->feedthrough.value)),
         "calibrate the stray field, then measure again"});
}

/// The angle that an ampere turns, as far as both the points and what is known of the compensation allow it;
/// as the points alone allow it where these contradict each other, which is a finding. Its half width goes
/// into the result. Gives its middle.
double takeStray_rad_per_A(FrequencyResult& result, const FrequencyRun& run) {
    if (!run.stray) {
        return 0.0;
    }
    const double known_rad_per_A = knownStrayError_rad_per_A(run);
    result.strayError_rad_per_A = known_rad_per_A;
    if (!result.fit) {
        return 0.0;
    }
    auto [low, high] = *result.fit->feedthrough.interval95;
    if (low > known_rad_per_A || high < -known_rad_per_A) {
        doubtCompensation(result);
    } else {
        low = std::max(low, -known_rad_per_A);
        high = std::min(high, known_rad_per_A);
    }
    result.strayError_rad_per_A = 0.5 * (high - low);
    return 0.5 * (low + high);
}

/// The points are of the plant: what the current itself turns, a sample late, is no part of it.
void takeOut(control::PlantPoint& point, double stray_rad_per_A, double period_s) {
    point.value -= stray_rad_per_A * std::polar(1.0, -point.frequency_rad_s * period_s);
}

Result<void> checkRows(const FrequencyRun& run, double at_Hz, std::size_t first, std::size_t rows) {
    const std::vector<double>& time_s = run.recording.time_s;
    const double expected_s = static_cast<double>(rows - 1) * run.margins.period_s;
    if (first + rows > time_s.size() ||
        std::abs(time_s[first + rows - 1] - time_s[first] - expected_s) > 0.5 * run.margins.period_s) {
        return failure(withCause(
            {ErrorCode::Refused,
             fmt::format("rows missing near {} Hz: the periods are not consistent", at_Hz), "measure again"},
            run.rowLoss));
    }
    return {};
}

Result<std::vector<control::PlantPoint>> sweptPointsOf(const FrequencyRun& run,
                                                       const MeasuredStage& measured) {
    const FrequencyStage& stage = measured.stage;
    for (const std::size_t first : measured.sweepRows) {
        if (auto whole = checkRows(run, stage.reference.frequency_Hz, first, stage.rowsPerPeriod); !whole) {
            return failure(whole.error());
        }
    }
    constexpr double SettledShare = 0.4; // of a rest, at its end
    const std::vector<double> reference = run.recording.column("reference");
    const std::vector<double> input = run.recording.column("current_command");
    const std::vector<double> output = run.recording.column("position");
    control::SweptRows rows;
    rows.period_s = run.margins.period_s;
    rows.rowsPerSweep = stage.rowsPerPeriod;
    rows.restRows = static_cast<std::size_t>(SettledShare * stage.rest_s / run.margins.period_s);
    rows.starts = measured.sweepRows;
    rows.turn_rad_s = run.turn_rad_s;
    rows.lowest_rad_s = 2.0 * Pi * stage.reference.frequency_Hz;
    rows.highest_rad_s = 2.0 * Pi * stage.to_Hz;
    rows.points = static_cast<int>(stage.lines.size());
    rows.reference = reference;
    rows.input = input;
    rows.output = output;
    return control::estimateSweptPlant(rows);
}

Result<std::vector<control::PlantPoint>> pointsOf(const FrequencyRun& run, const MeasuredStage& measured) {
    if (measured.stage.sweeps > 0) {
        return sweptPointsOf(run, measured);
    }
    const std::size_t rows = static_cast<std::size_t>(run.config.periods) * measured.stage.rowsPerPeriod;
    if (auto whole = checkRows(run, measured.stage.reference.frequency_Hz, measured.firstRow, rows); !whole) {
        return failure(whole.error());
    }
    const auto part = [&](const std::vector<double>& column) {
        return std::span(column).subspan(measured.firstRow, rows);
    };
    const std::vector<double> reference = run.recording.column("reference");
    const std::vector<double> input = run.recording.column("current_command");
    const std::vector<double> output = run.recording.column("position");
    return control::estimatePlant({run.margins.period_s, measured.stage.rowsPerPeriod, measured.stage.lines,
                                   run.turn_rad_s, part(reference), part(input), part(output)});
}

FrequencyBand bandOf(const FrequencyStage& stage) {
    const MoveReference& reference = stage.reference;
    return {reference.frequency_Hz, stage.to_Hz, static_cast<int>(stage.lines.size()), reference.amplitude};
}

bool isCoherent(const control::PlantPoint& point, const FrequencyConfig& config) {
    return point.coherence >= config.leastCoherence;
}

FrequencyResultPoint judged(const control::PlantPoint& measured, const FrequencyRun& run,
                            double stray_rad_per_A) {
    FrequencyResultPoint point;
    point.measured = measured;
    point.radius = measured.radius + run.config.gainError_ratio * std::abs(measured.value) + stray_rad_per_A;
    const double w = measured.frequency_rad_s;
    const Complex late = std::polar(1.0, -w * run.margins.period_s * run.margins.law.delaySamples);
    const Complex controller = late * control::feedbackResponse(run.margins.law, w);
    point.openLoop = controller * measured.value;
    point.openLoopRadius = std::abs(controller) * point.radius;
    point.closedLoop = point.openLoop / (1.0 + point.openLoop);
    point.isUsed = isCoherent(measured, run.config);
    return point;
}

constexpr double Negligible_ratio = 1e-3; // of the torque: far below what a current is known to
constexpr double Notable_ratio = 0.05;    // an interval wider than this says little of damping

/// The lower the frequency, the more of the torque is damping.
double lowestOf(const std::vector<control::PlantPoint>& points) {
    double lowest_rad_s = points.empty() ? 1.0 : points.front().frequency_rad_s;
    for (const control::PlantPoint& point : points) {
        lowest_rad_s = std::min(lowest_rad_s, point.frequency_rad_s);
    }
    return lowest_rad_s;
}

bool isClearlyNegative(const control::Estimate& damping_per_s, double lowest_rad_s) {
    return damping_per_s.interval95 && damping_per_s.interval95->second < 0.0 &&
           *damping_per_s.value < -Negligible_ratio * lowest_rad_s;
}

std::optional<control::FrequencyFit> fitOf(const std::vector<control::PlantPoint>& points,
                                           const FrequencyRun& run) {
    std::vector<control::PlantPoint> used;
    std::copy_if(points.begin(), points.end(), std::back_inserter(used),
                 [&run](const control::PlantPoint& point) { return isCoherent(point, run.config); });
    auto fit = control::fitSampledPlant(used, run.margins.period_s, run.config.actuatorLag_s,
                                        run.config.gainError_ratio);
    if (fit && fit->dampingRate.interval95 && !isClearlyNegative(fit->dampingRate, lowestOf(points))) {
        // No rotor has less than no damping: what the points cannot tell from zero begins there.
        auto& [low, high] = *fit->dampingRate.interval95;
        high = std::max({high, -*fit->dampingRate.value, 0.0});
        low = std::max(low, 0.0);
        fit->dampingRate.value = std::max(*fit->dampingRate.value, 0.0);
    }
    return fit ? std::optional(std::move(*fit)) : std::nullopt;
}

// What physics excludes: a rotor that its current drives backwards, or that speeds itself up.
void judgeRotor(DataQuality& quality, const control::FrequencyFit& fit, double lowest_rad_s) {
    const auto gain95 = fit.accelerationGain.interval95;
    const auto damping95 = fit.dampingRate.interval95;
    if (!(*fit.accelerationGain.value > 0.0)) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back({"sign_reversed",
                                    "wrong sign of current or angle: negative torque constant",
                                    "invert one of the two signs on the device, then measure again"});
    } else if (gain95 && !(gain95->first > 0.0)) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back({"interval_reaches_zero", "the interval of phi/J includes zero",
                                    "use more periods or a larger amplitude"});
    }
    if (!damping95 || damping95->first > 0.0) {
        return;
    }
    const double most_ratio = damping95->second / lowest_rad_s;
    if (isClearlyNegative(fit.dampingRate, lowest_rad_s)) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back({"damping_below_zero", "negative damping, not possible for a motor",
                                    "check the loop delay and that nothing else drives the rotor"});
    } else if (most_ratio > Notable_ratio) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(
            {"damping_below_zero",
             fmt::format(
                 "damping undetermined: between zero and {:.2g} % of the torque at the lowest frequency",
                 100.0 * most_ratio),
             "use a lower start frequency, more periods or a larger amplitude"});
    }
}

control::MeasuredMargins marginsOf(const std::vector<FrequencyResultPoint>& points) {
    control::MeasuredLoop loop;
    for (const FrequencyResultPoint& point : points) {
        if (point.isUsed) {
            loop.response.frequency_rad_s.push_back(point.measured.frequency_rad_s);
            loop.response.value.push_back(point.openLoop);
            loop.radius.push_back(point.openLoopRadius);
        }
    }
    return control::measuredMargins(loop, {});
}

double largest(std::span<const double> values) {
    double result = 0.0;
    for (const double value : values) {
        result = std::max(result, std::abs(value));
    }
    return result;
}

void takeFigures(FrequencyResult& result, const FrequencyRun& run) {
    const Recording& recording = run.recording;
    result.duration_s = recording.time_s.empty() ? 0.0 : recording.time_s.back() - recording.time_s.front();
    const std::string coils[] = {"coil_temperature.a", "coil_temperature.b"};
    result.highestTemperature_degC = highestCoil_degC(coils, recording);
    const std::size_t first = run.stages.empty() ? 0 : run.stages.front().firstRow; // the run-up is over
    const std::vector<double> current_A = recording.column("current_command");
    const std::vector<double> speed_rad_s = recording.column("speed");
    result.highestCurrent_A = largest(std::span(current_A).subspan(first));
    result.lowestSpeed_rad_s = std::abs(run.turn_rad_s);
    const double sign = run.turn_rad_s < 0.0 ? -1.0 : 1.0;
    for (std::size_t row = first; row < speed_rad_s.size(); ++row) {
        result.lowestSpeed_rad_s = std::min(result.lowestSpeed_rad_s, sign * speed_rad_s[row]);
    }
}

/// Whole sentences of each margin, so that each can be said in another language.
struct MarginWords {
    const char* code;
    const char* noCrossing;
    const char* gap;
    const char* uncertain;
    const char* unbounded;
    const char* allowed;
};

constexpr MarginWords PhaseWords = {
    "phase_margin_withheld",
    "no phase margin: no gain crossover among the valid frequencies",
    "no phase margin: gain crossover in a range without valid frequencies",
    "no phase margin: between {:.3g} and {:.3g} deg, uncertainty at best {:.2g}",
    "no phase margin: the phase at the gain crossover is completely uncertain",
    "allowed: {:.2g} deg; use more periods, and calibrate the sensor gains and the stray field first"};
constexpr MarginWords GainWords = {
    "gain_margin_withheld",
    "no gain margin: no phase crossover among the valid frequencies",
    "no gain margin: phase crossover in a range without valid frequencies",
    "no gain margin: between {:.3g} and {:.3g} dB, uncertainty at best {:.2g}",
    "no gain margin: the magnitude at the phase crossover is completely uncertain",
    "allowed: {:.2g} dB; use more periods, and calibrate the sensor gains and the stray field first"};

void addWithheld(DataQuality& quality, const MeasuredMargin& margin, const MarginWords& words,
                 double tolerance) {
    switch (margin.withheld) {
    case MeasuredMargin::Withheld::No:
        return;
    case MeasuredMargin::Withheld::NoCrossing:
        quality.findings.push_back(
            {words.code, words.noCrossing, "use a higher end frequency, or a lower start frequency"});
        return;
    case MeasuredMargin::Withheld::Gap:
        quality.findings.push_back({words.code, words.gap, "use more periods or a larger amplitude there"});
        return;
    case MeasuredMargin::Withheld::Uncertain: {
        const auto [low, high] = *margin.interval;
        quality.findings.push_back({words.code,
                                    std::isfinite(high - low) ? fmt::format(fmt::runtime(words.uncertain),
                                                                            low, high, 0.5 * (high - low))
                                                              : words.unbounded,
                                    fmt::format(fmt::runtime(words.allowed), tolerance)});
        return;
    }
    }
}

void addUseFindings(DataQuality& quality, const FrequencyResult& result) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [](const FrequencyResultPoint& point) { return point.isUsed; });
    const auto count = static_cast<std::ptrdiff_t>(result.points.size());
    if (2 * used < count) {
        quality.verdict = used == 0 ? Verdict::Refused : Verdict::Doubtful;
    }
    if (used < count) {
        quality.findings.push_back(
            {"incoherent_points",
             fmt::format("{} of {} frequencies have a coherence below {:.3g} and were excluded", count - used,
                         count, result.config.leastCoherence),
             "use more periods or a larger amplitude"});
    }
    constexpr double Share = 0.999; // of the limit: the command is rounded
    if (result.highestCurrent_A >= Share * result.law.limit_A) {
        quality.findings.push_back({"current_limit_reached",
                                    fmt::format("the current reached its limit of {:.3g} A: the plant is "
                                                "valid, the closed loop was not linear",
                                                result.law.limit_A),
                                    "use a smaller amplitude"});
    }
}

} // namespace

Result<FrequencyResult> estimateFrequency(FrequencyRun run) {
    FrequencyResult result;
    result.config = run.config;
    result.turn_rad_s = run.turn_rad_s;
    result.period_s = run.margins.period_s;
    result.law = run.margins.law;
    std::vector<control::PlantPoint> points;
    for (const MeasuredStage& stage : run.stages) {
        result.bands.push_back(bandOf(stage.stage));
        const auto more = pointsOf(run, stage);
        if (!more) {
            return failure(more.error());
        }
        points.insert(points.end(), more->begin(), more->end());
    }
    result.fit = fitOf(points, run);
    const double stray_rad_per_A = takeStray_rad_per_A(result, run);
    if (result.fit) {
        result.fit->rotor.feedthrough_rad_per_A -= stray_rad_per_A; // it is compared with the points
    }
    for (control::PlantPoint& point : points) {
        takeOut(point, stray_rad_per_A, result.period_s);
        result.points.push_back(judged(point, run, result.strayError_rad_per_A));
    }
    result.margins = marginsOf(result.points);
    takeFigures(result, run);
    result.recording = std::move(run.recording);
    result.wasStrayUncompensated = run.stray && !run.stray->isCompensated;
    return result;
}

DataQuality judgeFrequency(const FrequencyResult& result) {
    DataQuality quality = result.quality; // what the estimate found
    addUseFindings(quality, result);
    const control::MarginTolerance tolerance;
    addWithheld(quality, result.margins.phase_deg, PhaseWords, tolerance.phase_deg);
    addWithheld(quality, result.margins.gain_dB, GainWords, tolerance.gain_dB);
    if (result.wasStrayUncompensated) {
        quality.findings.push_back(
            {"stray_field_was_off",
             "stray-field compensation was on during the measurement, but is off on the device",
             "switch stray.enabled on: the measured loop includes it"});
    }
    if (!result.fit && quality.verdict != Verdict::Refused) {
        quality.verdict = Verdict::Doubtful;
        quality.findings.push_back({"no_rotor_fit", "the points do not determine the constants of a rotor",
                                    "measure more frequencies, from 0.5 Hz or lower"});
    }
    if (result.fit) {
        std::vector<control::PlantPoint> points;
        for (const FrequencyResultPoint& point : result.points) {
            points.push_back(point.measured);
        }
        judgeRotor(quality, *result.fit, lowestOf(points));
    }
    constexpr double NotableMisfit_ratio = 2.0;
    if (result.fit && result.fit->misfit_ratio > NotableMisfit_ratio) {
        quality.findings.push_back(
            {"rotor_misfit",
             fmt::format("distance of the points from the fitted rotor: {:.2g} times their scatter",
                         result.fit->misfit_ratio),
             "the intervals are widened by this factor; check for a resonance or an angle error"});
    }
    return quality;
}

} // namespace halbench::app
