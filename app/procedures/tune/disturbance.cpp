#include "app/procedures/tune/disturbance.h"

#include "app/procedures/tune/loop_uncertainty.h"
#include "control/assess/filtered_loop.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

std::optional<control::LoadStep> disturbanceStep(const MotorEstimate& estimate, const LoopLaw& law,
                                                 const LoopConditions& conditions,
                                                 const AnalysisResult& analysed, double load_A) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant || !analysed.isStable || analysed.stepCurve.time_s.size() < 2) {
        return std::nullopt;
    }
    const double end_s = analysed.stepCurve.time_s.back();
    const int points = analysed.stepCurve.pointsPerSample; // those of the step: the two share a time axis
    auto step = law.filtered
                    ? control::filteredLoad(*plant, *law.filtered, conditions.timing, load_A, end_s, points)
                    : control::loadStep(*plant, law.law.gains, conditions.timing, load_A, end_s, points);
    return step ? std::optional(*std::move(step)) : std::nullopt;
}

std::optional<Disturbance> disturbanceOf(const MotorEstimate& estimate, const LoopLaw& law,
                                         const LoopConditions& conditions, const AnalysisResult& analysed,
                                         double load_A, const std::vector<control::PositionPlant>& plants) {
    const int pointsPerSample = std::min(analysed.stepCurve.pointsPerSample, 5);
    constexpr std::size_t ShownPoints = 90; // of a band: one in five pixels of a picture of usual size
    auto step = disturbanceStep(estimate, law, conditions, analysed, load_A);
    if (!step) {
        return std::nullopt;
    }
    Disturbance disturbance{load_A, *std::move(step), {}};
    auto band = plants.empty()
                    ? Result<control::DisturbanceEnvelope>(failure(ErrorCode::Refused, ""))
                    : disturbanceEnvelopeOf(plants, law, conditions.timing, load_A,
                                            {analysed.stepCurve.time_s.back(), pointsPerSample, ShownPoints});
    if (band) {
        disturbance.band = *std::move(band);
    }
    return disturbance;
}

} // namespace halbench::app
