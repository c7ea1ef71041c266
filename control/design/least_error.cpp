// The least error after a load within bounds on the sensitivity and the current.
#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "control/design/direct_search.h"
#include "control/design/proven_design.h"
#include "control/lti/responses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

using Point = DirectSearch::Point; ///< logarithms of K_P, K_I, K_D

/// What is asked, and of which loop.
struct LeastErrorProblem {
    PositionPlant plant;
    LoopTiming timing;
    LeastErrorTargets targets;
    double currentLimit_A = 0.0;
};

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

PidGains gainsFrom(const Point& logarithms) {
    PidGains gains;
    gains.proportional = std::exp(logarithms[0]);
    gains.integral = std::exp(logarithms[1]);
    gains.derivative = std::exp(logarithms[2]);
    return gains;
}

/// Until the slowest part of the answer has fallen to a millionth: a slow integral must not look cheap.
double restTime_s(double poleRadius, double period_s) {
    constexpr double Least_samples = 50.0;
    constexpr double Most_samples = 20000.0;
    const double samples = std::log(1e-6) / std::log(std::max(poleRadius, 1e-6));
    return period_s * std::ceil(std::clamp(samples, Least_samples, Most_samples));
}

/// Largest current of a reference step of 1 rad on the linear loop; while the first motion waits for the
/// delay, the integral adds to K_P.
double stepCurrent_A_per_rad(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                             double duration_s) {
    const auto step = linearStep(plant, gains, timing, 1.0, duration_s, 1);
    if (!step) {
        return std::numeric_limits<double>::infinity();
    }
    double most_A = 0.0;
    for (const double current_A : step->current_A) {
        most_A = std::max(most_A, std::abs(current_A));
    }
    return most_A;
}

/// The measure, raised steeply by what a bound is exceeded; infinite for an unstable loop.
double cost(const LeastErrorProblem& problem, const PidGains& gains) {
    const auto loop = sampledOpenLoop(problem.plant, gains, problem.timing);
    const double radius = loop ? poleRadius(*loop) : 1.0;
    if (radius >= 1.0) {
        return HUGE_VAL;
    }
    const double duration_s = restTime_s(radius, problem.timing.period_s);
    double excess = std::max(0.0, sensitivityPeaks(*loop).Ms_ratio / problem.targets.mostMs_ratio - 1.0);
    if (const auto& step_rad = problem.targets.step_rad) {
        const double current_A =
            *step_rad * stepCurrent_A_per_rad(problem.plant, gains, problem.timing, duration_s);
        excess += std::max(0.0, current_A / problem.currentLimit_A - 1.0);
    }
    const auto error = loadError(problem.plant, gains, problem.timing, problem.targets.measure, duration_s);
    return error ? *error * (1.0 + 1e3 * excess) : HUGE_VAL;
}

/// Restarted until it stays, then along the kink that a bound makes of its valley; and again, for the kink
/// may have been met far from the lowest point of it.
Point searched(const LeastErrorProblem& problem, const Point& start) {
    const auto costOf = [&problem](const Point& point) { return cost(problem, gainsFrom(point)); };
    DirectSearch search(costOf);
    Point point = start;
    double before = HUGE_VAL;
    constexpr int MostRestarts = 12;
    for (int i = 0; i < MostRestarts; ++i) {
        point = search.from(point, i % 2 == 0 ? 0.5 : -0.3);
        if (search.best() > 0.999 * before) {
            break;
        }
        before = search.best();
    }
    point = polished(costOf, point, 0.05, 1e-4);
    double least = costOf(point);
    for (const double shift : {0.3, -0.3, 0.0}) {
        Point next = point;
        next[1] += shift;
        next = polished(costOf, search.from(next, 0.15), 0.03, 1e-4);
        const double reached = costOf(next);
        if (reached < least) {
            least = reached;
            point = next;
        }
    }
    return point;
}

/// Near the least error of any motor, as a grid of a T_s from 0.001 to 2, delays and Ms has it: in units of
/// 1/(k T_s^n) the gains follow from a T_s, the delay and how fast Ms lets the loop be (1 for Ms = 1.7). A
/// start that follows from a rule of another aim may lie where a gain no longer counts, and a search does not
/// come back from there.
PidGains startOfSpeed(const LeastErrorProblem& problem, double speed_ratio) {
    const double lag = problem.plant.dampingRate_1_s * problem.timing.period_s;
    const double wait = 1.0 + problem.timing.delay_samples;
    const double period_s = problem.timing.period_s;
    const double scale = problem.plant.accelerationGain_rad_s2_A * period_s;
    const double proportional =
        0.095 * speed_ratio * speed_ratio / (wait * wait) + 0.65 * speed_ratio * lag / wait;
    PidGains gains;
    gains.proportional = proportional / (scale * period_s);
    gains.integral = 0.125 * proportional * speed_ratio / wait * (1.0 + lag) / (scale * period_s * period_s);
    gains.derivative = (0.42 / wait + 0.1 * lag) * speed_ratio / scale;
    return gains;
}

/// Slower where the current asks for it, or where such a loop would be unstable.
Point startOf(const LeastErrorProblem& problem) {
    double speed_ratio = 0.8 * (1.0 - 1.0 / problem.targets.mostMs_ratio) / (1.0 - 1.0 / 1.7);
    PidGains gains = startOfSpeed(problem, speed_ratio);
    constexpr int MostSteps = 60;
    for (int i = 0; i < MostSteps; ++i) {
        const bool isWithin =
            gains.proportional * problem.targets.step_rad.value_or(0.0) <= problem.currentLimit_A;
        if (isWithin && std::isfinite(cost(problem, gains))) {
            break;
        }
        speed_ratio *= 0.8;
        gains = startOfSpeed(problem, speed_ratio);
    }
    return {std::log(gains.proportional), std::log(gains.integral), std::log(gains.derivative)};
}

constexpr double BoundTolerance_ratio = 1.001;

Result<ProvenDesign> withinBounds(const LeastErrorProblem& problem, Result<ProvenDesign> design) {
    if (!design) {
        return design;
    }
    const LeastErrorBounds use = boundsOf(design->assessment, problem.targets, problem.currentLimit_A);
    if (use.sensitivity.value > BoundTolerance_ratio * use.sensitivity.bound) {
        return failure(
            ErrorCode::Refused,
            fmt::format("no gains with a sensitivity peak up to {:.4g} found for this motor; minimum: {:.4g}",
                        use.sensitivity.bound, use.sensitivity.value),
            "allow a larger Ms, or reduce the computing delay");
    }
    if (use.current && use.current->value > BoundTolerance_ratio * use.current->bound) {
        return failure(ErrorCode::Refused,
                       fmt::format("no gains with at most {:.4g} A in a step of {:.4g} deg found for this "
                                   "motor; required: {:.4g} A",
                                   use.current->bound, radiansToDegrees(*problem.targets.step_rad),
                                   use.current->value),
                       "allow more current, or a smaller step");
    }
    return design;
}

} // namespace

bool BoundUse::isActive() const {
    constexpr double Near_ratio = 0.99; // what the search finds the least error to
    return value >= Near_ratio * bound;
}

LeastErrorBounds boundsOf(const LoopAssessment& assessment, const LeastErrorTargets& targets,
                          double currentLimit_A) {
    LeastErrorBounds bounds;
    bounds.sensitivity = {assessment.peaks.Ms_ratio, targets.mostMs_ratio};
    if (targets.step_rad) {
        bounds.step_rad = *targets.step_rad;
        bounds.current = BoundUse{assessment.peakCurrent_A * *targets.step_rad, currentLimit_A};
    }
    return bounds;
}

std::optional<ErrorMeasure> leastErrorMeasure(std::string_view method) {
    return method == "min-iae"    ? std::optional(ErrorMeasure::Iae)
           : method == "min-itae" ? std::optional(ErrorMeasure::Itae)
                                  : std::nullopt;
}

LeastErrorTargets leastErrorTargets(ErrorMeasure measure, const DesignTargets& targets) {
    LeastErrorTargets result;
    result.measure = measure;
    result.mostMs_ratio = targets.mostMs_ratio.value_or(result.mostMs_ratio);
    if (targets.currentLimit_A) {
        result.step_rad = degreesToRadians(targets.step_deg.value_or(least_error::UsualStep_deg));
    }
    return result;
}

Result<double> loadError(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                         ErrorMeasure measure, double duration_s) {
    const auto controller = sampledController(gains, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto back = series(*controller, TransferFunction::delay(timing.delay_samples, timing.period_s));
    const auto fromLoad = back ? feedback(sampledPlant(plant, timing.period_s), *back) : back;
    const auto response =
        fromLoad ? stepResponse(*fromLoad, duration_s, timing.period_s) : failure(fromLoad.error());
    if (!response) {
        return failure(response.error());
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < response->value.size(); ++k) {
        sum += std::abs(response->value[k]) * (measure == ErrorMeasure::Itae ? response->time_s[k] : 1.0);
    }
    return sum * timing.period_s;
}

Result<ProvenDesign> designLeastError(const PositionPlant& plant, const LoopTiming& timing,
                                      const LeastErrorTargets& targets, double currentLimit_A) {
    if (const auto valid = checkPlant(plant); !valid) {
        return failure(valid.error());
    }
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    if (!(std::isfinite(targets.mostMs_ratio) && targets.mostMs_ratio > 1.0) ||
        !isPositive(targets.step_rad.value_or(1.0)) || !isPositive(currentLimit_A)) {
        return impossibleTargets();
    }
    const LeastErrorProblem problem{plant, timing, targets, currentLimit_A};
    const PidGains gains = gainsFrom(searched(problem, startOf(problem)));
    return withinBounds(problem, provenDesign(plant, gains, timing, currentLimit_A));
}

} // namespace halbench::control
