#pragma once

#include "app/procedures/tune/disturbance.h"
#include "app/procedures/tune/loop_uncertainty.h"

#include <memory>
#include <optional>
#include <vector>

namespace halbench::app {

/// Gains on the device with everything that is predicted of them, and with everything that depends on.
/// Immutable.
struct PresentLoop {
    MotorEstimate motor;
    LoopLaw law;
    LoopConditions conditions;
    std::optional<AnalysisResult> predicted; ///< nothing: they cannot be judged
    std::optional<control::LoadStep> loaded; ///< under load; nothing also for a loop that is unstable
};

/// Motors drawn from the uncertainty of one, and what they were drawn from. Immutable.
struct DrawnMotors {
    MotorEstimate motor;
    UncertaintyDraws draws;
    Result<std::vector<control::PositionPlant>> plants; ///< errors: of drawnPlants
};

/// What a prediction holds that does not move with the gains in the hand: it goes from answer to question and
/// is computed anew where anything that it depends on is another.
struct SteadyPrediction {
    std::shared_ptr<const PresentLoop> present; ///< nothing: no gains on a device
    std::shared_ptr<const DrawnMotors> motors;
};

/// `known` where it is of this very motor, law and surroundings. What is no number is never known.
std::shared_ptr<const PresentLoop> presentLoop(const MotorEstimate& motor, const LoopLaw& law,
                                               const LoopConditions& conditions,
                                               std::shared_ptr<const PresentLoop> known);
/// `known` where it is of this very motor, number and seed.
std::shared_ptr<const DrawnMotors> drawnMotors(const MotorEstimate& motor, const UncertaintyDraws& draws,
                                               std::shared_ptr<const DrawnMotors> known);

} // namespace halbench::app
