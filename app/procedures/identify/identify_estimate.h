#pragma once

#include "app/procedures/identify/identify_procedure.h"
#include "control/identify/extra_force.h"
#include "control/identify/torque_linearity.h"

#include <optional>

namespace halbench::app {

/// Forces that the motor's model lacks, as far as the motion shows them.
struct MissingForces {
    std::vector<control::ExtraForceTerm> terms; ///< that are significant
    bool isAdequate = true;                     ///< with the terms, the motion shows no further one
    bool isTaken = false; ///< they change the constants: `motion` and `balance` are those with the terms
};

/// Fits of a recording of run-ups, plateaus and coast-downs, before they are judged.
struct IdentifyFits {
    std::optional<control::MotionFit> motion;
    std::optional<control::BalanceFit> balance;
    /// Without any further force, which a few stretches show too poorly to plan by.
    std::optional<control::MotionFit> plainMotion;
    std::optional<control::BalanceFit> plainBalance;
    std::optional<control::TorqueLinearity> linearity; ///< of the torque in the current
    MissingForces missing;
    double slowest_rad_s = 3.0; ///< of the motion that is fitted
    std::optional<control::FrictionSweep> sweep;
    std::vector<SweepPoint> points;
    std::uint64_t stoppedPlateaus = 0;
    std::uint64_t slowPlateaus = 0;
    std::uint64_t unsteadyPlateaus = 0;
    std::uint64_t againstPlateaus = 0; ///< that turn against their current
    bool isSpeedColumn = false;        ///< the angle's column holds a speed
    std::string motionProblem;         ///< why there is no motion fit
    std::string balanceProblem;
    std::string sweepProblem;
    double largestCurrent_A = 0.0;
    double startTemperature_degC = 25.0;
    std::optional<double> highestTemperature_degC; ///< of the coils, where it was recorded
    std::uint64_t lostRows = 0;
    std::optional<double> wrap_rad; ///< at which the angle jumped back
};

/// Errors: InvalidInput (columns missing, rate below 100 Hz, no rows), NotFinite, that of `checkAbort`.
Result<IdentifyFits> fitRecording(const Recording& recording, const IdentifyConfig& config,
                                  const AbortCheck& checkAbort = {});

/// Values, intervals, verdict and findings from the fits.
IdentifyResult judgeFits(const IdentifyFits& fits, const IdentifyConfig& config);

} // namespace halbench::app
