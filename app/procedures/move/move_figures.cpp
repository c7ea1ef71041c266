#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/move_procedure.h"
#include "control/analysis/step_metrics.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace halbench::app {
namespace {

struct Part {
    double from_s;
    double to_s;
    bool holds(double time_s) const { return time_s >= from_s - 1e-9 && time_s <= to_s + 1e-9; }
};

constexpr double Plateau_s = 0.5;

Part evaluatedPart(const MoveConfig& config) {
    if (const auto travel_s = travelTime_s(config.reference)) {
        return {config.evaluateFrom_s.value_or(0.0), config.evaluateTo_s.value_or(*travel_s)};
    }
    return {config.evaluateFrom_s.value_or(0.5 * config.duration_s),
            config.evaluateTo_s.value_or(config.duration_s)};
}

// The last tenth of each step of a staircase: where it should have settled.
bool isSettledTime(const MoveReference& reference, double time_s) {
    const double phase = time_s / reference.period_s;
    const bool isRunning = phase < reference.count;
    return !isRunning || phase - std::floor(phase + 1e-9) >= 0.9 - 1e-9;
}

bool counts(const MoveConfig& config, const Part& part, double time_s) {
    if (config.reference.shape == MoveReference::Shape::Staircase && !config.evaluateFrom_s) {
        return isSettledTime(config.reference, time_s);
    }
    return part.holds(time_s);
}

void measureErrors(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    const Part part = evaluatedPart(config);
    double square = 0.0;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        const double error = response.reference[i] - response.position[i];
        figures.peakError = std::max(figures.peakError, std::fabs(error));
        if (response.time_s[i] < 1.0) {
            figures.firstSecondError = std::max(figures.firstSecondError, std::fabs(error));
        }
        if (counts(config, part, response.time_s[i])) {
            figures.maxError = std::max(figures.maxError, std::fabs(error));
            square += error * error;
            sum += error;
            ++count;
        }
    }
    if (count > 0) {
        figures.rmsError = std::sqrt(square / static_cast<double>(count));
        figures.meanError = sum / static_cast<double>(count);
    }
    figures.finalError = response.reference.back() - response.position.back();
}

void measureTravel(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    const Part part = evaluatedPart(config);
    std::optional<std::pair<double, double>> ends;
    for (std::size_t i = 0; i < response.time_s.size(); ++i) {
        if (part.holds(response.time_s[i])) {
            const double position = response.position[i];
            const auto [low, high] = ends.value_or(std::pair(position, position));
            ends = {std::min(low, position), std::max(high, position)};
        }
    }
    figures.peakToPeak = ends ? ends->second - ends->first : 0.0;
}

void measureLock(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    if (!config.lockThreshold) {
        return;
    }
    double locked_s = response.time_s.front();
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        if (std::fabs(response.reference[i] - response.position[i]) > *config.lockThreshold) {
            const std::size_t next = i + response.rowsPerReference;
            locked_s = next < response.time_s.size() ? response.time_s[next] : 2.0 * response.time_s.back();
        }
    }
    const bool isSine = config.reference.shape == MoveReference::Shape::Sine;
    const double proof_s = isSine ? 0.5 / config.reference.frequency_Hz : 0.0;
    if (locked_s + proof_s <= response.time_s.back() + 1e-9) {
        figures.lockTime_s = locked_s;
    }
}

// First Fourier coefficient over the last whole periods of the evaluated part.
void measureSine(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    const double frequency_Hz = config.reference.frequency_Hz;
    const Part part = evaluatedPart(config);
    const double periods = std::floor((part.to_s - part.from_s) * frequency_Hz + 1e-9);
    if (periods < 1.0) {
        return;
    }
    const double from_s = part.to_s - periods / frequency_Hz;
    std::complex<double> in;
    std::complex<double> out;
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        const double time_s = response.time_s[i];
        if (time_s >= from_s - 1e-9 && time_s < part.to_s - 1e-9) {
            const std::complex<double> carrier = std::polar(1.0, -2.0 * Pi * frequency_Hz * time_s);
            in += carrier * response.reference[i];
            out += carrier * response.position[i];
        }
    }
    figures.gain_ratio = std::abs(out / in);
    figures.phase_deg = radiansToDegrees(std::arg(out / in));
}

Result<void> measureStepFigures(const MoveResponse& response, const MoveConfig& config,
                                MoveFigures& figures) {
    const auto metrics =
        control::measureStep(response.time_s, response.position, 0.0, config.reference.amplitude);
    if (!metrics) {
        return failure(metrics.error());
    }
    figures.riseTime_s = metrics->riseTime_s;
    figures.overshoot_percent = metrics->overshoot_percent;
    figures.peakTime_s = metrics->peakTime_s;
    figures.settlingTime_s = metrics->settlingTime_s;
    return {};
}

/// The time from which the reference rests for good; nothing of one that goes on.
std::optional<double> restFrom_s(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    if (reference.base != 0.0) {
        return std::nullopt;
    }
    switch (reference.shape) {
    case Shape::Step:
    case Shape::Rest:
        return 0.0;
    case Shape::Staircase:
        return reference.period_s * (reference.count - 1);
    case Shape::Ramp:
        return reference.amplitude == 0.0 ? std::nullopt
                                          : std::optional(std::fabs(reference.amplitude / reference.rate));
    default:
        return travelTime_s(reference);
    }
}

void measureWindow(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    constexpr double Proof_s = 0.1;
    const auto rest_s = restFrom_s(config.reference);
    if (!config.settlingWindow || !rest_s || *rest_s > response.time_s.back()) {
        return;
    }
    const double end = response.reference.back();
    double inside_s = response.time_s.back();
    for (std::size_t i = response.time_s.size(); i-- > 0;) {
        if (std::fabs(end - response.position[i]) > *config.settlingWindow) {
            break;
        }
        inside_s = response.time_s[i];
    }
    if (inside_s + Proof_s <= response.time_s.back() + 1e-9) {
        figures.windowTime_s = inside_s;
    }
}

struct Moments {
    double mean;
    double deviation;
};

std::optional<Moments> momentsOf(const MoveResponse& response, const Part& part) {
    double sum = 0.0;
    double count = 0.0;
    const auto overPart = [&](const auto& add) {
        for (std::size_t i = 0; i < response.time_s.size(); ++i) {
            if (part.holds(response.time_s[i])) {
                add(response.position[i]);
            }
        }
    };
    overPart([&](double position) {
        sum += position;
        ++count;
    });
    if (count < 2.0) {
        return std::nullopt;
    }
    const double mean = sum / count;
    double square = 0.0;
    overPart([&](double position) { square += (position - mean) * (position - mean); });
    return Moments{mean, std::sqrt(square / count)};
}

void measureRest(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    const auto from_s = restFrom_s(config.reference);
    const double end_s = response.time_s.back();
    const double window_s = restWindow_s(config.reference, end_s);
    if (from_s && *from_s + window_s <= end_s + 1e-9) {
        const auto moments = momentsOf(response, {end_s - window_s, end_s});
        figures.restRms = moments ? std::optional(moments->deviation) : std::nullopt;
    }
}

/// The slope of a straight line through the positions.
void measureRampEnd(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    constexpr double Piece_s = 0.02;
    const auto profile = travelProfile(config.reference);
    if (!profile || profile->duration_s() - 2.0 * profile->ramp_s() < Piece_s) {
        return;
    }
    const Part part{profile->ramp_s(), profile->ramp_s() + Piece_s};
    const double middle_s = 0.5 * (part.from_s + part.to_s);
    double product = 0.0;
    double square = 0.0;
    double offset = 0.0;
    for (std::size_t i = 0; i < response.time_s.size(); ++i) {
        if (part.holds(response.time_s[i])) {
            const double time_s = response.time_s[i] - middle_s;
            product += time_s * response.position[i];
            square += time_s * time_s;
            offset += time_s;
        }
    }
    const auto moments = momentsOf(response, part);
    if (moments && square > 0.0) {
        figures.rampEndSpeed = (product - offset * moments->mean) / square;
    }
}

StairFigures stairOf(const MoveResponse& response, const MoveReference& reference, int stair) {
    const double height = reference.amplitude;
    const Part part{stair * reference.period_s, (stair + 1) * reference.period_s - 1e-6};
    std::vector<double> time_s;
    std::vector<double> position;
    for (std::size_t i = 0; i < response.time_s.size(); ++i) {
        if (part.holds(response.time_s[i])) {
            time_s.push_back(response.time_s[i] - part.from_s);
            position.push_back(response.position[i]);
        }
    }
    StairFigures figures;
    if (const auto metrics = control::measureStep(time_s, position, stair * height, (stair + 1) * height)) {
        figures.riseTime_s = metrics->riseTime_s;
        figures.settlingTime_s = metrics->settlingTime_s;
        figures.overshoot_percent = metrics->overshoot_percent;
    }
    const auto moments = momentsOf(response, {std::max(part.from_s, part.to_s - Plateau_s), part.to_s});
    figures.mean = moments ? moments->mean : 0.0;
    return figures;
}

/// Those that were seen to their end.
void measureStairs(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    const MoveReference& reference = config.reference;
    for (int stair = 0; stair < reference.count; ++stair) {
        if ((stair + 1) * reference.period_s > response.time_s.back() + 2e-3) {
            return;
        }
        figures.stairs.push_back(stairOf(response, reference, stair));
    }
}

bool isFinite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

} // namespace

Result<MoveFigures> measureMove(const MoveResponse& response, const MoveConfig& config) {
    const std::size_t rows = response.time_s.size();
    if (rows < 2 || response.rowsPerReference == 0 || response.reference.size() != rows ||
        response.position.size() != rows) {
        return failure(ErrorCode::InvalidInput, "the response has too few samples to evaluate",
                       "Record longer or at a higher rate.");
    }
    if (!isFinite(response.reference) || !isFinite(response.position)) {
        return failure(ErrorCode::NotFinite, "the response contains a value that is not a number",
                       "Repeat the move.");
    }
    MoveFigures figures;
    measureErrors(response, config, figures);
    measureTravel(response, config, figures);
    measureLock(response, config, figures);
    measureWindow(response, config, figures);
    if (config.reference.shape == MoveReference::Shape::Sine) {
        measureSine(response, config, figures);
    }
    measureRest(response, config, figures);
    if (config.reference.shape == MoveReference::Shape::Staircase) {
        measureStairs(response, config, figures);
    }
    if (isTravel(config.reference)) {
        measureRampEnd(response, config, figures);
    }
    if (config.reference.shape == MoveReference::Shape::Step || isTravel(config.reference)) {
        if (auto measured = measureStepFigures(response, config, figures); !measured) {
            return failure(measured.error());
        }
    }
    return figures;
}

} // namespace halbench::app
