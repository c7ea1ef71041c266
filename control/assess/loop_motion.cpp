#include "control/assess/loop_motion.h"

#include "control/law/sampled_axis.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <utility>

namespace halbench::control {

namespace {

Result<void> checkExtent(double height, double duration_s, double period_s, int pointsPerSample) {
    constexpr double MaxPoints = 1e7;
    if (!std::isfinite(height) || height == 0.0) {
        return failure(ErrorCode::OutOfRange, "a step needs a finite height that is not zero");
    }
    if (!(duration_s > 0.0 && pointsPerSample >= 1 && duration_s / period_s * pointsPerSample < MaxPoints)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a step response of {} s is not possible", duration_s));
    }
    return {};
}

} // namespace

Result<LoopMotion> loopMotion(const PositionPlant& plant, SampledLaw law, const LoopTiming& timing,
                              const MotionCause& cause, double duration_s, int pointsPerSample) {
    const double height = cause.reference_rad != 0.0 ? cause.reference_rad : cause.load_A;
    for (const auto& valid : {checkPlant(plant), checkTiming(timing),
                              checkExtent(height, duration_s, timing.period_s, pointsPerSample)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const double interval_s = timing.period_s / pointsPerSample;
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    std::deque<double> pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0);
    LoopMotion motion;
    RotorState state;
    double current_A = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        if (i % static_cast<std::size_t>(pointsPerSample) == 0) {
            pending_A.push_back(law(cause.reference_rad, state.angle_rad));
            current_A = pending_A.front();
            pending_A.pop_front();
        }
        motion.time_s.push_back(static_cast<double>(i) * interval_s);
        motion.angle_rad.push_back(state.angle_rad);
        motion.current_A.push_back(current_A);
        state = advance(plant, state, current_A + cause.load_A, interval_s);
        if (!std::isfinite(state.angle_rad)) {
            return failure(ErrorCode::Refused, "the step response of this unstable loop overflows");
        }
    }
    return motion;
}

Result<LoopStep> stepOf(LoopMotion motion, double amplitude_rad) {
    const auto metrics = measureStep(motion.time_s, motion.angle_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    return LoopStep{std::move(motion.time_s), std::move(motion.angle_rad), std::move(motion.current_A),
                    *metrics};
}

LoadStep loadOf(LoopMotion motion, double final_rad) {
    constexpr double Recovered_ratio = 0.1;
    LoadStep step;
    step.time_s = std::move(motion.time_s);
    step.angle_rad = std::move(motion.angle_rad);
    step.current_A = std::move(motion.current_A);
    step.final_rad = final_rad;
    for (std::size_t i = 0; i < step.time_s.size(); ++i) {
        if (std::abs(step.angle_rad[i]) > std::abs(step.peak_rad)) {
            step.peak_rad = step.angle_rad[i];
            step.peakTime_s = step.time_s[i];
        }
    }
    if (std::abs(final_rad) > std::abs(step.peak_rad) && !step.time_s.empty()) {
        step.peak_rad = final_rad; // approached from below, and so not within any time that is looked at
        step.peakTime_s = step.time_s.back();
    }
    const double band_rad = Recovered_ratio * std::abs(step.peak_rad);
    std::size_t within = step.time_s.size();
    while (within > 0 && std::abs(step.angle_rad[within - 1] - final_rad) <= band_rad) {
        --within;
    }
    if (within < step.time_s.size()) {
        step.recoveryTime_s = step.time_s[within];
    }
    return step;
}

} // namespace halbench::control
