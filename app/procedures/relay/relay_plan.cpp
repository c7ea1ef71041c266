#include "app/procedures/relay/relay_plan.h"

#include "app/procedures/base/checked_range.h"
#include "app/procedures/identify/identify_plan.h"
#include "control/assess/loop_rows.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/robustness/robustness.h"
#include "models/htm/htm_ideal_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double SlowestBase_rad_s = 3.0;  // below it friction is no plain offset (help: htm-theory.md 7.4)
constexpr double LeastSpeed_ratio = 0.4;   // of the base speed that the rotor keeps
constexpr double MostSpeed_ratio = 0.8;    // of the speed limit
constexpr double LeastAmplitude_rad = 0.1; // the sensors' errors are a tenth of it
constexpr double Saturation_ratio = 1.5;   // K_P over K_u: swings, and switches over several samples
constexpr double Weave_ratio = 0.1;        // of the speed; the cycle then cannot stay with the turn
constexpr double Weaves = 3.0;             // in the measured time
constexpr double LeastRunUp_s = 5.0;
constexpr double RunUpCycles = 15.0;

double fastestBase_rad_s(const RelayConfig& config) {
    return 0.5 * config.speedLimit_rad_s;
}

Result<void> checkConfig(const RelayConfig& config, const RelayBoard& board) {
    Result<void> valid =
        checkRange("speed limit in rad/s", config.speedLimit_rad_s, 2.0 * SlowestBase_rad_s, 1e4);
    valid = valid ? checkRange("number of cycles", config.cycles, 40, 400) : valid;
    if (valid && config.base_rad_s) {
        valid = checkRange("base speed in rad/s", std::abs(*config.base_rad_s), SlowestBase_rad_s,
                           fastestBase_rad_s(config));
    }
    if (valid && config.limit_A) {
        valid = checkRange("relay amplitude in A", *config.limit_A, 0.01, board.currentLimit_A);
    }
    return valid && config.gain_A_per_rad
               ? checkRange("relay gain in A/rad", *config.gain_A_per_rad, 0.01, 2000)
               : valid;
}

MotorEstimate publishedMotor() {
    const PilotEstimate nominal = nominalMotor();
    MotorEstimate motor;
    motor.values = {{"c_over_J", nominal.damping_per_s},
                    {"phi_over_J", nominal.torque_rad_s2_A},
                    {"Kf_over_J", nominal.friction_rad_s2}};
    return motor;
}

control::SampledPlantModel rotorOf(const control::PositionPlant& plant, double lag_s) {
    return {plant.dampingRate_1_s, plant.accelerationGain_rad_s2_A, lag_s, 0.0};
}

/// The motor under the relay, from rest, on a plain ramp.
struct Swing {
    double lowest_rad_s = 0.0;
    double highest_rad_s = 0.0;
    double peak_rad_s = 0.0;
    double meanSquare_A2 = 0.0; ///< of the amplitude
    std::optional<control::LimitCyclePoint> cycle;
};

models::IdealTrace simulated(const control::PositionPlant& plant, const RelayPlan& plan,
                             const RelayBoard& board, double base_rad_s, double duration_s) {
    // Motion depends on the ratios alone, so the motor may as well have an inertia of 1.
    models::IdealLoopConfig config;
    config.rotor.inertia_kg_m2 = 1.0;
    config.rotor.viscousDamping_Nm_s = plant.dampingRate_1_s;
    config.rotor.coulombFriction_Nm = plant.breakawayCurrent_A * plant.accelerationGain_rad_s2_A;
    config.torqueConstant_Nm_per_A = plant.accelerationGain_rad_s2_A;
    config.law.kp_A_per_rad = plan.gain_A_per_rad;
    config.law.ki_A_per_rad_s = 0.0;
    config.law.limit_A = plan.limit_A;
    config.law.period_s = board.period_s;
    config.law.delaySamples = board.delaySamples;
    config.reference.shape = control::LoopReference::Shape::Ramp;
    config.reference.rate_rad_s = base_rad_s;
    config.duration_s = duration_s;
    return models::runIdealLoop(config);
}

Swing swingOf(const control::PositionPlant& plant, const RelayPlan& plan, const RelayBoard& board,
              double base_rad_s) {
    constexpr double Cycles = 24.0;
    const double cycle_s = 2.0 * Pi / plan.predicted.at.frequency_rad_s;
    const models::IdealTrace trace =
        simulated(plant, plan, board, base_rad_s, plan.runUp_s + 1.5 * Cycles * cycle_s);
    Swing swing;
    swing.lowest_rad_s = base_rad_s;
    std::vector<double> reference, current, angle;
    // Of the simulation's rows, at most 1 ms apart, one in 4 ms shows the cycle.
    constexpr double Shown_s = 4e-3;
    const double row_s = control::LoopRows(board.period_s).interval_s();
    const auto rowStep = static_cast<std::size_t>(std::max(1L, std::lround(Shown_s / row_s)));
    const double step_s = row_s * static_cast<double>(rowStep);
    for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
        swing.peak_rad_s = std::max(swing.peak_rad_s, trace.speed_rad_s[i]);
        if (trace.time_s[i] < plan.runUp_s) {
            continue;
        }
        swing.lowest_rad_s = std::min(swing.lowest_rad_s, trace.speed_rad_s[i]);
        swing.highest_rad_s = std::max(swing.highest_rad_s, trace.speed_rad_s[i]);
        if (i % rowStep == 0) {
            reference.push_back(trace.reference_rad[i]);
            current.push_back(trace.current_A[i]);
            angle.push_back(trace.angle_rad[i]);
            swing.meanSquare_A2 += trace.current_A[i] * trace.current_A[i];
        }
    }
    swing.meanSquare_A2 /= static_cast<double>(std::max<std::size_t>(current.size(), 1));
    const auto cycle = control::estimateLimitCycle({step_s, reference, current, angle});
    swing.cycle = cycle ? std::optional(*cycle) : std::nullopt;
    return swing;
}

std::vector<double> basesOf(const RelayConfig& config) {
    if (config.base_rad_s) {
        return {std::abs(*config.base_rad_s)};
    }
    std::vector<double> bases;
    constexpr double Step_rad_s = 0.5;
    for (double base = SlowestBase_rad_s; base <= fastestBase_rad_s(config) + 1e-9; base += Step_rad_s) {
        bases.push_back(base);
    }
    return bases;
}

std::vector<double> heightsOf(const RelayConfig& config, const RelayBoard& board) {
    if (config.limit_A) {
        return {*config.limit_A};
    }
    std::vector<double> heights;
    for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6, 0.5}) {
        heights.push_back(share * board.currentLimit_A);
    }
    return heights;
}

bool isSafe(const Swing& slow, const Swing& fast, double slow_rad_s, const RelayConfig& config) {
    return slow.lowest_rad_s >= LeastSpeed_ratio * slow_rad_s && slow.cycle && fast.cycle &&
           fast.peak_rad_s <= MostSpeed_ratio * config.speedLimit_rad_s &&
           std::min(slow.cycle->amplitude, fast.cycle->amplitude) >= LeastAmplitude_rad;
}

/// The largest safe swing at one base speed.
bool takeHighest(RelayPlan& plan, const control::PositionPlant& plant, const RelayConfig& config,
                 const RelayBoard& board, double base_rad_s) {
    bool isFound = false;
    for (const double height_A : heightsOf(config, board)) {
        RelayPlan tried = plan;
        tried.limit_A = height_A;
        const double slow_rad_s = (1.0 - tried.weave_ratio) * base_rad_s;
        const Swing slow = swingOf(plant, tried, board, slow_rad_s);
        if (slow.lowest_rad_s < LeastSpeed_ratio * slow_rad_s) {
            continue;
        }
        const Swing fast = swingOf(plant, tried, board, (1.0 + tried.weave_ratio) * base_rad_s);
        if (!isSafe(slow, fast, slow_rad_s, config) ||
            (isFound && slow.cycle->amplitude <= plan.predicted.amplitude_rad)) {
            continue;
        }
        isFound = true;
        plan.limit_A = height_A;
        plan.turn_rad_s = base_rad_s;
        plan.meanSquare_A2 = 0.5 * std::max(slow.meanSquare_A2, fast.meanSquare_A2); // a phase has half of it
        plan.predicted.period_s = 2.0 * Pi / slow.cycle->frequency_rad_s;
        plan.predicted.amplitude_rad = slow.cycle->amplitude;
        plan.predicted.lowest_rad_s = slow.lowest_rad_s;
        plan.predicted.highest_rad_s = fast.highest_rad_s;
        plan.predicted.peak_rad_s = fast.peak_rad_s;
    }
    return isFound;
}

tl::unexpected<Error> noSafeSwing(const RelayConfig& config) {
    return failure(ErrorCode::OutOfRange,
                   config.base_rad_s
                       ? fmt::format("at a base speed of {:.3g} rad/s no relay gives an oscillation of "
                                     "{:.2g} rad without nearing standstill or {:.3g} rad/s",
                                     *config.base_rad_s, LeastAmplitude_rad,
                                     MostSpeed_ratio * config.speedLimit_rad_s)
                       : fmt::format("no base speed from {:.3g} to {:.3g} rad/s allows an oscillation of "
                                     "{:.2g} rad without nearing standstill",
                                     SlowestBase_rad_s, fastestBase_rad_s(config), LeastAmplitude_rad),
                   "omit base speed and relay amplitude, allow a higher speed or more current, or use the "
                   "model of this motor");
}

} // namespace

Result<RelayPlan> planRelay(const RelayConfig& config, const RelayBoard& board) {
    if (auto valid = checkConfig(config, board); !valid) {
        return failure(valid.error());
    }
    const MotorEstimate motor = config.motor.value_or(publishedMotor());
    const auto plant = plantFromEstimate(motor);
    if (!plant) {
        return failure(plant.error());
    }
    const auto at =
        control::ultimateGain(rotorOf(*plant, config.actuatorLag_s), board.period_s, board.delaySamples);
    if (!at) {
        return failure(at.error());
    }
    RelayPlan plan;
    plan.predicted.at = *at;
    plan.predicted.isOfThisMotor = config.motor.has_value();
    plan.gain_A_per_rad = config.gain_A_per_rad.value_or(Saturation_ratio * at->gain);
    plan.runUp_s = std::max(LeastRunUp_s, RunUpCycles * 2.0 * Pi / at->frequency_rad_s);
    plan.weave_ratio = Weave_ratio;
    for (const double base_rad_s : basesOf(config)) {
        if (takeHighest(plan, *plant, config, board, base_rad_s)) {
            plan.turn_rad_s = std::copysign(plan.turn_rad_s, config.base_rad_s.value_or(1.0));
            plan.measured_s = config.cycles * plan.predicted.period_s;
            plan.weave_Hz = Weaves / plan.measured_s;
            return plan;
        }
    }
    return noSafeSwing(config);
}

std::optional<std::pair<double, double>> foreseenGain95(const RelayConfig& config, const RelayBoard& board) {
    constexpr int Draws = 1000;
    if (!config.motor || config.motor->covariance.empty()) {
        return std::nullopt;
    }
    const auto uncertain = uncertainPlantFromEstimate(*config.motor);
    if (!uncertain) {
        return std::nullopt;
    }
    const auto plants = control::drawPlants(*uncertain, Draws, Random(1));
    std::vector<double> gains;
    for (std::size_t i = 0; plants && i < plants->size(); ++i) {
        const auto at = control::ultimateGain(rotorOf((*plants)[i], config.actuatorLag_s), board.period_s,
                                              board.delaySamples);
        gains.push_back(at ? at->gain : 0.0);
    }
    if (gains.empty()) {
        return std::nullopt;
    }
    std::sort(gains.begin(), gains.end());
    const auto last = static_cast<double>(gains.size() - 1);
    return std::pair(gains[static_cast<std::size_t>(0.025 * last)],
                     gains[static_cast<std::size_t>(0.975 * last)]);
}

} // namespace halbench::app
