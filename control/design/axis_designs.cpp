#include "control/design/axis_designs.h"

#include "control/analysis/loop_functions.h"
#include "control/analysis/margins.h"
#include "control/assess/filtered_loop.h"
#include "control/base/units.h"
#include "control/design/design_targets.h"
#include "control/law/filtered_delta.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::control {
namespace {

constexpr double SlowPole_1_s = 2.2;        ///< p
constexpr double SlowPole_ratio = 2.2 / 30; ///< of w at most
constexpr double Weight = 0.745;            ///< b
constexpr double Filter_periods = 2.0;      ///< time constant of the derivative filter
constexpr double DelayTimesFrequency = 0.105;

/// What a candidate loop is judged by.
struct AxisQuality {
    bool isStable = false;
    double phaseMargin_deg = 0.0;
};

AxisQuality judge(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    AxisQuality quality;
    const auto radius = filteredPoleRadius(plant, law, timing);
    const auto loop = deltaOpenLoop(plant, law, timing);
    if (!radius || !loop) {
        return quality;
    }
    quality.isStable = *radius < 1.0;
    quality.phaseMargin_deg = smallestMargins(*loop).phaseMargin_deg;
    return quality;
}

double bandwidth_Hz(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    const auto loop = filteredOpenLoop(plant, law, timing);
    const auto closed = loop ? feedback(*loop, TransferFunction::gain(1.0, loop->timeBase())) : loop;
    return closed ? bandwidth_rad_s(*closed).value_or(0.0) / (2.0 * Pi) : 0.0;
}

/// Largest value in [low, high] for which `isFine` holds, when it holds from `low` up to some limit.
double largestFine(double low, double high, const std::function<bool(double)>& isFine) {
    if (isFine(high)) {
        return high;
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (isFine(middle) ? low : high) = middle;
    }
    return low;
}

/// The problem of a design, with what all methods ask.
struct AxisProblem {
    const PositionPlant& plant;
    const LoopTiming& timing;
    const DesignTargets& targets;
    double usual_rad_s;

    Result<FilteredLaw> at(double frequency_rad_s) const { return axisLaw(plant, timing, frequency_rad_s); }
    bool hasMargin(double frequency_rad_s, double phaseMargin_deg) const {
        const auto law = at(frequency_rad_s);
        const AxisQuality quality = law ? judge(plant, *law, timing) : AxisQuality{};
        return quality.isStable && quality.phaseMargin_deg >= phaseMargin_deg;
    }
    /// The slowest loop that is looked at: faster than the axis damps by itself.
    double slowest_rad_s() const {
        return std::max(0.01 * usualAxisFrequency_rad_s(timing), 0.55 * plant.dampingRate_1_s);
    }
    double fastest_rad_s(double phaseMargin_deg) const {
        return largestFine(slowest_rad_s(), 20.0 * usualAxisFrequency_rad_s(timing),
                           [&](double w) { return hasMargin(w, phaseMargin_deg); });
    }
};

Result<FilteredLaw> designRecommended(const AxisProblem& problem) {
    constexpr double LeastPhaseMargin_deg = 45.0;
    return problem.at(std::min(problem.usual_rad_s, problem.fastest_rad_s(LeastPhaseMargin_deg)));
}

Result<FilteredLaw> designBandwidth(const AxisProblem& problem) {
    if (!problem.targets.bandwidth_Hz) {
        return failure(ErrorCode::Usage, "method bandwidth needs a target bandwidth",
                       "add --bandwidth-hz HZ");
    }
    constexpr double LeastPhaseMargin_deg = 25.0;
    const double slowest_rad_s = problem.slowest_rad_s();
    const double fastest_rad_s = problem.fastest_rad_s(LeastPhaseMargin_deg);
    const auto at = [&](double w) {
        const auto law = problem.at(w);
        return law ? bandwidth_Hz(problem.plant, *law, problem.timing) : 0.0;
    };
    const double asked_Hz = *problem.targets.bandwidth_Hz;
    if (const double least_Hz = at(slowest_rad_s), most_Hz = at(fastest_rad_s);
        asked_Hz < least_Hz || asked_Hz > most_Hz) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a bandwidth of {:.4g} Hz is not possible on this axis at {:.4g} Hz "
                                   "sampling and {} samples of delay",
                                   asked_Hz, 1.0 / problem.timing.period_s, problem.timing.delay_samples),
                       fmt::format("choose {:.3g} to {:.3g} Hz", least_Hz, most_Hz));
    }
    return problem.at(largestFine(slowest_rad_s, fastest_rad_s, [&](double w) { return at(w) <= asked_Hz; }));
}

Result<FilteredLaw> designPhaseMargin(const AxisProblem& problem) {
    if (!problem.targets.phaseMargin_deg) {
        return failure(ErrorCode::Usage, "method phase-margin needs a target margin",
                       "add --phase-margin-deg DEG");
    }
    const double asked_deg = *problem.targets.phaseMargin_deg;
    // Far below the fastest loop the integral takes phase: the margin is looked for above the usual one's
    // third.
    const double slowest_rad_s =
        std::max(problem.slowest_rad_s(), usualAxisFrequency_rad_s(problem.timing) / 3.0);
    if (!problem.hasMargin(slowest_rad_s, asked_deg)) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("no loop of this structure has a phase margin of {:.4g} deg on this axis", asked_deg),
            "use 30 to 60 deg");
    }
    return problem.at(largestFine(slowest_rad_s, 20.0 * usualAxisFrequency_rad_s(problem.timing),
                                  [&](double w) { return problem.hasMargin(w, asked_deg); }));
}

/// Rules that know no set-point weight: b = 1, the difference over one sample.
Result<FilteredLaw> designPlain(std::string_view method, const AxisProblem& problem) {
    DesignTargets targets = problem.targets;
    if (method == "lqr") {
        targets.omega_rad_s = targets.omega_rad_s.value_or(problem.usual_rad_s);
    }
    const auto law = designLaw(method, problem.plant, problem.timing, targets);
    if (!law) {
        return failure(law.error());
    }
    FilteredLaw filtered;
    filtered.gains = law->gains;
    return filtered;
}

Result<DesignMethod> findMethod(std::string_view name) {
    std::vector<std::string_view> known;
    for (const DesignMethod& method : axisDesignMethods()) {
        if (method.name == name) {
            return method;
        }
        known.push_back(method.name);
    }
    return failure(ErrorCode::UnknownName,
                   fmt::format("design method '{}' is not available for this axis", name),
                   fmt::format("choose one of: {}", fmt::join(known, ", ")));
}

} // namespace

const std::vector<DesignMethod>& axisDesignMethods() {
    static const std::vector<DesignMethod> methods = {
        {"recommended", "", "recommended for this axis"},
        {"pole-placement", "zeta, omega-rad-s",
         "PID with the requested pole pair, set-point weight and filter"},
        {"bandwidth", "bandwidth-hz", "recommended shape with the requested closed-loop bandwidth"},
        {"phase-margin", "phase-margin-deg",
         "fastest loop of this structure with the requested phase margin"},
        {"lqr", "omega-rad-s",
         "linear-quadratic regulator, error and effort weights for the requested frequency"},
        {"lead", "phase-margin-deg, omega-rad-s", "PD (lead) with the requested phase margin"}};
    return methods;
}

double usualAxisFrequency_rad_s(const LoopTiming& timing) {
    constexpr double Hold_periods = 0.5;
    return DelayTimesFrequency / ((timing.delay_samples + Hold_periods + Filter_periods) * timing.period_s);
}

Result<FilteredLaw> axisLaw(const PositionPlant& plant, const LoopTiming& timing, double frequency_rad_s,
                            double zeta_ratio) {
    const double w = frequency_rad_s;
    const double p = std::min(SlowPole_1_s, SlowPole_ratio * w);
    const double damping_1_s = 2.0 * zeta_ratio * w + p - plant.dampingRate_1_s;
    if (damping_1_s < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("damping rate of this axis {:.4g} 1/s, above that of poles at {:.4g} "
                                   "rad/s with zeta = {:.4g}",
                                   plant.dampingRate_1_s, w, zeta_ratio),
                       "use a higher frequency or more damping");
    }
    FilteredLaw law;
    law.gains.proportional = (w * w + 2.0 * zeta_ratio * w * p) / plant.accelerationGain_rad_s2_A;
    law.gains.integral = p * w * w / plant.accelerationGain_rad_s2_A;
    law.gains.derivative = damping_1_s / plant.accelerationGain_rad_s2_A;
    // T_f/(T_s + T_f) = exp(-1/2): the law takes its difference backward.
    law.gains.filter_s = timing.period_s / std::expm1(1.0 / Filter_periods);
    law.proportionalWeight = Weight;
    return law;
}

Result<FilteredLaw> designAxisLaw(std::string_view method, const PositionPlant& plant,
                                  const LoopTiming& timing, const DesignTargets& targets,
                                  double usual_rad_s) {
    const auto found = findMethod(method);
    if (!found) {
        return failure(found.error());
    }
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    if (const auto valid = checkTargets(*found, timing, targets); !valid) {
        return failure(valid.error());
    }
    const AxisProblem problem{plant, timing, targets,
                              usual_rad_s > 0.0 ? usual_rad_s : usualAxisFrequency_rad_s(timing)};
    if (method == "recommended") {
        return designRecommended(problem);
    }
    if (method == "pole-placement") {
        return axisLaw(plant, timing, targets.omega_rad_s.value_or(problem.usual_rad_s),
                       targets.zeta.value_or(1.0));
    }
    if (method == "bandwidth") {
        return designBandwidth(problem);
    }
    if (method == "phase-margin") {
        return designPhaseMargin(problem);
    }
    return designPlain(method, problem);
}

} // namespace halbench::control
