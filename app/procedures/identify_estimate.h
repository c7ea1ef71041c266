#pragma once

#include "app/procedures/identify_procedure.h"
#include "control/identify/motion_fit.h"

#include <optional>

namespace halbench::app {

/// What a recording of run-ups, plateaus and coast-downs gave, before it is judged.
struct IdentifyFits {
    std::optional<control::MotionFit> motion;
    std::optional<control::BalanceFit> balance;
    std::optional<control::FrictionSweep> sweep;
    std::vector<SweepPoint> points;
    int stoppedPlateaus = 0;
    int unsteadyPlateaus = 0;
    std::string motionProblem; ///< why there is no motion fit
    std::string balanceProblem;
    std::string sweepProblem;
    double startTemperature_degC = 25.0;
    double highestTemperature_degC = 25.0;
    std::uint64_t lostRows = 0;
};

/// Errors: InvalidInput (columns missing, rate below 100 Hz, no rows), NotFinite.
Result<IdentifyFits> fitRecording(const Recording& recording, const IdentifyConfig& config);

/// Values, intervals, verdict and findings from the fits.
IdentifyResult judgeFits(const IdentifyFits& fits, const IdentifyConfig& config);

} // namespace halbench::app
