#include "control/identify/relay_estimate.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t CyclesOfBlock = 2;
constexpr std::size_t FewestCycles = 16;
constexpr int Harmonics = 5;
constexpr double Alpha = 0.05;

Result<void> check(const CycleRows& rows) {
    if (rows.reference.size() != rows.input.size() || rows.reference.size() != rows.output.size() ||
        !(rows.period_s > 0.0)) {
        return failure(ErrorCode::InvalidInput,
                       "the rows of the oscillation are not three signals of equal length");
    }
    for (const auto& signal : {rows.reference, rows.input, rows.output}) {
        if (!std::all_of(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); })) {
            return failure(ErrorCode::NotFinite, "a row of the cycle contains a value that is not a number",
                           "check the recording for gaps or faults");
        }
    }
    return {};
}

/// Places, in rows, where the swing passes its mean upward, having been well below.
std::vector<double> upwardPasses(const std::vector<double>& swing) {
    constexpr double Well_ratio = 0.15; // of the largest swing: noise does not pass twice
    const double mean = std::accumulate(swing.begin(), swing.end(), 0.0) /
                        static_cast<double>(std::max<std::size_t>(swing.size(), 1));
    double largest = 0.0;
    for (const double value : swing) {
        largest = std::max(largest, std::abs(value - mean));
    }
    std::vector<double> passes;
    bool wasBelow = false;
    for (std::size_t i = 0; i + 1 < swing.size(); ++i) {
        wasBelow = wasBelow || swing[i] < mean - Well_ratio * largest;
        if (wasBelow && swing[i] < mean && swing[i + 1] >= mean) {
            wasBelow = false;
            passes.push_back(static_cast<double>(i) + (mean - swing[i]) / (swing[i + 1] - swing[i]));
        }
    }
    return passes;
}

struct Block {
    double frequency_rad_s = 0.0;
    Complex U, Y;
};

/// Fundamental of whole cycles between two passes.
Block blockOf(const CycleRows& rows, const std::vector<double>& swing, double from, double to) {
    const double w = 2.0 * Pi * static_cast<double>(CyclesOfBlock) / ((to - from) * rows.period_s);
    const auto first = static_cast<std::size_t>(std::ceil(from));
    const auto count = static_cast<Eigen::Index>(static_cast<std::size_t>(std::floor(to)) + 1 - first);
    Eigen::MatrixXd basis(count, 2 + 2 * Harmonics);
    Eigen::MatrixXd signals(count, 2);
    basis.col(0).setOnes();
    basis.col(1) = Eigen::VectorXd::LinSpaced(count, -1.0, 1.0);
    for (Eigen::Index row = 0; row < count; ++row) {
        const std::size_t at = first + static_cast<std::size_t>(row);
        for (int n = 1; n <= Harmonics; ++n) {
            const double phase_rad = n * w * rows.period_s * static_cast<double>(row);
            basis(row, 2 * n) = std::cos(phase_rad);
            basis(row, 2 * n + 1) = std::sin(phase_rad);
        }
        signals(row, 0) = rows.input[at];
        signals(row, 1) = swing[at];
    }
    const Eigen::MatrixXd c = basis.householderQr().solve(signals);
    return {w, {c(2, 0), -c(3, 0)}, {c(2, 1), -c(3, 1)}};
}

/// The shape of a free inertia under held current.
Complex freeInertia(double frequency_rad_s, double period_s) {
    const Complex z = std::polar(1.0, frequency_rad_s * period_s);
    return (z + 1.0) / ((z - 1.0) * (z - 1.0));
}

double meanOutput(std::span<const Block> blocks) {
    const double sum = std::accumulate(blocks.begin(), blocks.end(), 0.0,
                                       [](double s, const Block& block) { return s + std::abs(block.Y); });
    return sum / static_cast<double>(blocks.size());
}

void takeFrequency(LimitCyclePoint& point, std::span<const Block> blocks) {
    double power = 0.0;
    double weighted = 0.0;
    for (const Block& block : blocks) {
        power += std::norm(block.U);
        weighted += std::norm(block.U) * block.frequency_rad_s;
    }
    point.frequency_rad_s = weighted / power;
    double squares = 0.0;
    for (const Block& block : blocks) {
        squares += std::pow(block.frequency_rad_s / point.frequency_rad_s - 1.0, 2);
    }
    point.frequencyScatter_ratio = std::sqrt(squares / static_cast<double>(blocks.size()));
    point.input = std::sqrt(power / static_cast<double>(blocks.size()));
}

/// How far from -180 degrees, positive above.
double lead_rad(Complex value) {
    return std::arg(-value);
}

/// The damping with which a rotor has this phase; its phase rises with it.
Result<SampledPlantModel> rotorThrough(Complex plant, double frequency_rad_s, const CycleLoop& loop) {
    SampledPlantModel rotor;
    rotor.lag_s = loop.lag_s;
    rotor.accelerationGain_rad_s2_A = 1.0;
    const auto leadOf = [&](double damping_1_s) {
        rotor.dampingRate_1_s = damping_1_s;
        return lead_rad(sampledPlantResponse(rotor, loop.period_s, frequency_rad_s));
    };
    double low = -0.5 * frequency_rad_s;
    double high = 2.0 * frequency_rad_s;
    const double wanted_rad = lead_rad(plant);
    if (leadOf(low) > wanted_rad || leadOf(high) < wanted_rad) {
        return failure(ErrorCode::Refused, "the oscillation does not match a rotor",
                       "check the recording for an angle error or a resonance");
    }
    constexpr int Halvings = 50;
    for (int i = 0; i < Halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (leadOf(middle) < wanted_rad ? low : high) = middle;
    }
    (void)leadOf(0.5 * (low + high));
    rotor.accelerationGain_rad_s2_A =
        std::abs(plant) / std::abs(sampledPlantResponse(rotor, loop.period_s, frequency_rad_s));
    return rotor;
}

void widen(std::pair<double, double>& interval, double value) {
    interval = {std::min(interval.first, value), std::max(interval.second, value)};
}

} // namespace

Result<LimitCyclePoint> estimateLimitCycle(const CycleRows& rows) {
    if (auto checked = check(rows); !checked) {
        return failure(checked.error());
    }
    std::vector<double> swing(rows.output.size());
    std::transform(rows.output.begin(), rows.output.end(), rows.reference.begin(), swing.begin(),
                   std::minus<>());
    const std::vector<double> passes = upwardPasses(swing);
    if (passes.size() <= FewestCycles) {
        return failure(ErrorCode::Refused,
                       fmt::format("only {} cycles in the recording: no limit cycle",
                                   passes.empty() ? 0 : passes.size() - 1),
                       "use a larger relay gain, or the model of this motor");
    }
    std::vector<Block> blocks;
    for (std::size_t i = 0; i + CyclesOfBlock < passes.size(); i += CyclesOfBlock) {
        blocks.push_back(blockOf(rows, swing, passes[i], passes[i + CyclesOfBlock]));
    }
    LimitCyclePoint point;
    point.blocks = static_cast<int>(blocks.size());
    point.cycles = point.blocks * static_cast<int>(CyclesOfBlock);
    takeFrequency(point, blocks);
    point.amplitude = meanOutput(blocks);
    const std::size_t third = blocks.size() / 3;
    point.growth_ratio =
        meanOutput(std::span(blocks).last(third)) / meanOutput(std::span(blocks).first(third));
    const Complex shape = freeInertia(point.frequency_rad_s, rows.period_s);
    Complex Syu = 0.0;
    double Suu = 0.0;
    for (Block& block : blocks) {
        block.Y *= shape / freeInertia(block.frequency_rad_s, rows.period_s);
        Syu += block.Y * std::conj(block.U);
        Suu += std::norm(block.U);
    }
    point.plant = Syu / Suu;
    double residual = 0.0;
    for (const Block& block : blocks) {
        residual += std::norm(block.Y - point.plant * block.U);
    }
    const double freedom = static_cast<double>(point.blocks - 1);
    point.radius = std::sqrt(residual / freedom / Suu * fisherQuantileOfTwo(Alpha, 2.0 * freedom));
    return point;
}

Result<UltimateGain> ultimateGain(const SampledPlantModel& rotor, double period_s, int delay_samples) {
    const auto lateBy = [&](double w) { return std::polar(1.0, -w * period_s * delay_samples); };
    const auto leadAt = [&](double w) {
        return lead_rad(sampledPlantResponse(rotor, period_s, w) * lateBy(w));
    };
    double high = 0.9 * Pi / (period_s * (1.0 + 2.0 * delay_samples)); // below it no phase wraps
    double low = 1e-4 * high;
    if (!(leadAt(low) > 0.0) || !(leadAt(high) < 0.0)) {
        return failure(ErrorCode::Refused,
                       "this motor has no damping: proportional control oscillates at any gain",
                       "no ultimate gain exists; use a method with derivative action");
    }
    constexpr int Halvings = 50;
    for (int i = 0; i < Halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (leadAt(middle) > 0.0 ? low : high) = middle;
    }
    const double w = 0.5 * (low + high);
    return UltimateGain{1.0 / std::abs(sampledPlantResponse(rotor, period_s, w)), w};
}

Result<UltimateEstimate> ultimateOfCycle(const LimitCyclePoint& cycle, const CycleLoop& loop) {
    const double w = cycle.frequency_rad_s;
    const Complex late = std::polar(1.0, -w * loop.period_s * loop.delay_samples);
    UltimateEstimate result;
    const double lead_deg = radiansToDegrees(lead_rad(cycle.plant * late));
    result.phase_deg = -180.0 + lead_deg;
    if (!(std::abs(lead_deg) <= loop.mostPhase_deg)) {
        return failure(ErrorCode::Refused,
                       fmt::format("phase at the oscillation frequency {:.4g} deg, too far from -180 deg",
                                   result.phase_deg),
                       fmt::format("allowed: {:.3g} deg; check for an unreported delay or a resonance",
                                   loop.mostPhase_deg));
    }
    const double half_deg = radiansToDegrees(std::asin(std::min(cycle.radius / std::abs(cycle.plant), 1.0)));
    result.phase95_deg = {result.phase_deg - half_deg, result.phase_deg + half_deg};
    const auto through = [&](Complex plant) -> Result<UltimateGain> {
        const auto rotor = rotorThrough(plant, w, loop);
        if (!rotor) {
            return failure(rotor.error());
        }
        if (!(rotor->dampingRate_1_s > 0.0)) {
            return failure(ErrorCode::Refused,
                           "negative damping from the oscillation, not possible for a motor",
                           "calibrate the sensors; check for an unreported delay");
        }
        result.rotor = *rotor;
        return ultimateGain(*rotor, loop.period_s, loop.delay_samples);
    };
    constexpr int Around = 16;
    for (int i = 0; i <= Around; ++i) { // the middle last: its rotor is kept
        const Complex offset = i == Around ? Complex(0.0) : std::polar(cycle.radius, 2.0 * Pi * i / Around);
        const auto at = through(cycle.plant + offset);
        if (!at) {
            return failure(at.error());
        }
        if (i == 0) {
            result.gain95 = {at->gain, at->gain};
            result.period95_s = {2.0 * Pi / at->frequency_rad_s, 2.0 * Pi / at->frequency_rad_s};
        }
        widen(result.gain95, at->gain);
        widen(result.period95_s, 2.0 * Pi / at->frequency_rad_s);
        result.at = *at;
    }
    result.gain95.first *= 1.0 - loop.gainError_ratio;
    result.gain95.second *= 1.0 + loop.gainError_ratio;
    return result;
}

} // namespace halbench::control
