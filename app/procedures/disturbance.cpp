#include "app/procedures/disturbance.h"

#include <utility>

namespace halbench::app {

std::optional<control::LoadStep> disturbanceStep(const MotorEstimate& estimate,
                                                 const control::PositionLaw& law,
                                                 const LoopConditions& conditions,
                                                 const AnalysisResult& analysed) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant || !analysed.isStable || analysed.stepCurve.time_s.size() < 2) {
        return std::nullopt;
    }
    auto step = control::loadStep(*plant, law.gains, conditions.timing, DisturbanceLoad_A,
                                  analysed.stepCurve.time_s.back());
    return step ? std::optional(*std::move(step)) : std::nullopt;
}

} // namespace halbench::app
