#include "control/robustness/shaped_robustness.h"

#include "control/assess/shaped_loop.h"
#include "control/law/shaped_delta.h"
#include "control/robustness/drawn_verdicts.h"

#include <vector>

namespace halbench::control {

namespace {

bool isStableWith(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing) {
    const auto radius = shapedPoleRadius(plant, law, timing);
    return radius && *radius < 1.0;
}

DrawnVerdict verdictOf(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing) {
    const auto loop = deltaOpenLoop(plant, law, timing);
    return loop ? drawnVerdict(isStableWith(plant, law, timing), smallestMargins(*loop)) : noMotor();
}

} // namespace

Result<Robustness> assessShaped(const UncertainPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                                int draws, Random random) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    if (const auto gains = checkedGains(law, timing.period_s); !gains) {
        return failure(gains.error());
    }
    const auto plants = drawPlants(plant, draws, random);
    if (!plants) {
        return failure(plants.error());
    }
    std::vector<DrawnVerdict> verdicts;
    verdicts.reserve(plants->size());
    for (const PositionPlant& drawn : *plants) {
        verdicts.push_back(verdictOf(drawn, law, timing));
    }
    return robustnessOf(verdicts, isUncertain(plant));
}

} // namespace halbench::control
