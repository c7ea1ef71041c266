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

Part evaluatedPart(const MoveConfig& config) {
    return {config.evaluateFrom_s.value_or(0.5 * config.duration_s),
            config.evaluateTo_s.value_or(config.duration_s)};
}

// The last tenth of each step of a staircase: where it should have settled.
bool isSettledTime(const MoveReference& reference, double time_s) {
    const double phase = time_s / reference.period_s;
    const bool isRunning = phase < reference.count;
    return !isRunning || phase - std::floor(phase + 1e-9) >= 0.9 - 1e-9;
}

bool counts(const MoveConfig& config, double time_s) {
    if (config.reference.shape == MoveReference::Shape::Staircase && !config.evaluateFrom_s) {
        return isSettledTime(config.reference, time_s);
    }
    return evaluatedPart(config).holds(time_s);
}

void measureErrors(const MoveResponse& response, const MoveConfig& config, MoveFigures& figures) {
    double square = 0.0;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < response.time_s.size(); i += response.rowsPerReference) {
        const double error = response.reference[i] - response.position[i];
        figures.peakError = std::max(figures.peakError, std::fabs(error));
        if (response.time_s[i] < 1.0) {
            figures.firstSecondError = std::max(figures.firstSecondError, std::fabs(error));
        }
        if (counts(config, response.time_s[i])) {
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
    std::optional<std::pair<double, double>> ends;
    for (std::size_t i = 0; i < response.time_s.size(); ++i) {
        if (evaluatedPart(config).holds(response.time_s[i])) {
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

bool isFinite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

} // namespace

Result<MoveFigures> measureMove(const MoveResponse& response, const MoveConfig& config) {
    const std::size_t rows = response.time_s.size();
    if (rows < 2 || response.rowsPerReference == 0 || response.reference.size() != rows ||
        response.position.size() != rows) {
        return failure(ErrorCode::InvalidInput, "the response has too few samples to be measured",
                       "Record longer or at a higher rate.");
    }
    if (!isFinite(response.reference) || !isFinite(response.position)) {
        return failure(ErrorCode::NotFinite, "the response holds a value that is not a number",
                       "Repeat the move.");
    }
    MoveFigures figures;
    measureErrors(response, config, figures);
    measureTravel(response, config, figures);
    measureLock(response, config, figures);
    if (config.reference.shape == MoveReference::Shape::Sine) {
        measureSine(response, config, figures);
    }
    if (config.reference.shape == MoveReference::Shape::Step) {
        if (auto measured = measureStepFigures(response, config, figures); !measured) {
            return failure(measured.error());
        }
    }
    return figures;
}

} // namespace halbench::app
