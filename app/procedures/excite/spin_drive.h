#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/base/procedure_steps.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Plateaus of current, one after the other on the board's own generator, each `dwell_s` long.
struct PlateauRun {
    std::vector<double> currents_A; ///< at most 32
    double dwell_s = 0.0;
    double mayReach_rad_s = 0.0; ///< the run ends early, without current, when it turns faster
    std::string text;            ///< for the progress line
    /// It ends before it turns faster than this, as far as that can be foreseen; absent: mayReach_rad_s.
    std::optional<double> neverAbove_rad_s = {};

    double duration_s() const { return dwell_s * static_cast<double>(currents_A.size()); }
    /// Mean square of the current in one phase of a turning rotor: half that of the amplitude.
    double meanSquare_A2() const;
};

enum class RunEnd { Complete, TooFast };

/// Heat limits of a run: resources/help/architecture.md, safety.
struct HeatLimits {
    double pause_degC = 65.0;
    double refuse_degC = 70.0;
};

/// The speed seen last in a stream; feed it to ProcedureObserver::onBlock.
class SpeedWatch {
public:
    explicit SpeedWatch(std::string signal) : m_signal(std::move(signal)) {}
    void take(const SampleBlock& block);
    double highest_rad_s() const { return m_highest_rad_s; }
    void reset() { m_highest_rad_s = 0.0; }

private:
    std::string m_signal;
    double m_highest_rad_s = 0.0;
};

/// Sets the board up for spinning: speed window on, position window off, currents commutated at the fast rate
/// and not ahead (the fit knows the lag, and a recording needs no further word), arctangent, stray field
/// compensated. Parameters that the board lacks are left out. The caller holds the RestoreGuard.
/// Errors: of the device.
Result<void> prepareSpinning(devices::Device& device, double speedLimit_rad_s);

/// Waits for cool coils, arms, runs the plateaus and disarms. The board owns the current: it goes to zero at
/// the end of the list whatever happens here. Errors: Refused (heat), of the device, of the abort.
Result<RunEnd> runPlateaus(devices::Device& device, const ProcedureObserver& observer, const PlateauRun& run,
                           const HeatLimits& heat, SpeedWatch& watch);

} // namespace halbench::app
