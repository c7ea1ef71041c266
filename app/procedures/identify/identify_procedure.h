#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/tune/analyse.h"
#include "control/identify/joint_estimate.h"
#include "devices/device.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

enum class SweepDirections { Both, Forward, Reverse };

/// Current plateaus of the sweep, ends included.
struct CurrentSweep {
    double from_A = 1.6;
    double to_A = 4.0;
    double step_A = 0.2;
};

/// This run turns the rotor with a known inertia fixed to it; the bare motor was identified before.
struct AddedInertia {
    MotorEstimate bare; ///< needs phi_over_J
    double inertia_kg_m2 = 0.0;
};

struct IdentifyConfig {
    CurrentSweep sweep;
    SweepDirections directions = SweepDirections::Both;
    control::GivenConstants given;
    std::string axis;                      ///< of a device with several; empty or "all": every one
    std::vector<ParameterValue> constants; ///< given ones of a device with several axes, by symbol
    /// Limit of the gain error of the drive: the current that flows over the commanded one, where it is known
    /// or doubted. Without it the published drive's, 0.15 % at one sigma.
    std::optional<double> currentTolerance_percent;
    std::optional<AddedInertia> added;
    std::uint64_t seed = 1;         ///< order of the plateaus and bootstrap
    double speedLimit_rad_s = 40.0; ///< the board's speed window while this procedure runs
    double usableSpeed_rad_s = 3.0; ///< plateaus slower than this are shown, not fitted
    int coastDownsPerDirection = 8; ///< run-up and coast-down pairs besides the sweep
    /// Delay of the phase currents behind the angle: half a tick of 1 ms and 0.3 ms of the amplifier. The fit
    /// takes the torque that it costs into account; the board does not commutate ahead meanwhile.
    double commutationLag_s = 0.8e-3;
    double pauseTemperature_degC = 65; ///< waits above it
    double refuseTemperature_degC = 70;
    /// That the board of a recording can have commanded, where it is known.
    std::optional<double> recordedLimit_A;
};

/// Sets one given constant by its symbol J, c, Kf or phi (SI). Errors: UnknownName, NotFinite, OutOfRange
/// (J and phi must be positive, c and Kf not negative).
Result<void> setGivenConstant(control::GivenConstants& given, std::string_view symbol, double value);

inline constexpr double LargestCurrentTolerance_percent = 50.0;

/// Errors: NotFinite, OutOfRange (0 to LargestCurrentTolerance_percent).
Result<void> setCurrentTolerance(IdentifyConfig& config, double tolerance_percent);

/// The currents of one direction. Errors: NotFinite, OutOfRange (not 0 < from <= to, step <= 0, more than 32
/// plateaus, beyond `limit_A`).
Result<std::vector<double>> sweepCurrents_A(const CurrentSweep& sweep, double limit_A);

/// One plateau of the sweep as it was measured.
struct SweepPoint {
    double current_A = 0.0;   ///< signed amplitude
    double speed_rad_s = 0.0; ///< signed
    bool isUsed = false;
    double weight = 0.0; ///< of the robust regression, 1 = full
    std::string note;    ///< why it is not used, or how
};

/// Everything that `halbench.identification/1` holds. Keys of `ratios`: c_over_J, Kf_over_J, phi_over_J,
/// c_over_phi, Kf_over_phi. A quantity that is not identifiable has no value.
struct IdentifyResult {
    control::Estimate inertia;
    control::Estimate viscousDamping;
    control::Estimate coulombFriction;
    control::Estimate torqueConstant;
    std::map<std::string, control::Estimate> ratios;
    std::optional<control::Estimate> asymmetry;
    std::optional<double> rSquared;
    std::optional<double> residualRms_rad_s;
    std::vector<SweepPoint> points;
    std::vector<std::string> covarianceNames; ///< parameters with a value and an error, else ratios
    std::vector<std::vector<double>> covariance;
    DataQuality quality;
    double duration_s = 0.0;                       ///< device time that the excitation took
    std::optional<double> highestTemperature_degC; ///< of the coils, where it was recorded
    MeasuredTiming timing = {};                    ///< of the board; of a file what is recorded with it
    Recording recording;                           ///< all of the excitation at 100 Hz; empty for a file
    std::map<std::string, double> notes;           ///< further diagnostics, e.g. "friction_scatter_ratio"
};

/// Forecast of the sweep: duration, current and coil temperature, before anything is armed (also for `run
/// --dry-run`).
struct IdentifyPrediction {
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double highestTemperature_degC = 0.0;
};
IdentifyPrediction predictIdentify(const IdentifyConfig& config, double start_degC);

/// Spins the motor through run-ups, coast-downs and steady plateaus and estimates c, K_f, phi (and J) with
/// 95 % intervals. Restores the board's parameters and disarms on every way out. An estimate that the data do
/// not support comes back as a result with verdict Refused and its cause; errors are those of the device,
/// of the configuration and of the abort.
Result<IdentifyResult> runIdentify(devices::Device& device, const IdentifyConfig& config,
                                   const ProcedureObserver& observer);

/// The same estimate from a recording: columns position (rad), current_command (A) and, when there,
/// reference.segment. Finds the plateaus itself. A long recording takes a while: `checkAbort` is asked
/// between plateaus and between the steps of the fit. Errors: InvalidInput (columns missing, rate below 100
/// Hz), that of `checkAbort`.
Result<IdentifyResult> identifyRecording(const Recording& recording, const IdentifyConfig& config,
                                         const AbortCheck& checkAbort = {});

/// For tuning and analysis.
MotorEstimate motorEstimate(const IdentifyResult& result);

} // namespace halbench::app
