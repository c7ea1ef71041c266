#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/excite/move_reference.h"

#include <optional>
#include <vector>

namespace halbench::app {

struct MoveConfig {
    MoveReference reference;
    double duration_s = 3.0;
    /// Part of the run in which errors count; default: the second half, of travels and paths the way. A
    /// staircase counts the last tenth of each step instead.
    std::optional<double> evaluateFrom_s;
    std::optional<double> evaluateTo_s;
    /// Error below which the axis counts as locked to its reference; without one there is no lock time.
    std::optional<double> lockThreshold;
    /// Distance from the end of the reference within which the axis counts as settled; without one there is
    /// no window time.
    std::optional<double> settlingWindow = {};
    /// Of the window: axes in another unit have none. Empty: that of every axis that moves.
    std::string settlingUnit = {};
    /// Overshoot needs fine samples. A board that cannot send so many sends one each position loop.
    double rate_Hz = 1000.0;
    double speedLimit_rad_s = 40.0; ///< of an axis that turns forever; others keep the board's window
    double pauseTemperature_degC = 65.0;
    double refuseTemperature_degC = 70.0;
    std::string axis = {}; ///< which one moves; empty: the only one, of a path or table those that it has
};

/// One step of a staircase, measured like a step of its own.
struct StairFigures {
    std::optional<double> riseTime_s;
    std::optional<double> settlingTime_s;
    double overshoot_percent = 0.0;
    double mean = 0.0; ///< of the position in the last half second of the stair
};

/// One axis where a table of poses has a row.
struct RowFigures {
    std::size_t line = 0; ///< of the file
    double arrival_s = 0.0;
    double error = 0.0; ///< at the arrival
    /// From the arrival until the error stays within the settling window, or without one 2 % of the way to
    /// the row, until the axis leaves it or the run ends. Nothing where it does not, and where the row is
    /// passed without a rest.
    std::optional<double> settlingTime_s;
};

/// Figures of one response against its reference; error = reference - position, both from the start, in the
/// position unit of the axis.
/// Step figures as in control/analysis/step_metrics.h, on samples 1 ms apart.
struct MoveFigures {
    std::optional<double> riseTime_s;
    std::optional<double> overshoot_percent;
    std::optional<double> peakTime_s;
    std::optional<double> settlingTime_s;
    double finalError = 0.0;
    double maxError = 0.0;         ///< in the evaluated part
    double rmsError = 0.0;         ///< in the evaluated part
    double meanError = 0.0;        ///< in the evaluated part
    double peakToPeak = 0.0;       ///< of the position in the evaluated part: of a step, a limit cycle
    double peakError = 0.0;        ///< of the whole run
    double firstSecondError = 0.0; ///< largest in the first second
    std::optional<double>
        gain_ratio; ///< sine: fundamental of position over reference, whole periods of the evaluated part
    std::optional<double> phase_deg;
    /// From here to the end the error stays below MoveConfig::lockThreshold; absent when it does not. Of
    /// a sine, whose error has two peaks a period, at least half a period must follow.
    std::optional<double> lockTime_s;
    /// From here to the end, for a tenth of a second at least, the position stays within
    /// MoveConfig::settlingWindow of the end of the reference; absent when it does not, and of a reference
    /// that does not rest at its end.
    std::optional<double> windowTime_s = {};
    /// Standard deviation of the position in the last half second (of Shape::Rest all the time), where the
    /// reference rests there; its mean is no noise.
    std::optional<double> restRms;
    /// Of a travel: the slope over the first 20 ms of its constant speed.
    std::optional<double> rampEndSpeed;
    std::vector<StairFigures> stairs = {};
    std::vector<RowFigures> rows = {}; ///< of a table
};

/// Distance from the nearest point of a path, from its start to its end.
struct ContourError {
    double rms = 0.0;
    double peak = 0.0;
};

/// An axis that was to stay where it was: how far it went, in its position unit.
struct CrossAxisPeak {
    devices::AxisSpec axis;
    double measured = 0.0;
    std::optional<double> truth;
    std::optional<double> measuredRestRms = {}; ///< as MoveFigures::restRms
    std::optional<double> trueRestRms = {};
};

/// A further axis of a path or table.
struct PartnerResult {
    devices::AxisSpec axis;
    MoveFigures measured;
    std::optional<MoveFigures> truth;
    std::optional<double> peakEffort;
};

/// How near two axes kept to their path in the plane.
struct ContourResult {
    std::string unit; ///< of both
    ContourError measured;
    std::optional<ContourError> truth;
};

struct MoveResult {
    MoveFigures measured;
    std::optional<MoveFigures> truth; ///< on a device that knows the true position
    Recording recording;              ///< from the start of the reference; time from 0
    /// Mean position of the axis while it was held, just before the reference began: one reading alone would
    /// shift the whole motion by its noise.
    double restPosition = 0.0;
    // Nothing where the board does not report it.
    std::optional<double> peakCurrent_A;
    std::optional<double> highestTemperature_degC; ///< of the coils, where the board reports it
    std::optional<double> lockThreshold;           ///< that both lock times are meant with
    DataQuality quality;
    devices::AxisSpec axis = {};               ///< that moved
    std::optional<double> peakEffort = {};     ///< of that axis, in its effort unit
    std::vector<CrossAxisPeak> others = {};    ///< empty on a device with one axis
    std::optional<double> travel_s = {};       ///< of a travel or path, known before it began
    std::vector<PartnerResult> partners = {};  ///< of a path or table: the other axes that moved
    std::optional<ContourResult> contour = {}; ///< likewise, where it moved in a plane

    /// The device has more axes than this one.
    bool isOneOfSeveral() const { return !others.empty() || !partners.empty(); }
    /// Truth where known, else measured: what checks and reports mean.
    const MoveFigures& figures() const { return truth ? *truth : measured; }
};

/// Load of the coils by a move, before anything is armed (also for `run --dry-run`).
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
    double excursion_rad = 0.0;          ///< that the reference asks for, from the start
    double window_rad = 0.0;             ///< from the start: there the board ends the motion
    double speedLimit_rad_s = 0.0;       ///< likewise
    double armed_s = 0.0;                ///< from arming to disarming
    std::optional<double> travel_s = {}; ///< of a travel or path, from its start to its end
};
MoveOutlook moveOutlook(const MoveConfig& config, const devices::Catalogue& catalogue);

/// Arms in mode position, lets the board follow the reference, disarms, measures. Works inside the excursion,
/// speed and temperature windows of the board; parameters are restored on every way out. Walks Prepare,
/// Excite, Record, Judge, Done or Restored. Errors: of the configuration, of the device, SafetyStop (a limit
/// of the board), Refused (too hot to start, no zero of the axes), of the abort. On a device with several
/// axes one moves and the others hold their position (resources/help/command-line.md, "Axes"); a board that
/// knows no zero yet is homed first. Errors there: Usage (which axis is not said), UnknownName, OutOfRange
/// (beyond the board's position window), InvalidInput (a shape that the board does not have, a time shorter
/// than the travel). A path moves the first two axes along a line and a table those of its columns, so no
/// axis is named.
Result<MoveResult> runMove(devices::Device& device, const MoveConfig& config,
                           const ProcedureObserver& observer);

/// The part of it that moves and judges, for a procedure that holds a RestoreGuard of its own: sets the
/// windows and the generator, arms, follows, disarms. What it set stays for the guard to undo. Tells the
/// observer Excite, Record, Judge. Errors: as runMove().
Result<MoveResult> performMove(devices::Device& device, const MoveConfig& config,
                               const ProcedureObserver& observer);

/// Reference and response of a run in the unit of the axis, both counted from where it was when the run
/// began; 1 ms apart.
struct MoveResponse {
    std::vector<double> time_s;
    std::vector<double> reference;
    std::vector<double> position;
    /// The board evaluates its reference once in this many rows and holds it in between; errors and the
    /// sine's response count on those rows only, or a ramp would seem to be missed by a whole period's
    /// travel.
    std::size_t rowsPerReference = 10;
};

/// Errors: InvalidInput (lengths, too short), NotFinite.
Result<MoveFigures> measureMove(const MoveResponse& response, const MoveConfig& config);

} // namespace halbench::app
