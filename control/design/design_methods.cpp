#include "control/design/design_methods.h"

#include "control/analysis/loop_functions.h"
#include "control/base/units.h"
#include "control/design/crossover_design.h"
#include "control/design/design_targets.h"
#include "control/design/rule_designs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace halbench::control {

namespace {

/// The closed loop of the recommended preset on the published motor, s^3 + D s^2 + P s + I, at 100 Hz
/// (htm-theory.md 8.4: K_P = 40, K_I = 60, K_D = 1.4 with k = 26, a = 2.2364). Keeping this polynomial, with
/// rates in proportion to the sampling rate, carries the preset over to any motor.
struct LoopShape {
    double damping_1_s = 38.6363636363636364; // a + k K_D
    double stiffness_1_s2 = 1040.0;           // k K_P
    double integral_1_s3 = 1560.0;            // k K_I
};
constexpr double ShapePeriod_s = 0.01;

PidGains filteredGains(const PositionPlant& plant, double speedRatio) {
    const LoopShape shape;
    const double k = plant.accelerationGain_rad_s2_A;
    PidGains gains;
    gains.proportional = shape.stiffness_1_s2 * speedRatio * speedRatio / k;
    gains.integral = shape.integral_1_s3 * speedRatio * speedRatio * speedRatio / k;
    gains.derivative = std::max(0.0, (shape.damping_1_s * speedRatio - plant.dampingRate_1_s) / k);
    return gains;
}

/// What a candidate loop is judged by while a method searches.
struct Quality {
    bool isStable = false;
    StabilityMargins margins;
    double bandwidth_rad_s = 0.0; ///< of T = L/(1+L); 0 when it never falls by 3 dB
};

Quality judge(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing) {
    Quality quality;
    const auto loop = sampledOpenLoop(plant, gains, timing);
    if (!loop) {
        return quality;
    }
    quality.isStable = poleRadius(*loop) < 1.0;
    quality.margins = smallestMargins(*loop);
    const auto closed = feedback(*loop, TransferFunction::gain(1.0, loop->timeBase()));
    if (closed) {
        quality.bandwidth_rad_s = bandwidth_rad_s(*closed).value_or(0.0);
    }
    return quality;
}

/// Largest value in [low, high] for which `isFine` holds, when it holds from `low` up to some limit.
double largestFine(double low, double high, const std::function<bool(double)>& isFine) {
    if (isFine(high)) {
        return high;
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (isFine(middle) ? low : high) = middle;
    }
    return low;
}

PositionLaw withFeedForward(const PidGains& gains, const PositionPlant& plant) {
    PositionLaw law;
    law.gains = gains;
    addFeedForward(law, plant);
    return law;
}

Result<PositionLaw> designRecommended(const PositionPlant& plant, const LoopTiming& timing,
                                      const DesignTargets&) {
    // Without delay the shape has 37.9 deg; a computing delay is paid with speed, not with margin.
    constexpr double LeastPhaseMargin_deg = 35.0;
    const double fullSpeed = ShapePeriod_s / timing.period_s;
    const double speed = largestFine(0.01 * fullSpeed, fullSpeed, [&](double ratio) {
        const Quality quality = judge(plant, filteredGains(plant, ratio), timing);
        return quality.isStable && quality.margins.phaseMargin_deg >= LeastPhaseMargin_deg;
    });
    return withFeedForward(filteredGains(plant, speed), plant);
}

/// alpha = c/J - 2 zeta w, K_P = (w^2 + 2 zeta w alpha)/k, K_I = alpha w^2/k (htm-theory.md 3.6).
Result<PositionLaw> designPolePlacement(const PositionPlant& plant, const LoopTiming&,
                                        const DesignTargets& targets) {
    const double zeta = targets.zeta.value_or(0.06);
    const double omega_rad_s = targets.omega_rad_s.value_or(15.0);
    const double alpha_1_s = plant.dampingRate_1_s - 2.0 * zeta * omega_rad_s;
    if (alpha_1_s < 0.0) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("zeta = {:.4g} at {:.4g} rad/s cannot be reached with a PI position loop on this "
                        "motor: zeta <= c/(2 J omega) = {:.4g}",
                        zeta, omega_rad_s, plant.dampingRate_1_s / (2.0 * omega_rad_s)),
            "lower zeta or omega, or use method bandwidth or phase-margin, which add derivative action");
    }
    const double k = plant.accelerationGain_rad_s2_A;
    PositionLaw law;
    law.gains.proportional = (omega_rad_s * omega_rad_s + 2.0 * zeta * omega_rad_s * alpha_1_s) / k;
    law.gains.integral = alpha_1_s * omega_rad_s * omega_rad_s / k;
    return law;
}

Result<PositionLaw> designBandwidth(const PositionPlant& plant, const LoopTiming& timing,
                                    const DesignTargets& targets) {
    if (!targets.bandwidth_Hz) {
        return failure(ErrorCode::Usage, "method bandwidth needs a target bandwidth",
                       "add --bandwidth-hz HZ");
    }
    constexpr double LeastPhaseMargin_deg = 25.0;
    const double fullSpeed = ShapePeriod_s / timing.period_s;
    const double slowest = 0.005 * fullSpeed;
    const double fastest = largestFine(slowest, 2.0 * fullSpeed, [&](double ratio) {
        const Quality quality = judge(plant, filteredGains(plant, ratio), timing);
        return quality.isStable && quality.margins.phaseMargin_deg >= LeastPhaseMargin_deg;
    });
    const auto bandwidth_Hz = [&](double ratio) {
        return judge(plant, filteredGains(plant, ratio), timing).bandwidth_rad_s / (2.0 * Pi);
    };
    const double least_Hz = bandwidth_Hz(slowest);
    const double most_Hz = bandwidth_Hz(fastest);
    if (*targets.bandwidth_Hz < least_Hz || *targets.bandwidth_Hz > most_Hz) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a bandwidth of {:.4g} Hz is not possible with this motor at {:.4g} Hz sampling and "
                        "{} samples of delay",
                        *targets.bandwidth_Hz, 1.0 / timing.period_s, timing.delay_samples),
            fmt::format("choose {:.3g} to {:.3g} Hz", least_Hz, most_Hz));
    }
    const double speed = largestFine(
        slowest, fastest, [&](double ratio) { return bandwidth_Hz(ratio) <= *targets.bandwidth_Hz; });
    return withFeedForward(filteredGains(plant, speed), plant);
}

/// K_I/K_P over the crossover of the recommended shape (htm-theory.md 8.4).
constexpr double ShapeIntegralRate_ratio = 1.5 / 45.7;

bool meetsPhaseMargin(const PositionPlant& plant, const LoopTiming& timing, const PidGains& gains,
                      double phaseMargin_deg) {
    constexpr double LeastGainMargin_ratio = 2.0;
    if (gains.proportional <= 0.0 || gains.derivative < 0.0) {
        return false;
    }
    const Quality quality = judge(plant, gains, timing);
    return quality.isStable && quality.margins.gainMargin_ratio >= LeastGainMargin_ratio &&
           std::abs(quality.margins.phaseMargin_deg - phaseMargin_deg) < 0.01;
}

/// Of the crossovers up to the recommended one, the loop with the asked margin that is stiffest: the largest
/// K_P leaves the narrowest friction band. A margin bought with derivative action alone, K_P k well below the
/// square of the crossover, makes a damper and not a position loop, and does not count.
std::optional<PidGains> stiffestWithMargin(const PositionPlant& plant, const LoopTiming& timing,
                                           double slowest_rad_s, double fastest_rad_s, CrossoverAim aim) {
    std::optional<PidGains> best;
    for (double crossover_rad_s = fastest_rad_s; crossover_rad_s >= slowest_rad_s; crossover_rad_s *= 0.98) {
        aim.crossover_rad_s = crossover_rad_s;
        const PidGains gains = gainsAtCrossover(plant, timing, aim);
        const double stiffness_ratio =
            gains.proportional * plant.accelerationGain_rad_s2_A / (crossover_rad_s * crossover_rad_s);
        const bool isStiffer = !best || gains.proportional > best->proportional;
        if (isStiffer && stiffness_ratio >= crossover::LeastStiffness_ratio &&
            meetsPhaseMargin(plant, timing, gains, aim.phaseMargin_deg)) {
            best = gains;
        }
    }
    return best;
}

Result<PositionLaw> designForMargin(const PositionPlant& plant, const LoopTiming& timing,
                                    const DesignTargets& targets, const CrossoverAim& aim) {
    const double fastest_rad_s = targets.omega_rad_s.value_or(0.457 / timing.period_s);
    const double slowest_rad_s = targets.omega_rad_s.value_or(0.005 / timing.period_s);
    const auto gains = stiffestWithMargin(plant, timing, slowest_rad_s, fastest_rad_s, aim);
    if (!gains) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("no position loop on this motor has a phase margin of {:.4g} deg and a gain margin "
                        "of 2{}",
                        aim.phaseMargin_deg,
                        targets.omega_rad_s ? fmt::format(" at {:.4g} rad/s", *targets.omega_rad_s) : ""),
            "use 30 to 60 deg, or omit the crossover");
    }
    return withFeedForward(*gains, plant);
}

Result<PositionLaw> designPhaseMargin(const PositionPlant& plant, const LoopTiming& timing,
                                      const DesignTargets& targets) {
    if (!targets.phaseMargin_deg) {
        return failure(ErrorCode::Usage, "method phase-margin needs a target margin",
                       "add --phase-margin-deg DEG");
    }
    return designForMargin(plant, timing, targets, {0.0, *targets.phaseMargin_deg, ShapeIntegralRate_ratio});
}

/// K_P + K_D is the lead that the board has: its zero at z = K_D/(K_P T + K_D), its pole at z = 0.
Result<PositionLaw> designLead(const PositionPlant& plant, const LoopTiming& timing,
                               const DesignTargets& targets) {
    constexpr double UsualMargin_deg = 45.0;
    return designForMargin(plant, timing, targets,
                           {0.0, targets.phaseMargin_deg.value_or(UsualMargin_deg), 0.0});
}

PositionLaw preset(double proportional, double integral, GainUnit unit) {
    PidGains gains;
    gains.unit = unit;
    gains.proportional = proportional;
    gains.integral = integral;
    PositionLaw law;
    law.gains = *convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    return law;
}

Result<PositionLaw> designPreset(std::string_view method, const PositionPlant& plant,
                                 const LoopTiming& timing) {
    if (method == "published") {
        return preset(10.0, 0.1, GainUnit::PerRadian);
    }
    if (method == "micro-step") {
        return preset(5.0, 0.05, GainUnit::PerDegree);
    }
    if (method == "published-degrees") {
        return preset(10.0, 0.1, GainUnit::PerDegree);
    }
    return designPolePlacement(plant, timing, {});
}

/// Shapes of the books that need a stage of their own behind the law.
bool isFilter(std::string_view name) {
    return name == "notch" || name == "low-pass";
}

Result<DesignMethod> findMethod(std::string_view name) {
    if (isFilter(name)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the device's control law has no {} filter", name),
                       "use a lower crossover against resonance or noise: method bandwidth, or lead");
    }
    std::string known;
    for (const DesignMethod& method : designMethods()) {
        if (method.name == name) {
            return method;
        }
        known += fmt::format("{}{}", known.empty() ? "" : ", ", method.name);
    }
    return failure(ErrorCode::UnknownName, fmt::format("there is no design method '{}'", name),
                   "choose one of: " + known);
}

} // namespace

const std::vector<DesignMethod>& designMethods() {
    static const std::vector<DesignMethod> methods = {
        {"recommended", "", "recommended for this motor"},
        {"pole-placement", "zeta, omega-rad-s",
         "PI with the requested dominant pole pair, as far as the motor's damping allows"},
        {"bandwidth", "bandwidth-hz", "recommended shape with the requested closed-loop bandwidth"},
        {"phase-margin", "phase-margin-deg, omega-rad-s", "stiffest loop with the requested phase margin"},
        {"simc", "bandwidth-hz", "SIMC, the internal-model rule of Skogestad, for lag and dead time"},
        {"lambda", "bandwidth-hz", "lambda tuning: closed loop as a double lag of the requested bandwidth"},
        {"ziegler-nichols", "ultimate-gain, ultimate-period",
         "Ziegler and Nichols, PID, from ultimate gain and period; fast starting point"},
        {"ziegler-nichols-pi", "ultimate-gain, ultimate-period",
         "Ziegler and Nichols, PI, from ultimate gain and period"},
        {"ziegler-nichols-p", "ultimate-gain, ultimate-period",
         "Ziegler and Nichols, P: half of the ultimate gain"},
        {"lqr", "omega-rad-s", "linear-quadratic regulator, weights for the requested frequency"},
        {"min-iae", "max-sensitivity, current-limit-a, step-deg",
         "minimum integral of the absolute error after a load step, with limits on Ms and current"},
        {"min-itae", "max-sensitivity, current-limit-a, step-deg",
         "same with time-weighted error: penalises long-lasting errors"},
        {"lead", "phase-margin-deg, omega-rad-s", "PD (lead) with the requested phase margin"},
        {"lag", "omega-rad-s", "PI (lag) with the requested crossover"},
        {"published", "", "10 A/rad and 0.1 A/(rad s), as printed"},
        {"designed", "", "zeta = 0.06 at 15 rad/s, as intended by the source"},
        {"micro-step", "", "5 A/deg and 0.05 A/(deg s), for steps of a few tenths of a degree"},
        {"published-degrees", "", "printed numbers read per degree; large steps end in a limit cycle"}};
    return methods;
}

bool readsTarget(std::string_view method, std::string_view target) {
    const auto& all = designMethods();
    return std::any_of(all.begin(), all.end(), [&](const DesignMethod& known) {
        return known.name == method && known.targets.find(target) != std::string_view::npos;
    });
}

void addFeedForward(PositionLaw& law, const PositionPlant& plant) {
    // 90 %: over-compensated friction would drive the rotor by itself (htm-theory.md 8.4, sensitivity).
    constexpr double FrictionShare_ratio = 0.9;
    law.inertia_A_s2_rad = 1.0 / plant.accelerationGain_rad_s2_A;
    law.viscous_A_s_rad = plant.dampingRate_1_s / plant.accelerationGain_rad_s2_A;
    law.coulomb_A = FrictionShare_ratio * plant.breakawayCurrent_A;
    law.stictionCurrent_A = FrictionShare_ratio * plant.breakawayCurrent_A;
}

Result<PositionLaw> designLaw(std::string_view method, const PositionPlant& plant, const LoopTiming& timing,
                              const DesignTargets& targets) {
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
    if (method == "recommended") {
        return designRecommended(plant, timing, targets);
    }
    if (method == "pole-placement") {
        return designPolePlacement(plant, timing, targets);
    }
    if (method == "bandwidth") {
        return designBandwidth(plant, timing, targets);
    }
    if (method == "phase-margin") {
        return designPhaseMargin(plant, timing, targets);
    }
    if (method == "lead") {
        return designLead(plant, timing, targets);
    }
    if (const auto rule = designByRule(method, {plant, timing, targets})) {
        return *rule ? Result<PositionLaw>(withFeedForward(**rule, plant)) : failure(rule->error());
    }
    return designPreset(method, plant, timing);
}

} // namespace halbench::control
