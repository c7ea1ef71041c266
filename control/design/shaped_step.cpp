#include "control/design/loop_motion.h"
#include "control/design/shaped_loop.h"

#include <utility>

namespace halbench::control {

namespace {

Result<LoopMotion> shapedMotion(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                                const MotionCause& cause, double duration_s, int pointsPerSample) {
    const auto controller = ShapedController::make(law, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto step = [running = *controller](double reference_rad, double angle_rad) mutable {
        return running.step(reference_rad, angle_rad);
    };
    return loopMotion(plant, step, timing, cause, duration_s, pointsPerSample);
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
    auto motion = shapedMotion(plant, law, timing, {amplitude_rad, 0.0}, duration_s, pointsPerSample);
    return motion ? stepOf(*std::move(motion), amplitude_rad) : failure(motion.error());
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
    auto motion = shapedMotion(plant, law, timing, {0.0, load_A}, duration_s, pointsPerSample);
    const auto end_rad = shapedRest_rad(law, timing.period_s, load_A);
    if (!motion || !end_rad) {
        return failure(motion ? end_rad.error() : motion.error());
    }
    return loadOf(*std::move(motion), *end_rad);
}

} // namespace halbench::control
