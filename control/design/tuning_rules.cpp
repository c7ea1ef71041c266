#include "control/design/tuning_rules.h"

#include "control/analysis/describing_function.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

constexpr double Never_s = std::numeric_limits<double>::infinity();

Result<void> check(const LaggedProcess& process, double closedTime_s) {
    for (const double value :
         {process.gain, process.timeConstant_s, process.secondTime_s, process.deadTime_s, closedTime_s}) {
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite, "a constant of the process model is not a finite number");
        }
    }
    const bool hasLag = process.isIntegrating || process.timeConstant_s > 0.0;
    if (process.gain == 0.0 || !hasLag || process.secondTime_s < 0.0 || process.deadTime_s < 0.0 ||
        closedTime_s < 0.0 || closedTime_s + process.deadTime_s <= 0.0) {
        return failure(ErrorCode::OutOfRange,
                       "this tuning rule needs a process with a gain and a lag, and a time to close in");
    }
    return {};
}

PidGains gainsOf(PidForm form, double K, double integralTime_s, double derivativeTime_s) {
    PidGains gains;
    gains.form = form;
    gains.proportional = K;
    gains.integral = integralTime_s;
    gains.derivative = derivativeTime_s;
    return gains;
}

} // namespace

Result<LaggedProcess> laggedProcess(const PositionPlant& plant, const LoopTiming& timing) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    if (plant.dampingRate_1_s == 0.0) {
        return failure(ErrorCode::OutOfRange,
                       "this tuning rule needs a process with a gain and a lag, and a time to close in");
    }
    return LaggedProcess{plant.accelerationGain_rad_s2_A / plant.dampingRate_1_s, 0.0,
                         1.0 / plant.dampingRate_1_s, (0.5 + timing.delay_samples) * timing.period_s, true};
}

Result<PidGains> simcGains(const LaggedProcess& process, double closedTime_s) {
    if (const auto valid = check(process, closedTime_s); !valid) {
        return failure(valid.error());
    }
    const double total_s = closedTime_s + process.deadTime_s;
    const double slow_s = 4.0 * total_s;
    const double integralTime_s = process.isIntegrating ? slow_s : std::min(process.timeConstant_s, slow_s);
    const double perGain = process.isIntegrating ? 1.0 : process.timeConstant_s;
    // A long second lag acts as 1/(secondTime s) where the loop closes.
    const double lagShare = std::max(1.0, process.secondTime_s / slow_s);
    return gainsOf(PidForm::Series, lagShare * perGain / (process.gain * total_s), integralTime_s,
                   std::min(process.secondTime_s, slow_s));
}

Result<PidGains> lambdaGains(const LaggedProcess& process, double lambda_s) {
    if (const auto valid = check(process, lambda_s); !valid) {
        return failure(valid.error());
    }
    const double closing_s = lambda_s + process.deadTime_s;
    if (process.isIntegrating) {
        const double twice_s = lambda_s + closing_s;
        const double integralTime_s = twice_s + process.secondTime_s;
        return gainsOf(PidForm::Standard, integralTime_s / (process.gain * closing_s * closing_s),
                       integralTime_s, twice_s * process.secondTime_s / integralTime_s);
    }
    return gainsOf(PidForm::Standard, process.timeConstant_s / (process.gain * closing_s),
                   process.timeConstant_s, 0.0);
}

Result<UltimatePoint> ultimatePoint(const TransferFunction& plant) {
    for (const Crossing& crossing : allCrossings(plant)) {
        if (crossing.kind == Crossing::Kind::Phase) {
            return UltimatePoint{crossing.gainMargin_ratio, 2.0 * Pi / crossing.frequency_rad_s};
        }
    }
    return failure(ErrorCode::Refused,
                   "this process does not oscillate under proportional control: no ultimate gain",
                   "use SIMC or pole placement");
}

Result<UltimatePoint> ultimatePoint(double level, double hysteresis, double amplitude, double period_s) {
    const bool isExperiment = level > 0.0 && hysteresis >= 0.0 && amplitude > hysteresis && period_s > 0.0 &&
                              std::isfinite(level * amplitude * period_s);
    if (!isExperiment) {
        return failure(
            ErrorCode::OutOfRange,
            "a relay experiment needs a level, a period and an oscillation larger than its hysteresis");
    }
    return UltimatePoint{
        std::abs(relayGain(std::sqrt(amplitude * amplitude - hysteresis * hysteresis), level)), period_s};
}

PidGains zieglerNicholsGains(const UltimatePoint& ultimate, ControllerKind kind) {
    switch (kind) {
    case ControllerKind::Pi:
        return gainsOf(PidForm::Standard, 0.45 * ultimate.gain, ultimate.period_s / 1.2, 0.0);
    case ControllerKind::Pid:
        return gainsOf(PidForm::Standard, 0.6 * ultimate.gain, 0.5 * ultimate.period_s,
                       0.125 * ultimate.period_s);
    case ControllerKind::P:
        break;
    }
    return gainsOf(PidForm::Standard, 0.5 * ultimate.gain, Never_s, 0.0);
}

} // namespace halbench::control
