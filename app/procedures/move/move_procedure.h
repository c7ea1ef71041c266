#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/excite/move_reference.h"

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
    /// Error below which the rotor counts as locked to its reference; without one there is no lock time.
    std::optional<double> lockThreshold_rad;
    /// Overshoot needs fine samples. A board that cannot send so many sends one each position loop.
    double rate_Hz = 1000.0;
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
    double peakToPeak_rad = 0.0;       ///< of the position in the evaluated part: of a step, a limit cycle
    double peakError_rad = 0.0;        ///< of the whole run
    double firstSecondError_rad = 0.0; ///< largest in the first second
    std::optional<double>
        gain_ratio; ///< sine: fundamental of position over reference, whole periods of the evaluated part
    std::optional<double> phase_deg;
    /// From here to the end the error stays below MoveConfig::lockThreshold_rad; absent when it does not. Of
    /// a sine, whose error has two peaks a period, at least half a period must follow.
    std::optional<double> lockTime_s;
};

struct MoveResult {
    MoveFigures measured;
    std::optional<MoveFigures> truth; ///< on a device that knows the true position
    Recording recording;              ///< from the start of the reference; time from 0
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
    std::optional<double> lockThreshold_rad; ///< that both lock times are meant with
    DataQuality quality;

    /// Truth where known, else measured: what checks and reports mean.
    const MoveFigures& figures() const { return truth ? *truth : measured; }
};

/// What a move does to the coils, before anything is armed (also for `run --dry-run`).
struct MovePrediction {
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double meanSquare_A2 = 0.0; ///< of the amplitude, with a margin; all of it may flow in one phase
};

/// The ideal loop of a motor under this law, where the reference has an ideal form; else the current limit
/// for the whole time. `motor` need not be known exactly: a quarter is added to the current.
MovePrediction predictMove(const MoveConfig& config, const control::SampledPositionLaw& law,
                           const models::RotorConfig& motor, double torqueConstant_Nm_per_A);

/// How far and how long a move may go on this device: what performMove() sets, told before.
struct MoveOutlook {
    double excursion_rad = 0.0;    ///< that the reference asks for, from the start
    double window_rad = 0.0;       ///< from the start: there the board ends the motion
    double speedLimit_rad_s = 0.0; ///< likewise
    double armed_s = 0.0;          ///< from arming to disarming
};
MoveOutlook moveOutlook(const MoveConfig& config, const devices::Catalogue& catalogue);

/// Arms in mode position, lets the board follow the reference, disarms, measures. Works inside the excursion,
/// speed and temperature windows of the board; parameters are restored on every way out. Walks Prepare,
/// Excite, Record, Judge, Done or Restored. Errors: of the configuration, of the device, SafetyStop (a limit
/// of the board), Refused (too hot to start), of the abort.
Result<MoveResult> runMove(devices::Device& device, const MoveConfig& config,
                           const ProcedureObserver& observer);

/// The part of it that moves and judges, for a procedure that holds a RestoreGuard of its own: sets the
/// windows and the generator, arms, follows, disarms. What it set stays for the guard to undo. Tells the
/// observer Excite, Record, Judge. Errors: as runMove().
Result<MoveResult> performMove(devices::Device& device, const MoveConfig& config,
                               const ProcedureObserver& observer);

/// Reference and response of a run, both counted from where the rotor was when it began; 1 ms apart.
struct MoveResponse {
    std::vector<double> time_s;
    std::vector<double> reference_rad;
    std::vector<double> position_rad;
    /// The board evaluates its reference once in this many rows and holds it in between; errors and the
    /// sine's response count on those rows only, or a ramp would seem to be missed by a whole period's
    /// travel.
    std::size_t rowsPerReference = 10;
};

/// Errors: InvalidInput (lengths, too short), NotFinite.
Result<MoveFigures> measureMove(const MoveResponse& response, const MoveConfig& config);

} // namespace halbench::app
