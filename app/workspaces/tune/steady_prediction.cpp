#include "app/workspaces/tune/steady_prediction.h"

#include <utility>

namespace halbench::app {

namespace {

bool isSameMotor(const MotorEstimate& one, const MotorEstimate& other) {
    return one.values == other.values && one.covarianceNames == other.covarianceNames &&
           one.covariance == other.covariance;
}

} // namespace

std::shared_ptr<const PresentLoop> presentLoop(const MotorEstimate& motor, const LoopLaw& law,
                                               const LoopConditions& conditions,
                                               std::shared_ptr<const PresentLoop> known) {
    if (known && isSameMotor(known->motor, motor) && known->law == law && known->conditions == conditions) {
        return known;
    }
    auto loop = std::make_shared<PresentLoop>(PresentLoop{motor, law, conditions, {}, {}});
    if (auto predicted = runAnalysis(motor, law, conditions)) {
        loop->loaded = disturbanceStep(motor, law, conditions, *predicted);
        loop->predicted = *std::move(predicted);
    }
    return loop;
}

std::shared_ptr<const DrawnMotors> drawnMotors(const MotorEstimate& motor, const UncertaintyDraws& draws,
                                               std::shared_ptr<const DrawnMotors> known) {
    if (known && isSameMotor(known->motor, motor) && known->draws.count == draws.count &&
        known->draws.seed == draws.seed) {
        return known;
    }
    return std::make_shared<DrawnMotors>(DrawnMotors{motor, draws, drawnPlants(motor, draws)});
}

} // namespace halbench::app
