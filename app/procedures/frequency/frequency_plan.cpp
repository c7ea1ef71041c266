#include "app/procedures/frequency/frequency_plan.h"

#include "app/procedures/base/checked_range.h"
#include "control/assess/filtered_loop.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::app {
namespace {

using Complex = std::complex<double>;

constexpr double SlowestBase_rad_s = 3.0; // below it friction is no plain offset (help: htm-theory.md 7.4)
constexpr double ReferenceShare = 0.8;    // of the base speed that the reference's own may swing
constexpr double RotorShare = 0.5;        // and the rotor's, as far as it can be foreseen
constexpr double CurrentShare = 0.6;      // of what the base motion leaves of the current limit
constexpr double LargestAmplitude_rad = 5.0 * Pi / 180.0;
constexpr double RunUp_s = 8.0; // the published loop, the least damped preset, has 2 % of its swing left
constexpr int LinesOfBand = 20;
constexpr double WidestBand_ratio = 4.8;
constexpr double PeriodsOfLowest = 4.0;
// Turns in one period end on this fraction, so that the harmonics of the turn fall between the lines and come
// with another phase each period.
constexpr double TurnFraction = 0.382;
constexpr int SegmentsOfPeriod = 4; // a stepped sine needs less time for each of its lines

double fastestBase_rad_s(const FrequencyConfig& config) {
    return 0.5 * config.speedLimit_rad_s;
}

Result<void> checkConfig(const FrequencyConfig& config, double period_s) {
    constexpr double LowestFrequency_Hz = 0.1;
    constexpr double HighestShare = 0.45; // of the sampling rate; beyond it the held rotor tells little
    const double highest_Hz = HighestShare / period_s;
    Result<void> valid = checkRange("lowest frequency in Hz", config.from_Hz, LowestFrequency_Hz, highest_Hz);
    valid =
        valid ? checkRange("highest frequency in Hz", config.to_Hz, 1.5 * config.from_Hz, highest_Hz) : valid;
    valid = valid ? checkRange("number of periods", config.periods, 4, 64) : valid;
    valid = valid ? checkRange("minimum coherence", config.leastCoherence, 0.5, 0.999) : valid;
    valid = valid ? checkRange("amplitude in rad", config.amplitude_rad.value_or(0.01), 1e-5, 1.0) : valid;
    if (!valid) {
        return valid;
    }
    const double speed_rad_s = std::abs(config.base_rad_s);
    if (speed_rad_s < SlowestBase_rad_s) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format(
                "a base speed of {:.3g} rad/s is too low: friction is a constant offset only during rotation",
                config.base_rad_s),
            fmt::format("use at least {} rad/s in either direction", SlowestBase_rad_s));
    }
    return checkRange("base speed in rad/s", speed_rad_s, SlowestBase_rad_s, fastestBase_rad_s(config));
}

/// The next speed upwards whose turns in a period end on TurnFraction; where that is faster than
/// `most_rad_s`, the next downwards.
Result<double> spreadSpeed_rad_s(double wanted_rad_s, double period_s, double most_rad_s) {
    const double turn_rad_s = 2.0 * Pi / period_s;
    const double turns = std::abs(wanted_rad_s) / turn_rad_s;
    const double above = std::ceil(turns - TurnFraction) + TurnFraction;
    for (const double spread : {above, above - 1.0}) {
        const double speed_rad_s = spread * turn_rad_s;
        if (speed_rad_s >= SlowestBase_rad_s && speed_rad_s <= most_rad_s) {
            return std::copysign(speed_rad_s, wanted_rad_s);
        }
    }
    return failure(ErrorCode::OutOfRange,
                   fmt::format("no base speed from {} to {:.3g} rad/s separates the harmonics of the "
                               "rotation from the lines: a period is only {:.3g} s",
                               SlowestBase_rad_s, most_rad_s, period_s),
                   "use a smaller lowest frequency; the period becomes longer");
}

std::vector<int> bandLines(int from, int to) {
    const int step =
        std::max(1, static_cast<int>(std::ceil((to - from) / static_cast<double>(LinesOfBand - 1))));
    std::vector<int> lines;
    for (int line = from; line <= to; line += step) {
        lines.push_back(line);
    }
    return lines;
}

/// Bands one after the other, each beginning a step behind the one before.
std::vector<std::vector<int>> multisineLines(int from, int to) {
    const double ratio = static_cast<double>(to) / from;
    const int bands = std::max(1, static_cast<int>(std::ceil(std::log(ratio) / std::log(WidestBand_ratio))));
    std::vector<std::vector<int>> all;
    int next = from;
    for (int band = 1; band <= bands && next <= to; ++band) {
        const int end =
            static_cast<int>(std::lround(from * std::pow(ratio, static_cast<double>(band) / bands)));
        all.push_back(bandLines(next, std::max(end, next)));
        const std::vector<int>& lines = all.back();
        next = lines.back() + (lines.size() > 1 ? lines[1] - lines[0] : 1);
    }
    return all;
}

/// Half an octave apart, each a multiple of `grid`.
std::vector<std::vector<int>> steppedLines(int from, int to, int grid) {
    std::vector<std::vector<int>> all;
    int previous = 0;
    for (double line = from; line <= to + 0.5 * grid; line *= std::sqrt(2.0)) {
        const int rounded = std::max(grid, grid * static_cast<int>(std::lround(line / grid)));
        if (rounded > previous && rounded <= to) {
            all.push_back({rounded});
            previous = rounded;
        }
    }
    return all;
}

/// Largest value of a sum of sines with the generator's phases -pi k (k-1)/n; weights are amplitudes.
double peakOf(const std::vector<double>& frequency_rad_s, const std::vector<double>& weights,
              double period_s) {
    constexpr int Places = 4000;
    const double n = static_cast<double>(weights.size());
    double peak = 0.0;
    for (int place = 0; place < Places; ++place) {
        const double time_s = period_s * place / Places;
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double k = static_cast<double>(i + 1);
            sum += weights[i] * std::sin(frequency_rad_s[i] * time_s - Pi * k * (k - 1.0) / n);
        }
        peak = std::max(peak, std::abs(sum));
    }
    return peak;
}

/// Where a sweep that lasts `period_s` and evaluates `lines` would get in the generator's slack.
double sweptEnd_Hz(const std::vector<int>& lines, double period_s) {
    const double from_Hz = lines.front() / period_s;
    const double to_Hz = lines.back() / period_s;
    return to_Hz + (to_Hz - from_Hz) * GeneratorSlack_s / period_s;
}

/// What one radian of amplitude makes of a band.
struct Reach {
    double referenceSpeed_rad_s = 0.0;
    double rotorSpeed_rad_s = 0.0;
    double current_A = 0.0;
};

Reach reachOf(const std::vector<int>& lines, double period_s, const FrequencyMargins& margins) {
    const double share = 1.0 / std::sqrt(static_cast<double>(lines.size()));
    std::vector<double> frequency_rad_s;
    std::vector<double> speed, rotor, current;
    const auto plant = control::sampledPlant(margins.plant, margins.period_s);
    for (const int line : lines) {
        const double w = 2.0 * Pi * line / period_s;
        const Complex C = control::feedbackResponse(margins.law, w);
        const Complex forward = Complex(-w * w * margins.law.inertia_As2_per_rad,
                                        w * margins.law.viscous_As_per_rad); // feed-forward
        const Complex drive = C + forward; // set-point weights only make it less
        const Complex late = std::polar(1.0, -w * margins.period_s * margins.law.delaySamples);
        const Complex L = C * late * plant.atFrequency(w);
        frequency_rad_s.push_back(w);
        speed.push_back(share * w);
        current.push_back(share * std::abs(drive / (1.0 + L)));
        rotor.push_back(share * w * std::abs(drive * late * plant.atFrequency(w) / (1.0 + L)));
    }
    return {peakOf(frequency_rad_s, speed, period_s), peakOf(frequency_rad_s, rotor, period_s),
            peakOf(frequency_rad_s, current, period_s)};
}

double baseCurrent_A(const FrequencyMargins& margins, double turn_rad_s) {
    return margins.plant.breakawayCurrent_A +
           std::abs(turn_rad_s) * margins.plant.dampingRate_1_s / margins.plant.accelerationGain_rad_s2_A;
}

/// Of a sweep over a band, up to where the generator would get before the next stage takes over.
Reach sweptReach(const std::vector<int>& lines, double period_s, const FrequencyMargins& margins) {
    std::vector<int> passed = lines;
    passed.push_back(static_cast<int>(std::ceil(sweptEnd_Hz(lines, period_s) * period_s)));
    Reach largest;
    for (const int line : passed) {
        const Reach one = reachOf({line}, period_s, margins);
        largest.referenceSpeed_rad_s = std::max(largest.referenceSpeed_rad_s, one.referenceSpeed_rad_s);
        largest.rotorSpeed_rad_s = std::max(largest.rotorSpeed_rad_s, one.rotorSpeed_rad_s);
        largest.current_A = std::max(largest.current_A, one.current_A);
    }
    return largest;
}

/// Until the loop's swing has come to 0.2 % of what a sweep made of it, as far as it can be foreseen. The
/// law's integral is left out: it creeps, and that is fitted as a drift.
double restOf_s(const FrequencyMargins& margins) {
    constexpr double Shortest_s = 2.0;
    constexpr double Longest_s = 15.0;
    constexpr double Left_ratio = 0.002;
    control::FilteredLaw law = control::filteredLaw(margins.law);
    law.gains.integral = 0.0;
    law.proportionalWeight = 1.0; // of the reference, not of the loop
    const control::LoopTiming timing{margins.period_s, margins.law.delaySamples};
    const double radius = control::filteredPoleRadius(margins.plant, law, timing).value_or(1.0);
    if (!(radius < 1.0)) {
        return Longest_s; // the run ends where the rotor comes near standstill
    }
    return std::clamp(margins.period_s * std::log(Left_ratio) / std::log(radius), Shortest_s, Longest_s);
}

/// A band and what one radian of amplitude makes of it.
struct Band {
    std::vector<int> lines;
    Reach reach;
};

Result<void> checkAmplitude(const FrequencyConfig& config, const std::vector<Band>& bands,
                            double turn_rad_s) {
    constexpr double Allowed = 0.9; // of the base speed: the rest is for what the rotor adds of its own
    double unit_rad_s = 0.0;
    for (const Band& band : bands) {
        unit_rad_s = std::max(unit_rad_s, band.reach.referenceSpeed_rad_s);
    }
    const double speed_rad_s = std::abs(turn_rad_s);
    const double swing_rad_s = config.amplitude_rad.value_or(0.0) * unit_rad_s;
    if (swing_rad_s <= Allowed * speed_rad_s) {
        return {};
    }
    return failure(
        ErrorCode::OutOfRange,
        fmt::format("an amplitude of {:.3g} deg changes the reference speed by {:.3g} rad/s at a base speed "
                    "of {:.3g} rad/s: the speed would change its sign",
                    radiansToDegrees(*config.amplitude_rad), swing_rad_s, speed_rad_s),
        fmt::format(
            "use at most {:.3g} deg, a higher base speed or fewer high frequencies, or omit the amplitude",
            radiansToDegrees(Allowed * speed_rad_s / unit_rad_s)));
}

double amplitudeOf_rad(const FrequencyConfig& config, const Reach& reach, const FrequencyMargins& margins,
                       double turn_rad_s) {
    if (config.amplitude_rad) {
        return *config.amplitude_rad;
    }
    constexpr double LeastRoom_A = 0.3;
    const double speed_rad_s = std::abs(turn_rad_s);
    const double room_A = std::max(margins.law.limit_A - baseCurrent_A(margins, turn_rad_s), LeastRoom_A);
    return std::min({LargestAmplitude_rad, ReferenceShare * speed_rad_s / reach.referenceSpeed_rad_s,
                     RotorShare * speed_rad_s / reach.rotorSpeed_rad_s,
                     CurrentShare * room_A / reach.current_A});
}

FrequencyStage stageOf(const std::vector<int>& lines, double period_s, double amplitude_rad,
                       double turn_rad_s) {
    FrequencyStage stage;
    stage.lines = lines;
    stage.reference.amplitude = amplitude_rad;
    stage.reference.base = turn_rad_s;
    stage.reference.frequency_Hz = lines.front() / period_s;
    stage.to_Hz = lines.back() / period_s;
    stage.reference.frequencyEnd_Hz = stage.to_Hz;
    stage.reference.count = static_cast<int>(lines.size());
    stage.reference.shape = lines.size() > 1 ? MoveReference::Shape::Multisine : MoveReference::Shape::Sine;
    return stage;
}

/// How long a period of the excitation lasts, in rows.
struct Rows {
    std::size_t quarter = 0; ///< of a period: what a stepped sine needs
    std::size_t period = 0;
    double period_s = 0.0;
    double rest_s = 0.0; ///< between the sweeps of a chirp

    double repeated_s() const { return period_s + rest_s; }
};

Rows rowsOf(const FrequencyConfig& config, const FrequencyMargins& margins) {
    constexpr double ShortestSweep_s = 8.0; // the slack is then a quarter of it
    const bool isSwept = config.excitation == Excitation::Chirp;
    const double wanted_s = std::max(PeriodsOfLowest / config.from_Hz, isSwept ? ShortestSweep_s : 0.0);
    Rows rows;
    rows.quarter = static_cast<std::size_t>(std::ceil(wanted_s / (margins.period_s * SegmentsOfPeriod)));
    rows.period = SegmentsOfPeriod * rows.quarter;
    rows.period_s = margins.period_s * static_cast<double>(rows.period);
    rows.rest_s = isSwept ? restOf_s(margins) : 0.0;
    return rows;
}

std::vector<Band> bandsOf(const FrequencyConfig& config, const Rows& rows, const FrequencyMargins& margins) {
    const int from = std::max(1, static_cast<int>(std::lround(config.from_Hz * rows.period_s)));
    const int to = static_cast<int>(std::lround(config.to_Hz * rows.period_s));
    std::vector<Band> bands;
    for (std::vector<int>& lines : config.excitation == Excitation::SteppedSine
                                       ? steppedLines(from, to, SegmentsOfPeriod)
                                       : multisineLines(from, to)) {
        const bool isSwept = config.excitation == Excitation::Chirp;
        const Reach reach =
            isSwept ? sweptReach(lines, rows.period_s, margins) : reachOf(lines, rows.period_s, margins);
        bands.push_back({std::move(lines), reach});
    }
    return bands;
}

/// How the stage is run: at once and periodically, line by line, or swept again and again.
void schedule(FrequencyStage& stage, const FrequencyConfig& config, const Rows& rows, double period_s) {
    if (config.excitation == Excitation::Chirp) {
        constexpr double Spare_s = 0.1; // rows come in blocks: a sweep ends before the next begins
        stage.reference.shape = MoveReference::Shape::Chirp;
        stage.reference.frequencyEnd_Hz = sweptEnd_Hz(stage.lines, rows.period_s);
        stage.sweeps = config.periods;
        stage.sweep_s = rows.period_s;
        stage.rest_s = rows.rest_s;
        stage.rowsPerPeriod = static_cast<std::size_t>((rows.repeated_s() - Spare_s) / period_s);
        stage.measured_s = config.periods * rows.repeated_s();
        return;
    }
    const bool isStepped = config.excitation == Excitation::SteppedSine;
    stage.rowsPerPeriod = isStepped ? rows.quarter : rows.period;
    if (isStepped) {
        stage.lines.front() /= SegmentsOfPeriod;
    }
    const double once_s = period_s * static_cast<double>(stage.rowsPerPeriod);
    stage.measured_s = config.periods * once_s;
    stage.settle_s = std::max(2.0, once_s);
}

} // namespace

double FrequencyPlan::duration_s() const {
    return std::accumulate(
        stages.begin(), stages.end(), runUp_s,
        [](double sum, const FrequencyStage& stage) { return sum + stage.settle_s + stage.measured_s; });
}

Result<FrequencyPlan> planFrequency(const FrequencyConfig& config, const FrequencyMargins& margins) {
    if (auto valid = checkConfig(config, margins.period_s); !valid) {
        return failure(valid.error());
    }
    const Rows rows = rowsOf(config, margins);
    const auto turn_rad_s =
        spreadSpeed_rad_s(config.base_rad_s, rows.repeated_s(), fastestBase_rad_s(config));
    if (!turn_rad_s) {
        return failure(turn_rad_s.error());
    }
    FrequencyPlan plan;
    plan.turn_rad_s = *turn_rad_s;
    plan.runUp_s = RunUp_s;
    const std::vector<Band> bands = bandsOf(config, rows, margins);
    if (auto valid = checkAmplitude(config, bands, plan.turn_rad_s); !valid) {
        return failure(valid.error());
    }
    double swing_A = 0.0;
    for (const Band& band : bands) {
        const double amplitude_rad = amplitudeOf_rad(config, band.reach, margins, plan.turn_rad_s);
        FrequencyStage stage = stageOf(band.lines, rows.period_s, amplitude_rad, plan.turn_rad_s);
        schedule(stage, config, rows, margins.period_s);
        swing_A = std::max(swing_A, amplitude_rad * band.reach.current_A);
        plan.stages.push_back(std::move(stage));
    }
    const double base_A = baseCurrent_A(margins, plan.turn_rad_s);
    plan.peakCurrent_A = std::min(base_A + swing_A, margins.law.limit_A);
    // Half of the squared peak is the mean square of a sine; a multisine's is less.
    const double meanSquare_A2 =
        std::min(base_A * base_A + 0.5 * swing_A * swing_A, margins.law.limit_A * margins.law.limit_A);
    plan.meanSquare_A2 = 0.5 * meanSquare_A2; // each phase of a turning rotor has half of it
    return plan;
}

} // namespace halbench::app
