#pragma once

#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/identify/identify_plan.h"

#include <optional>

namespace halbench::app {

/// First motion of a motor that is not known yet: short pulses first, twice as long each time, so that a
/// lively motor shows itself far below its speed window; then run-ups of a second under a current that suits
/// it. The owner runs a stream with position, speed, current_command and reference.segment meanwhile.
class PilotMotion {
public:
    PilotMotion(devices::Device& device, const ProcedureObserver& observer, const IdentifyConfig& config);

    /// The rows of that stream.
    void take(const SampleBlock& block);

    /// The motor to some per cent. One that turned but told too little is taken for the published one, or for
    /// what its pulses showed when it is livelier; nothing when it never turned. Currents: magnitudes in
    /// ascending order. Errors: of the device, of the abort, Refused (heat).
    Result<std::optional<PilotEstimate>> find(const std::vector<double>& currents_A);

    /// The motor by everything that was taken so far; nothing where that does not show it.
    std::optional<PilotEstimate> estimate() const;

private:
    Result<void> drive(PlateauRun run);
    Result<double> pulsedAcceleration_rad_s2(double current_A);
    Result<PilotEstimate> pulsedMotor(double current_A, double acceleration_rad_s2);
    Result<std::optional<PilotEstimate>> findCalm(const std::vector<double>& currents_A);
    Result<std::optional<PilotEstimate>> findLively(double current_A, double acceleration_rad_s2,
                                                    double highest_A);
    devices::Device& m_device;
    const IdentifyConfig& m_config;
    const ProcedureObserver& m_observer;
    SpeedWatch m_watch{"speed"};
    HeatLimits m_heat;
    double m_sign = 1.0;
    double m_fastest_rad_s = 0.0; ///< of all runs
    double m_start_rad_s = 0.0;   ///< of the run
    double m_last_rad_s = 0.0;
    Recording m_recording;
};

} // namespace halbench::app
