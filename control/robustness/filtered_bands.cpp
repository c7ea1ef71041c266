#include "control/robustness/filtered_bands.h"

#include "control/assess/filtered_loop.h"
#include "control/law/filtered_controller.h"
#include "control/law/filtered_delta.h"
#include "control/robustness/batch_axis.h"
#include "control/robustness/simulated_ensemble.h"

#include <algorithm>
#include <iterator>

namespace halbench::control {

namespace {

using Lanes = BatchState::Lanes;

/// As `runBatch`, with this law.
void runMotors(const std::vector<PositionPlant>& plants, std::size_t first, LawRun<Lanes> controller,
               const LoopTiming& timing, const BatchRun& run, BatchCurves& curves, std::size_t row) {
    const BatchAxis rotors(plants, first, timing.period_s / run.pointsPerSample);
    const auto every = static_cast<std::size_t>(run.pointsPerSample);
    const auto lanes = static_cast<Eigen::Index>(std::min<std::size_t>(LaneWidth, plants.size() - first));
    std::vector<Lanes> pending_A(static_cast<std::size_t>(timing.delay_samples) + 1, Lanes::Zero()); // a ring
    Lanes angle = Lanes::Zero();
    Lanes speed = Lanes::Zero();
    Lanes current_A = Lanes::Zero();
    std::size_t sample = 0;
    std::size_t next = 0;
    for (std::size_t point = 0; next < run.kept.size(); ++point) {
        if (point % every == 0) {
            pending_A[sample++ % pending_A.size()] = controller.step(run.reference_rad, angle);
            current_A = pending_A[sample % pending_A.size()] + run.load_A; // the oldest: of so many before
        }
        if (point == run.kept[next]) {
            curves.col(static_cast<Eigen::Index>(next)).segment(static_cast<Eigen::Index>(row), lanes) =
                angle.head(lanes);
            ++next;
        }
        rotors.move(angle, speed, current_A);
    }
}

std::vector<PositionPlant> motorsAmong(const std::vector<PositionPlant>& plants) {
    std::vector<PositionPlant> motors;
    std::copy_if(plants.begin(), plants.end(), std::back_inserter(motors),
                 [](const PositionPlant& plant) { return checkPlant(plant).has_value(); });
    return motors;
}

/// The plants must live as long as what is returned.
SimulatedEnsemble filteredMotors(const std::vector<PositionPlant>& plants,
                                 const LawEquation<double>& equation, const LoopTiming& timing) {
    const LawRun<Lanes> controller(equation, Lanes::Zero());
    SimulatedEnsemble motors{plants.size(),
                             timing.period_s,
                             [&plants, controller, timing](std::size_t first, const BatchRun& run,
                                                           BatchCurves& curves, std::size_t row) {
                                 runMotors(plants, first, controller, timing, run, curves, row);
                             },
                             {}};
    motors.middle = [motors](const BatchRun& run) { return middleByParts(motors, run); };
    return motors;
}

Result<LawEquation<double>> checkedEquation(const std::vector<PositionPlant>& motors, const FilteredLaw& law,
                                            const LoopTiming& timing) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    if (motors.empty()) {
        return failure(ErrorCode::Refused, "no valid motor among the samples", "identify the motor again");
    }
    return lawEquation(law, timing.period_s);
}

} // namespace

Result<LoopBands> filteredLoopBands(const std::vector<PositionPlant>& plants, const FilteredLaw& law,
                                    const LoopTiming& timing, const std::vector<double>& frequency_rad_s) {
    const auto controller = deltaController(law, timing.period_s);
    return controller ? loopBands(plants, *controller, timing, frequency_rad_s)
                      : Result<LoopBands>(failure(controller.error()));
}

Result<StepBand> filteredStepBand(const std::vector<PositionPlant>& plants, const FilteredLaw& law,
                                  const LoopTiming& timing, double amplitude_rad, double duration_s,
                                  int pointsPerSample, std::size_t mostPoints) {
    const std::vector<PositionPlant> motors = motorsAmong(plants);
    const auto equation = checkedEquation(motors, law, timing);
    return equation ? stepBandOf(filteredMotors(motors, *equation, timing), amplitude_rad, duration_s,
                                 pointsPerSample, mostPoints)
                    : Result<StepBand>(failure(equation.error()));
}

Result<DisturbanceEnvelope> filteredDisturbanceEnvelope(const std::vector<PositionPlant>& plants,
                                                        const FilteredLaw& law, const LoopTiming& timing,
                                                        double load_A, double duration_s, int pointsPerSample,
                                                        std::size_t mostPoints) {
    const std::vector<PositionPlant> motors = motorsAmong(plants);
    const auto equation = checkedEquation(motors, law, timing);
    const auto final_rad = filteredRest_rad(law, timing.period_s, load_A);
    if (!equation || !final_rad) {
        return failure(equation ? final_rad.error() : equation.error());
    }
    return disturbanceEnvelopeOf(filteredMotors(motors, *equation, timing), *final_rad, load_A, duration_s,
                                 pointsPerSample, mostPoints);
}

} // namespace halbench::control
