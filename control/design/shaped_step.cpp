#include "control/design/held_rotor.h"
#include "control/design/shaped_loop.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>

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

/// From rest at zero, with the computing delay.
Result<LoopStep> moved(const PositionPlant& plant, ShapedController controller, const LoopTiming& timing,
                       double reference_rad, std::size_t points, int pointsPerSample) {
    const double interval_s = timing.period_s / pointsPerSample;
    std::deque<double> pending_A(static_cast<std::size_t>(timing.delay_samples), 0.0);
    LoopStep motion;
    RotorState state;
    double current_A = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        if (i % static_cast<std::size_t>(pointsPerSample) == 0) {
            pending_A.push_back(controller.step(reference_rad, state.angle_rad));
            current_A = pending_A.front();
            pending_A.pop_front();
        }
        motion.time_s.push_back(static_cast<double>(i) * interval_s);
        motion.response_rad.push_back(state.angle_rad);
        motion.current_A.push_back(current_A);
        state = advance(plant, state, current_A, interval_s);
        if (!std::isfinite(state.angle_rad)) {
            return failure(ErrorCode::Refused,
                           "the step response of this unstable loop grows beyond all numbers");
        }
    }
    return motion;
}

double coefficient(const Polynomial& polynomial, std::size_t order, std::size_t place) {
    const std::size_t lead = order + 1 - polynomial.size();
    return place < lead || place > order ? 0.0 : polynomial[place - lead];
}

} // namespace

double ShapedController::Section::step(double input) {
    const double output = b0 * input + first;
    first = b1 * input - a1 * output + second;
    second = b2 * input - a2 * output;
    return output;
}

ShapedController::ShapedController(const ShapedLaw& law, const PidGains& gains, double period_s)
    : m_gains(gains), m_proportionalWeight(law.proportionalWeight), m_derivativeWeight(law.derivativeWeight),
      m_period_s(period_s) {
    for (const LoopFilter& filter : law.filters) {
        const TransferFunction f = *sampledFilter(filter, period_s);
        const auto order = static_cast<std::size_t>(f.order());
        const double a0 = f.denominator().front();
        const auto a = [&](std::size_t i) { return coefficient(f.denominator(), order, i) / a0; };
        const auto b = [&](std::size_t i) { return coefficient(f.numerator(), order, i) / a0; };
        m_sections.push_back({b(0), b(1), b(2), a(1), a(2)});
    }
}

Result<ShapedController> ShapedController::make(const ShapedLaw& law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    return gains ? Result<ShapedController>(ShapedController(law, *gains, period_s)) : failure(gains.error());
}

double ShapedController::step(double reference_rad, double angle_rad) {
    const double filter_s = m_gains.filter_s.value_or(0.0);
    const double weighted_rad = m_derivativeWeight * reference_rad - angle_rad;
    m_rate_rad_s = (filter_s * m_rate_rad_s + (weighted_rad - m_lastWeighted_rad)) / (m_period_s + filter_s);
    double current_A = m_gains.proportional * (m_proportionalWeight * reference_rad - angle_rad) +
                       m_integral_A + m_gains.derivative * m_rate_rad_s;
    m_integral_A += m_period_s * m_gains.integral * (reference_rad - angle_rad);
    m_lastWeighted_rad = weighted_rad;
    for (Section& section : m_sections) {
        current_A = section.step(current_A);
    }
    return current_A;
}

Result<LoopStep> shapedStep(const PositionPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                            double amplitude_rad, double duration_s, int pointsPerSample) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing),
                              checkExtent(amplitude_rad, duration_s, timing.period_s, pointsPerSample)}) {
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
    auto step = moved(plant, *std::move(controller), timing, amplitude_rad, points, pointsPerSample);
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

} // namespace halbench::control
