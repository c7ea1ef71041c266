#include "app/procedures/tune/loop_uncertainty.h"

#include "app/procedures/tune/large_step.h"
#include "control/assess/loop_rows.h"
#include "control/base/units.h"
#include "control/robustness/filtered_bands.h"
#include "control/robustness/percentiles.h"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

/// Some of the frequencies of the picture, closer together where a delay turns the phase, and all of them
/// where that of a sampled loop turns last: between them a band runs straight to a fraction of a pixel.
std::vector<double> bandFrequencies_rad_s(const AnalysisResult::Bode& bode) {
    constexpr std::size_t Turning = 72;
    constexpr std::size_t Last = 12;
    std::vector<double> frequencies;
    const std::size_t count = bode.frequency_Hz.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t step = i + Last >= count ? 1 : i + Turning >= count ? 2 : 6;
        if (i % step == 0) {
            frequencies.push_back(2.0 * Pi * bode.frequency_Hz[i]);
        }
    }
    return frequencies;
}

constexpr std::size_t StepPoints = 90; ///< of a band: one in five pixels of a picture of usual size

} // namespace

Result<std::vector<control::PositionPlant>> drawnPlants(const MotorEstimate& estimate,
                                                        const UncertaintyDraws& draws) {
    if (estimate.covarianceNames.empty()) {
        return failure(ErrorCode::Refused, "the model has no covariance: its uncertainty is unknown",
                       "identify the motor to get its uncertainty");
    }
    const auto uncertain = uncertainPlantFromEstimate(estimate);
    return uncertain ? control::drawPlants(*uncertain, draws.count, Random(draws.seed))
                     : Result<std::vector<control::PositionPlant>>(failure(uncertain.error()));
}

Result<control::LoopBands> loopBandsOf(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                       const control::LoopTiming& timing,
                                       const std::vector<double>& frequency_rad_s) {
    return law.filtered ? control::filteredLoopBands(plants, *law.filtered, timing, frequency_rad_s)
                        : control::loopBands(plants, law.law.gains, timing, frequency_rad_s);
}

Result<control::StepBand> stepBandOf(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                     const control::LoopTiming& timing, double amplitude_rad,
                                     const BandExtent& extent) {
    const auto& [duration_s, pointsPerSample, most] = extent;
    return law.filtered ? control::filteredStepBand(plants, *law.filtered, timing, amplitude_rad, duration_s,
                                                    pointsPerSample, most)
                        : control::stepBand(plants, law.law.gains, timing, amplitude_rad, duration_s,
                                            pointsPerSample, most);
}

Result<control::DisturbanceEnvelope> disturbanceEnvelopeOf(const std::vector<control::PositionPlant>& plants,
                                                           const LoopLaw& law,
                                                           const control::LoopTiming& timing, double load_A,
                                                           const BandExtent& extent) {
    const auto& [duration_s, pointsPerSample, most] = extent;
    return law.filtered ? control::filteredDisturbanceEnvelope(plants, *law.filtered, timing, load_A,
                                                               duration_s, pointsPerSample, most)
                        : control::disturbanceEnvelope(plants, law.law.gains, timing, load_A, duration_s,
                                                       pointsPerSample, most);
}

Result<LoopUncertainty> loopUncertainty(const MotorEstimate& estimate, const LoopLaw& law,
                                        const LoopConditions& conditions, const AnalysisResult& predicted,
                                        const UncertaintyDraws& draws) {
    const auto plants = drawnPlants(estimate, draws);
    return plants ? loopUncertainty(*plants, law, conditions, predicted)
                  : Result<LoopUncertainty>(failure(plants.error()));
}

Result<LoopUncertainty> loopUncertainty(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                        const LoopConditions& conditions, const AnalysisResult& predicted) {
    auto loop = loopBandsOf(plants, law, conditions.timing, bandFrequencies_rad_s(predicted.bode));
    if (!loop) {
        return failure(loop.error());
    }
    LoopUncertainty uncertainty{*std::move(loop), {}, {}};
    if (!predicted.stepCurve.time_s.empty()) {
        auto step = stepBandOf(plants, law, conditions.timing, 1.0,
                               {predicted.stepCurve.time_s.back(), 1, StepPoints});
        if (!step) {
            return failure(step.error());
        }
        uncertainty.step = *std::move(step);
    }
    return uncertainty;
}

Result<control::StepBand> largeStepBand(const MotorEstimate& estimate, const LoopLaw& law,
                                        const LoopConditions& conditions, const StepSpan& span,
                                        const UncertaintyDraws& draws) {
    const auto plants = drawnPlants(estimate, draws);
    if (!plants) {
        return failure(plants.error());
    }
    constexpr double Shown_s = 1e-2; // what a picture can show
    const double row_s = control::LoopRows(conditions.timing.period_s).interval_s();
    const auto stride = static_cast<std::size_t>(std::max(1L, std::lround(Shown_s / row_s)));
    control::StepBand band;
    std::vector<std::vector<double>> angles; // by time, of all motors
    for (const control::PositionPlant& plant : *plants) {
        if (!control::checkPlant(plant)) {
            continue;
        }
        const auto step = predictLargeStep(plant, law, conditions, span.amplitude_rad, span.duration_s);
        if (!step) {
            return failure(step.error());
        }
        const models::IdealTrace& trace = step->trace;
        angles.resize((trace.time_s.size() + stride - 1) / stride);
        for (std::size_t i = 0; i < angles.size(); ++i) {
            angles[i].push_back(trace.angle_rad[i * stride]);
        }
        if (band.time_s.empty()) {
            for (std::size_t i = 0; i < trace.time_s.size(); i += stride) {
                band.time_s.push_back(trace.time_s[i]);
            }
        }
    }
    for (const std::vector<double>& values : angles) {
        Eigen::ArrayXd sorted =
            Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
        const control::MiddleNineTenths middle = control::middleNineTenths(sorted);
        band.response_rad.p5.push_back(middle.p5);
        band.response_rad.p95.push_back(middle.p95);
    }
    return band;
}

} // namespace halbench::app
