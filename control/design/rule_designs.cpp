#include "control/design/rule_designs.h"

#include "control/base/units.h"
#include "control/law/board_gains.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

namespace halbench::control {

namespace {

/// What a rule promises holds on the board, or it is refused.
Result<PidGains> stableOnBoard(const RuleProblem& problem, const Result<PidGains>& gains,
                               const char* remedy) {
    const auto board = gains ? boardGains(*gains) : gains;
    if (!board) {
        return board;
    }
    const auto loop = sampledOpenLoop(problem.plant, *board, problem.timing);
    if (!loop) {
        return failure(loop.error());
    }
    if (const double radius = poleRadius(*loop); radius >= 1.0) {
        return failure(
            ErrorCode::Refused,
            fmt::format("the gains of this rule, K_P = {:.4g} A/rad, K_I = {:.4g} A/(rad s) and "
                        "K_D = {:.4g} A s/rad, are unstable in the sampled loop: pole radius {:.4f}",
                        board->proportional, board->integral, board->derivative, radius),
            remedy);
    }
    return board;
}

Result<LaggedProcess> processOf(const RuleProblem& problem) {
    auto process = laggedProcess(problem.plant, problem.timing);
    if (!process) {
        return failure(ErrorCode::OutOfRange, "this rule needs a motor with damping: c/J = 0 in its model",
                       "use method bandwidth, phase-margin or lqr");
    }
    process->deadTime_s += 0.5 * problem.timing.period_s;
    return process;
}

/// The time constant of a closed loop that falls by 3 dB at the asked bandwidth, were it a single lag.
double closedTime_s(const RuleProblem& problem, double otherwise_s) {
    return problem.targets.bandwidth_Hz ? 1.0 / (2.0 * Pi * *problem.targets.bandwidth_Hz) : otherwise_s;
}

/// No design of these asks for a limit: nothing is that large.
constexpr double NoCurrentLimit_A = 1e9;

Result<PidGains> designSimc(const RuleProblem& problem) {
    const auto process = processOf(problem);
    if (!process) {
        return failure(process.error());
    }
    return stableOnBoard(problem, simcGains(*process, closedTime_s(problem, process->deadTime_s)),
                         "use a lower bandwidth");
}

Result<PidGains> designLambda(const RuleProblem& problem) {
    const auto process = processOf(problem);
    if (!process) {
        return failure(process.error());
    }
    constexpr double UsualShare_ratio = 3.0; // lambda of three dead times: Ms of 1.6
    const double lambda_s = closedTime_s(problem, UsualShare_ratio * process->deadTime_s);
    return stableOnBoard(problem, lambdaGains(*process, lambda_s), "use a lower bandwidth");
}

/// As it was measured, otherwise as the model says.
Result<UltimatePoint> ultimateOf(const RuleProblem& problem) {
    const DesignTargets& measured = problem.targets;
    if (measured.ultimateGain_A_per_rad && measured.ultimatePeriod_s) {
        return UltimatePoint{*measured.ultimateGain_A_per_rad, *measured.ultimatePeriod_s};
    }
    PidGains unit;
    unit.proportional = 1.0;
    const auto loop = sampledOpenLoop(problem.plant, unit, problem.timing);
    return loop ? ultimatePoint(*loop) : failure(loop.error());
}

Result<PidGains> designZieglerNichols(const RuleProblem& problem, ControllerKind kind) {
    const auto ultimate = ultimateOf(problem);
    if (!ultimate) {
        return failure(ultimate.error());
    }
    return stableOnBoard(problem, zieglerNicholsGains(*ultimate, kind),
                         "this rule gives little damping: use method recommended, bandwidth or phase-margin");
}

/// Weights of error and current for the asked natural frequency: on k/s^2 alone it would be just that.
Result<PidGains> designLqr(const RuleProblem& problem) {
    RegulatorTargets weights;
    constexpr double UsualError_deg = 2.0;
    weights.angle_rad = degreesToRadians(UsualError_deg);
    weights.current_A = 1.0;
    if (const auto& omega_rad_s = problem.targets.omega_rad_s) {
        // w^4 = k^2 q/r for k/s^2, with q = 1/angle^2 and r = 1/current^2.
        weights.angle_rad =
            weights.current_A * problem.plant.accelerationGain_rad_s2_A / (*omega_rad_s * *omega_rad_s);
    }
    const auto design = designRegulator(problem.plant, problem.timing, weights, NoCurrentLimit_A);
    return design ? Result<PidGains>(design->gains) : failure(design.error());
}

Result<PidGains> designLeast(const RuleProblem& problem, ErrorMeasure measure) {
    const auto design =
        designLeastError(problem.plant, problem.timing, leastErrorTargets(measure, problem.targets),
                         problem.targets.currentLimit_A.value_or(NoCurrentLimit_A));
    return design ? Result<PidGains>(design->gains) : failure(design.error());
}

/// PI through the asked crossover with its corner a decade below.
Result<PidGains> designLag(const RuleProblem& problem) {
    constexpr double Corner_ratio = 0.1; // costs 5.7 degrees at the crossover
    // Twice the motor's own corner: beyond it the phase that the motor leaves falls as a/w.
    const double crossover_rad_s = problem.targets.omega_rad_s.value_or(2.0 * problem.plant.dampingRate_1_s);
    if (crossover_rad_s <= 0.0) {
        return failure(ErrorCode::OutOfRange, "this rule needs a motor with damping: c/J = 0 in its model",
                       "use method bandwidth, phase-margin or lqr");
    }
    PidGains gains;
    gains.proportional = 1.0;
    gains.integral = Corner_ratio * crossover_rad_s;
    const auto loop = sampledOpenLoop(problem.plant, gains, problem.timing);
    if (!loop) {
        return failure(loop.error());
    }
    const double scale = 1.0 / std::abs(loop->atFrequency(crossover_rad_s));
    gains.proportional *= scale;
    gains.integral *= scale;
    return stableOnBoard(problem, gains, "use a lower crossover, or method lead or phase-margin");
}

} // namespace

std::optional<Result<PidGains>> designByRule(std::string_view method, const RuleProblem& problem) {
    const std::map<std::string_view, std::function<Result<PidGains>()>> rules = {
        {"simc", [&] { return designSimc(problem); }},
        {"lambda", [&] { return designLambda(problem); }},
        {"ziegler-nichols", [&] { return designZieglerNichols(problem, ControllerKind::Pid); }},
        {"ziegler-nichols-pi", [&] { return designZieglerNichols(problem, ControllerKind::Pi); }},
        {"ziegler-nichols-p", [&] { return designZieglerNichols(problem, ControllerKind::P); }},
        {"lqr", [&] { return designLqr(problem); }},
        {"min-iae", [&] { return designLeast(problem, ErrorMeasure::Iae); }},
        {"min-itae", [&] { return designLeast(problem, ErrorMeasure::Itae); }},
        {"lag", [&] { return designLag(problem); }}};
    const auto found = rules.find(method);
    return found == rules.end() ? std::nullopt : std::optional(found->second());
}

} // namespace halbench::control
