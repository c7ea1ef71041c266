#include "app/procedures/apply/live_apply_plan.h"

#include "app/procedures/apply/live_step_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::PositionLaw;

constexpr std::size_t MostSteps = 40;

double atOnce_A_per_rad(const PositionLaw& law, const LiveApplyConfig& config) {
    return law.gains.proportional + law.gains.derivative / config.conditions.timing.period_s;
}

PositionLaw between(const PositionLaw& from, const PositionLaw& to, double share) {
    if (share >= 1.0) {
        return to;
    }
    PositionLaw law = to;
    const auto mix = [share](double& value, double before) { value = std::lerp(before, value, share); };
    mix(law.gains.proportional, from.gains.proportional);
    mix(law.gains.integral, from.gains.integral);
    mix(law.gains.derivative, from.gains.derivative);
    mix(law.inertia_A_s2_rad, from.inertia_A_s2_rad);
    mix(law.viscous_A_s_rad, from.viscous_A_s_rad);
    mix(law.coulomb_A, from.coulomb_A);
    mix(law.coulombSpeed_rad_s, from.coulombSpeed_rad_s);
    mix(law.stictionCurrent_A, from.stictionCurrent_A);
    mix(law.stictionThreshold_rad, from.stictionThreshold_rad);
    mix(law.stictionSpeed_rad_s, from.stictionSpeed_rad_s);
    return law;
}

/// A gain that is nearly zero beside the target's may take a first step of a twentieth of it.
bool isWithin(const PositionLaw& one, const PositionLaw& other, const LiveApplyConfig& config) {
    constexpr double Floor_ratio = 0.05;
    const auto isNear = [&](double a, double b, double target) {
        const double floor = Floor_ratio * target;
        const double low = std::max(std::min(a, b), floor);
        return std::max(a, b) <= config.largestStep_ratio * low * (1.0 + 1e-9);
    };
    return isNear(one.gains.proportional, other.gains.proportional, config.target.gains.proportional) &&
           isNear(atOnce_A_per_rad(one, config), atOnce_A_per_rad(other, config),
                  atOnce_A_per_rad(config.target, config));
}

/// The farthest share of the way that is one step from `share`.
double nextShare(const PositionLaw& from, double share, const LiveApplyConfig& config) {
    const PositionLaw here = between(from, config.target, share);
    if (isWithin(here, config.target, config)) {
        return 1.0;
    }
    double near = share;
    double far = 1.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (near + far);
        (isWithin(here, between(from, config.target, middle), config) ? near : far) = middle;
    }
    return near;
}

} // namespace

Result<std::vector<PositionLaw>> lawsBetween(const PositionLaw& from, const LiveApplyConfig& config) {
    for (const PositionLaw* law : {&from, &config.target}) {
        for (const ParameterValue& value : lawParameters(*law)) {
            if (!std::isfinite(value.value)) {
                return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", value.name),
                               "nothing was written");
            }
        }
    }
    constexpr double LeastStep_ratio = 1.05;
    if (!(config.largestStep_ratio >= LeastStep_ratio)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a step factor of {} is too small", config.largestStep_ratio),
                       "allow at least 1.05");
    }
    std::vector<PositionLaw> laws;
    for (double share = 0.0; share < 1.0;) {
        share = nextShare(from, share, config);
        laws.push_back(between(from, config.target, share));
        if (laws.size() > MostSteps) {
            return failure(ErrorCode::OutOfRange, "the gains are more than 40 steps away",
                           "allow larger steps, or apply intermediate gains first");
        }
    }
    return laws;
}

Result<std::vector<LiveStep>> planLiveApply(const PositionLaw& from, const LiveApplyConfig& config) {
    return planLiveApply(from, config, [] { return Result<void>(); });
}

Result<std::vector<LiveStep>> planLiveApply(const PositionLaw& from, const LiveApplyConfig& config,
                                            const std::function<Result<void>()>& afterEach) {
    const auto motors = liveMotors(config);
    if (!motors) {
        return failure(motors.error());
    }
    const auto laws = lawsBetween(from, config);
    if (!laws) {
        return failure(laws.error());
    }
    std::vector<LiveStep> steps;
    for (const PositionLaw& law : *laws) {
        auto step = judgeLiveStep(law, *motors, config, {steps.size() + 1, laws->size()});
        if (!step) {
            return failure(step.error());
        }
        steps.push_back(*std::move(step));
        if (const auto goOn = afterEach(); !goOn) {
            return failure(goOn.error());
        }
    }
    return steps;
}

} // namespace halbench::app
