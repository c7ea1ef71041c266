#include "app/procedures/live_apply_plan.h"

#include "app/procedures/large_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::PositionLaw;

constexpr std::size_t MostSteps = 40;
constexpr std::size_t MostMotors = 300;
constexpr double BandWidening_ratio = 2.0; ///< about its middle: one motion in a thousand leaves it
constexpr double BandTolerance_rad = 0.03; ///< and what no model holds: resolution, stray field, a count

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

Result<void> admit(const TuneResult& judged, std::size_t number, std::size_t count) {
    constexpr double MostUnstable_ratio = 0.01;
    constexpr double LeastPhase_deg = 1.0;
    constexpr double LeastGain_ratio = 1.1;
    const control::Robustness& robust = judged.robust;
    const double gain = std::max(robust.gainMargin_ratio_p5, 0.0);
    const bool isRobust = robust.unstable_fraction < MostUnstable_ratio &&
                          robust.phaseMargin_deg_p5 >= LeastPhase_deg && gain >= LeastGain_ratio;
    if (judged.predicted.isStable && isRobust) {
        return {};
    }
    return failure(
        ErrorCode::Refused,
        fmt::format("step {} of {} is not safe: {:.1f} % of the motors that the data allow make its loop "
                    "unstable, its margins are {:.3g} deg and {:.3g}",
                    number, count, judged.predicted.isStable ? 100.0 * robust.unstable_fraction : 100.0,
                    robust.phaseMargin_deg_p5, gain),
        "nothing was written; choose gains with larger margins, or identify more precisely");
}

std::vector<models::ReferencePoint> stepReference(const LiveApplyConfig& config) {
    return {1, models::ReferencePoint{config.amplitude_rad, 0.0, 0.0}};
}

Result<MotionBand> bandOf(const PositionLaw& law, const std::vector<RunMotor>& motors,
                          const LiveApplyConfig& config) {
    const auto board = simulatedLaw(law, config.conditions);
    if (!board) {
        return failure(board.error());
    }
    const auto reference = stepReference(config);
    const auto rows = static_cast<std::size_t>(std::lround(1e3 * config.duration_s)) + 1;
    const MotionBand band = motionBand(motors, rows, [&](const RunMotor& motor) {
        return models::replayLoop(replayOf(motor, *board, reference, rows)).angle_rad;
    });
    return widened(band, BandWidening_ratio, BandTolerance_rad);
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
                       fmt::format("steps of a factor {} do not get anywhere", config.largestStep_ratio),
                       "allow at least 1.05");
    }
    std::vector<PositionLaw> laws;
    for (double share = 0.0; share < 1.0;) {
        share = nextShare(from, share, config);
        laws.push_back(between(from, config.target, share));
        if (laws.size() > MostSteps) {
            return failure(ErrorCode::OutOfRange, "the way to these gains takes more than 40 steps",
                           "allow larger steps, or apply gains that are nearer first");
        }
    }
    return laws;
}

Result<std::vector<LiveStep>> planLiveApply(const PositionLaw& from, const LiveApplyConfig& config) {
    auto motors = drawRuns(config.motor, config.draws);
    if (!motors) {
        return failure(motors.error());
    }
    motors->resize(std::min(motors->size(), MostMotors));
    const auto laws = lawsBetween(from, config);
    if (!laws) {
        return failure(laws.error());
    }
    TuneConfig tuning;
    tuning.method = "edited";
    tuning.conditions = config.conditions;
    tuning.draws = config.draws.count;
    tuning.seed = config.draws.seed;
    std::vector<LiveStep> steps;
    for (const PositionLaw& law : *laws) {
        const auto judged = judgeLaw(config.motor, law, tuning);
        if (!judged) {
            return failure(judged.error());
        }
        if (const auto admitted = admit(*judged, steps.size() + 1, laws->size()); !admitted) {
            return failure(admitted.error());
        }
        auto band = bandOf(law, *motors, config);
        if (!band) {
            return failure(band.error());
        }
        steps.push_back({law, judged->robust, *std::move(band)});
    }
    return steps;
}

} // namespace halbench::app
