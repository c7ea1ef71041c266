#include "control/design/shaped_bands.h"

#include "control/design/held_rotor.h"
#include "control/design/moved_motors.h"
#include "control/design/shaped_loop.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>

namespace halbench::control {

namespace {

void runMotor(const PositionPlant& plant, ShapedController controller, const LoopTiming& timing,
              const LaneRun& run, LaneCurves& curves, Eigen::Index row) {
    const HeldRotor rotor(plant, timing.period_s / run.pointsPerSample);
    const auto every = static_cast<std::size_t>(run.pointsPerSample);
    std::deque<double> pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0);
    RotorState state;
    double current_A = 0.0;
    std::size_t next = 0;
    for (std::size_t point = 0; next < run.kept.size(); ++point) {
        if (point % every == 0) {
            pending_A.push_back(controller.step(run.reference_rad, state.angle_rad));
            current_A = pending_A.front() + run.load_A;
            pending_A.pop_front();
        }
        if (point == run.kept[next]) {
            curves(row, static_cast<Eigen::Index>(next)) = state.angle_rad;
            ++next;
        }
        rotor.move(state, current_A);
    }
}

std::vector<PositionPlant> motorsAmong(const std::vector<PositionPlant>& plants) {
    std::vector<PositionPlant> motors;
    std::copy_if(plants.begin(), plants.end(), std::back_inserter(motors),
                 [](const PositionPlant& plant) { return checkPlant(plant).has_value(); });
    return motors;
}

/// The plants and the controller must live as long as what is returned.
MovedMotors shapedMotors(const std::vector<PositionPlant>& plants, const ShapedController& controller,
                         const LoopTiming& timing) {
    MovedMotors motors{plants.size(),
                       timing.period_s,
                       [&plants, &controller, timing](std::size_t first, const LaneRun& run,
                                                      LaneCurves& curves, std::size_t row) {
                           const std::size_t count = std::min<std::size_t>(LaneWidth, plants.size() - first);
                           for (std::size_t i = 0; i < count; ++i) {
                               runMotor(plants[first + i], controller, timing, run, curves,
                                        static_cast<Eigen::Index>(row + i));
                           }
                       },
                       {}};
    motors.middle = [motors](const LaneRun& run) { return middleByParts(motors, run); };
    return motors;
}

Result<ShapedController> checkedController(const std::vector<PositionPlant>& motors, const ShapedLaw& law,
                                           const LoopTiming& timing) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    if (motors.empty()) {
        return failure(ErrorCode::Refused, "none of the drawn plants is a motor",
                       "identify the motor again, or correct the model file");
    }
    return ShapedController::make(law, timing.period_s);
}

} // namespace

Result<LoopBands> shapedLoopBands(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                  const LoopTiming& timing, const std::vector<double>& frequency_rad_s) {
    const auto controller = shapedController(law, timing.period_s);
    return controller ? loopBands(plants, *controller, timing, frequency_rad_s)
                      : Result<LoopBands>(failure(controller.error()));
}

Result<StepBand> shapedStepBand(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                const LoopTiming& timing, double amplitude_rad, double duration_s,
                                int pointsPerSample, std::size_t mostPoints) {
    const std::vector<PositionPlant> motors = motorsAmong(plants);
    const auto controller = checkedController(motors, law, timing);
    return controller ? stepBandOf(shapedMotors(motors, *controller, timing), amplitude_rad, duration_s,
                                   pointsPerSample, mostPoints)
                      : Result<StepBand>(failure(controller.error()));
}

Result<LoadBand> shapedLoadBand(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                const LoopTiming& timing, double load_A, double duration_s,
                                int pointsPerSample, std::size_t mostPoints) {
    const std::vector<PositionPlant> motors = motorsAmong(plants);
    const auto controller = checkedController(motors, law, timing);
    const auto final_rad = shapedRest_rad(law, timing.period_s, load_A);
    if (!controller || !final_rad) {
        return failure(controller ? final_rad.error() : controller.error());
    }
    return loadBandOf(shapedMotors(motors, *controller, timing), *final_rad, load_A, duration_s,
                      pointsPerSample, mostPoints);
}

} // namespace halbench::control
