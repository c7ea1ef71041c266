#include "control/assess/filtered_loop.h"
#include "control/assess/loop_motion.h"
#include "control/law/filtered_controller.h"
#include "control/law/filtered_delta.h"

#include <utility>

namespace halbench::control {

namespace {

Result<LoopMotion> filteredMotion(const PositionPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing, const MotionCause& cause, double duration_s,
                                  int pointsPerSample) {
    const auto controller = FilteredController::make(law, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto step = [running = *controller](double reference_rad, double angle_rad) mutable {
        return running.step(reference_rad, angle_rad);
    };
    return loopMotion(plant, step, timing, cause, duration_s, pointsPerSample);
}

} // namespace

Result<LoopStep> filteredStep(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing,
                              double amplitude_rad, double duration_s, int pointsPerSample) {
    auto motion = filteredMotion(plant, law, timing, {amplitude_rad, 0.0}, duration_s, pointsPerSample);
    return motion ? stepOf(*std::move(motion), amplitude_rad) : failure(motion.error());
}

Result<double> filteredRest_rad(const FilteredLaw& law, double period_s, double load_A) {
    const auto gains = checkedGains(law, period_s);
    const auto filters_ratio = filterGainAtRest(law.filters);
    if (!gains || !filters_ratio) {
        return failure(gains ? filters_ratio.error() : gains.error());
    }
    return gains->integral > 0.0 ? 0.0 : load_A / (gains->proportional * *filters_ratio);
}

Result<LoadStep> filteredLoad(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing,
                              double load_A, double duration_s, int pointsPerSample) {
    auto motion = filteredMotion(plant, law, timing, {0.0, load_A}, duration_s, pointsPerSample);
    const auto end_rad = filteredRest_rad(law, timing.period_s, load_A);
    if (!motion || !end_rad) {
        return failure(motion ? end_rad.error() : motion.error());
    }
    return loadOf(*std::move(motion), *end_rad);
}

} // namespace halbench::control
