#pragma once

#include "app/procedures/move_reference.h"
#include "app/procedures/procedure.h"

#include <optional>
#include <vector>

namespace halbench::app {

struct MoveConfig {
    MoveReference reference;
    double duration_s = 3.0;
    /// Part of the run in which errors count; default: the second half. A staircase counts the last tenth of
    /// each step instead.
    std::optional<double> evaluateFrom_s;
    std::optional<double> evaluateTo_s;
    double speedLimit_rad_s = 40.0;
    double pauseTemperature_degC = 65.0;
    double refuseTemperature_degC = 70.0;
};

/// Figures of one response against its reference; error = reference - position, both from the start.
/// Step figures as in control/analysis/step_metrics.h, on samples 1 ms apart.
struct MoveFigures {
    std::optional<double> riseTime_s;
    std::optional<double> overshoot_percent;
    std::optional<double> peakTime_s;
    std::optional<double> settlingTime_s;
    double finalError_rad = 0.0;
    double maxError_rad = 0.0;         ///< in the evaluated part
    double rmsError_rad = 0.0;         ///< in the evaluated part
    double meanError_rad = 0.0;        ///< in the evaluated part
    double peakError_rad = 0.0;        ///< of the whole run
    double firstSecondError_rad = 0.0; ///< largest in the first second
    std::optional<double>
        gain_ratio; ///< sine: fundamental of position over reference, whole periods of the evaluated part
    std::optional<double> phase_deg;
};

struct MoveResult {
    MoveFigures measured;
    std::optional<MoveFigures> truth; ///< on a device that knows the true position
    Recording recording;              ///< 1 kHz from the start of the reference; time from 0
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
    DataQuality quality;

    /// Truth where known, else measured: what checks and reports mean.
    const MoveFigures& figures() const { return truth ? *truth : measured; }
};

/// What a move does to the coils, before anything is armed (also for `run --dry-run`): the position loop may
/// hold the full current in one phase for the whole time only if the prediction of the ideal loop says so.
struct MovePrediction {
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
};

/// Arms in mode position, lets the board follow the reference, disarms, measures. Works inside the excursion,
/// speed and temperature windows of the board; parameters are restored on every way out. Walks Prepare,
/// Excite, Record, Judge, Done. Errors: of the configuration, of the device, SafetyStop (a limit of the
/// board), Refused (too hot to start), of the abort.
Result<MoveResult> runMove(devices::Device& device, const MoveConfig& config,
                           const ProcedureObserver& observer);

/// Figures of a recording with columns reference, position and perhaps truth.position; a pure function.
/// Errors: InvalidInput (columns missing, too short).
Result<MoveFigures> measureMove(const Recording& recording, const std::string& positionColumn,
                                const MoveConfig& config);

} // namespace halbench::app
