#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/tune/analyse.h"
#include "control/identify/joint_estimate.h"
#include "control/identify/relay_estimate.h"
#include "devices/device.h"

#include <optional>
#include <utility>

namespace halbench::app {

/// The relay experiment (Astrom, Hagglund, Automatica 20 (1984) 645). Help: resources/help/htm-theory.md 7.7.
struct RelayConfig {
    std::optional<MotorEstimate> motor;   ///< for the plan and to compare; absent: the published motor
    std::optional<double> base_rad_s;     ///< of the motion that it swings around; absent: planned, forward
    std::optional<double> limit_A;        ///< height of the relay; absent: planned
    std::optional<double> gain_A_per_rad; ///< of the relay where it does not saturate; absent: planned
    int cycles = 100;                     ///< that are measured, 40 to 400
    double speedLimit_rad_s = 40.0;
    double pauseTemperature_degC = 65.0;
    double refuseTemperature_degC = 70.0;
    /// Lag of the currents behind their command, first order (htm-theory.md 3.2).
    double actuatorLag_s = 0.3e-3;
    /// 95 % of what scales current and torque constant and no response can show: converter, magnets.
    double gainError_ratio = 0.005;
};

/// Cycle and limit of proportional control as a motor's model predicts them.
struct RelayPrediction {
    control::UltimateGain at;
    std::optional<std::pair<double, double>> gain95; ///< of the model's covariance; absent: it has none
    bool isOfThisMotor = false;                      ///< an identified model; otherwise the published motor
    double period_s = 0.0;                           ///< of the cycle
    double amplitude_rad = 0.0;
    double lowest_rad_s = 0.0; ///< speeds while it swings, magnitudes
    double highest_rad_s = 0.0;
    double peak_rad_s = 0.0; ///< with the run-up
};

/// What the experiment will do: all of it is known before anything moves.
struct RelayPlan {
    double turn_rad_s = 0.0;  ///< mean speed, signed
    double weave_ratio = 0.0; ///< the base motion's speed goes up and down by this, slowly
    double weave_Hz = 0.0;
    double gain_A_per_rad = 0.0;
    double limit_A = 0.0;
    double runUp_s = 0.0;
    double measured_s = 0.0;
    double meanSquare_A2 = 0.0; ///< of one phase, expected
    RelayPrediction predicted;

    double duration_s() const { return runUp_s + measured_s; }
    double travel_rad() const { return turn_rad_s * duration_s(); }
};

enum class RelayAgreement { Unknown, Agrees, Disagrees }; ///< Unknown: the model has no interval

struct RelayResult {
    RelayConfig config;
    RelayPlan plan;
    double period_s = 0.01; ///< of the position loop
    int delaySamples = 0;
    control::LimitCyclePoint cycle;
    std::optional<control::UltimateEstimate> ultimate; ///< absent: refused, a finding says why
    RelayAgreement agreement = RelayAgreement::Unknown;
    DataQuality quality;
    double duration_s = 0.0;
    std::optional<double> highestTemperature_degC; ///< of the coils, where the board reports it
    double lowestSpeed_rad_s = 0.0;                ///< magnitudes, while measured
    double highestSpeed_rad_s = 0.0;
    Recording recording; ///< all of it, once each position sample
};

/// The plan for this device as it is. Errors: as of runRelay, before anything is written.
Result<RelayPlan> planRelayOn(devices::Device& device, const RelayConfig& config);

/// Turns the motor in mode position with proportional control that saturates at the relay's height, so that
/// the loop swings by itself around a steady motion, and takes ultimate gain and period from the fundamental
/// of command and angle. Gains, limits and everything else are restored, and the motor disarmed, on every way
/// out. Walks Prepare, Excite, Record, Fit, Judge, Done or Restored.
/// Errors: NotFinite, OutOfRange (of the configuration), Refused (heat; a motor that cannot swing safely;
/// the speed left what was foreseen; it did not swing; rows were lost), of the device, of the abort.
Result<RelayResult> runRelay(devices::Device& device, const RelayConfig& config,
                             const ProcedureObserver& observer);

/// As an estimate for tables: K_u in A/rad, T_u in s; not identifiable when refused.
control::Estimate ultimateGainOf(const RelayResult& result);
control::Estimate ultimatePeriodOf(const RelayResult& result);

} // namespace halbench::app
