#include "control/robustness/filtered_robustness.h"

#include "control/assess/filtered_loop.h"
#include "control/law/filtered_delta.h"
#include "control/robustness/sampled_assessments.h"

#include <vector>

namespace halbench::control {

namespace {

bool isStableWith(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    const auto radius = filteredPoleRadius(plant, law, timing);
    return radius && *radius < 1.0;
}

SampledAssessment verdictOf(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    const auto loop = deltaOpenLoop(plant, law, timing);
    return loop ? SampledAssessment{isStableWith(plant, law, timing), smallestMargins(*loop)}
                : SampledAssessment{};
}

} // namespace

Result<Robustness> assessFiltered(const UncertainPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing, int draws, Random random) {
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
    std::vector<SampledAssessment> verdicts;
    verdicts.reserve(plants->size());
    for (const PositionPlant& drawn : *plants) {
        verdicts.push_back(verdictOf(drawn, law, timing));
    }
    return robustnessOf(verdicts, isUncertain(plant));
}

} // namespace halbench::control
