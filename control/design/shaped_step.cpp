#include "control/design/held_rotor.h"
#include "control/design/shaped_loop.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <utility>

namespace halbench::control {

namespace {

Result<void> checkExtent(double amplitude_rad, double duration_s, double period_s, int pointsPerSample) {
    constexpr double MaxPoints = 1e7;
    if (!std::isfinite(amplitude_rad) || amplitude_rad == 0.0) {
        return failure(ErrorCode::OutOfRange, "a step needs a finite height that is not zero");
    }
    if (!(duration_s > 0.0 && pointsPerSample >= 1 && duration_s / period_s * pointsPerSample < MaxPoints)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a step response of {} s is not possible", duration_s));
    }
    return {};
}

/// What sets the loop in motion: one of the two.
struct Cause {
    double reference_rad = 0.0;
    double load_A = 0.0; ///< beside the current of the law
};

/// From rest at zero, with the computing delay.
Result<LoopStep> moved(const PositionPlant& plant, ShapedController controller, const LoopTiming& timing,
                       const Cause& cause, std::size_t points, int pointsPerSample) {
    const double interval_s = timing.period_s / pointsPerSample;
    std::deque<double> pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0);
    LoopStep motion;
    RotorState state;
    double current_A = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        if (i % static_cast<std::size_t>(pointsPerSample) == 0) {
            pending_A.push_back(controller.step(cause.reference_rad, state.angle_rad));
            current_A = pending_A.front();
            pending_A.pop_front();
        }
        motion.time_s.push_back(static_cast<double>(i) * interval_s);
        motion.response_rad.push_back(state.angle_rad);
        motion.current_A.push_back(current_A);
        state = advance(plant, state, current_A + cause.load_A, interval_s);
        if (!std::isfinite(state.angle_rad)) {
            return failure(ErrorCode::Refused,
                           "the step response of this unstable loop grows beyond all numbers");
        }
    }
    return motion;
}

Result<LoopStep> checkedMotion(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                               const Cause& cause, double duration_s, int pointsPerSample) {
    const double height = cause.reference_rad != 0.0 ? cause.reference_rad : cause.load_A;
    for (const auto& valid : {checkPlant(plant), checkTiming(timing),
                              checkExtent(height, duration_s, timing.period_s, pointsPerSample)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    auto controller = ShapedController::make(law, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const double interval_s = timing.period_s / pointsPerSample;
    const auto points = static_cast<std::size_t>(std::floor(duration_s / interval_s + 1e-6)) + 1;
    return moved(plant, *std::move(controller), timing, cause, points, pointsPerSample);
}

} // namespace

ShapedController::ShapedController(const ShapedLaw& law, const PidGains& gains,
                                   std::vector<FilterSection> sections, double period_s)
    : m_gains(gains), m_proportionalWeight(law.proportionalWeight), m_derivativeWeight(law.derivativeWeight),
      m_period_s(period_s), m_sections(std::move(sections)), m_memories(m_sections.size()) {}

Result<ShapedController> ShapedController::make(const ShapedLaw& law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    auto sections = gains ? filterSections(law.filters, period_s) : failure(gains.error());
    return sections ? Result<ShapedController>(ShapedController(law, *gains, *std::move(sections), period_s))
                    : failure(sections.error());
}

double ShapedController::demand_A(double reference_rad, double angle_rad) {
    const double filter_s = m_gains.filter_s.value_or(0.0);
    const double weighted_rad = m_derivativeWeight * reference_rad - angle_rad;
    m_rate_rad_s = (filter_s * m_rate_rad_s + (weighted_rad - m_lastWeighted_rad)) / (m_period_s + filter_s);
    m_lastWeighted_rad = weighted_rad;
    double current_A = m_gains.proportional * (m_proportionalWeight * reference_rad - angle_rad) +
                       m_integral_A + m_gains.derivative * m_rate_rad_s;
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        const FilterSection& section = m_sections[i];
        Memory& memory = m_memories[i];
        const double output_A = section.b0 * current_A + memory.first;
        memory.first = section.b1 * current_A - section.a1 * output_A + memory.second;
        memory.second = section.b2 * current_A - section.a2 * output_A;
        current_A = output_A;
    }
    return current_A;
}

void ShapedController::integrate(double error_rad) {
    m_integral_A += m_period_s * m_gains.integral * error_rad;
}

double ShapedController::step(double reference_rad, double angle_rad) {
    const double current_A = demand_A(reference_rad, angle_rad);
    integrate(reference_rad - angle_rad);
    return current_A;
}

Result<LoopStep> shapedStep(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample) {
    auto step = checkedMotion(plant, law, timing, {amplitude_rad, 0.0}, duration_s, pointsPerSample);
    if (!step) {
        return step;
    }
    const auto metrics = measureStep(step->time_s, step->response_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    step->metrics = *metrics;
    return step;
}

Result<double> shapedRest_rad(const ShapedLaw& law, double period_s, double load_A) {
    const auto gains = checkedGains(law, period_s);
    const auto filters = filtersInSeries(law.filters, period_s);
    if (!gains || !filters) {
        return failure(gains ? filters.error() : gains.error());
    }
    return gains->integral > 0.0 ? 0.0 : load_A / (gains->proportional * filters->dcGain());
}

Result<LoadStep> shapedLoad(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                            double load_A, double duration_s, int pointsPerSample) {
    auto motion = checkedMotion(plant, law, timing, {0.0, load_A}, duration_s, pointsPerSample);
    const auto end_rad = shapedRest_rad(law, timing.period_s, load_A);
    if (!motion || !end_rad) {
        return failure(motion ? end_rad.error() : motion.error());
    }
    LoadStep step;
    step.time_s = std::move(motion->time_s);
    step.angle_rad = std::move(motion->response_rad);
    step.current_A = std::move(motion->current_A);
    step.final_rad = *end_rad;
    measureLoad(step);
    return step;
}

} // namespace halbench::control
