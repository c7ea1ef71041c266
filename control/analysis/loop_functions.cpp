#include "control/analysis/loop_functions.h"

#include "control/analysis/frequency_scan.h"
#include "control/analysis/loop_scan.h"

#include <cmath>

namespace halbench::control {

Result<LoopFunctions> loopFunctions(const TransferFunction& plant, const TransferFunction& controller) {
    const auto base = commonTimeBase(plant.timeBase(), controller.timeBase());
    if (!base) {
        return failure(base.error());
    }
    const Polynomial open = multiply(plant.denominator(), controller.denominator());
    const Polynomial loop = multiply(plant.numerator(), controller.numerator());
    const Polynomial closed = add(open, loop);
    if (degree(closed) < degree(open)) {
        return failure(ErrorCode::InvalidInput, "the feedback closes an algebraic loop with 1 + L = 0");
    }
    const auto over = [&](const Polynomial& numerator) {
        return TransferFunction::make(numerator, closed, *base);
    };
    const auto S = over(open);
    const auto PS = over(multiply(plant.numerator(), controller.denominator()));
    const auto CS = over(multiply(controller.numerator(), plant.denominator()));
    const auto T = over(loop);
    for (const auto* function : {&S, &PS, &CS, &T}) {
        if (!*function) {
            return failure(function->error());
        }
    }
    return LoopFunctions{*S, *PS, *CS, *T};
}

ResponsePeak peakMagnitude(const TransferFunction& system) {
    const auto negative = [&system](double w) { return -std::abs(system.atFrequency(w)); };
    const std::vector<double> frequencies = scanFrequencies(system);
    const double frequency_rad_s = scanMinimum(negative, frequencies);
    ResponsePeak peak{std::abs(system.atFrequency(frequency_rad_s)), frequency_rad_s};
    // The ends of the curve, which no grid holds; an integrator has no value at rest.
    const double rest = std::abs(system.dcGain());
    if (std::isfinite(rest) && rest > peak.magnitude_ratio) {
        peak = {rest, frequencies.front()};
    }
    const double direct = std::abs(system.numerator().front() / system.denominator().front());
    if (system.timeBase().isContinuous() && degree(system.numerator()) == system.order() &&
        direct > peak.magnitude_ratio) {
        peak = {direct, frequencies.back()};
    }
    return peak;
}

std::optional<double> bandwidth_rad_s(const TransferFunction& closedLoop) {
    const double level = std::abs(closedLoop.dcGain()) / std::sqrt(2.0);
    const auto excess = [&](double w) { return std::abs(closedLoop.atFrequency(w)) - level; };
    const std::vector<double> frequencies = scanFrequencies(closedLoop);
    for (std::size_t i = 1; i < frequencies.size(); ++i) {
        if (excess(frequencies[i]) < 0.0) {
            return rootBetween(excess, frequencies[i - 1], frequencies[i]);
        }
    }
    return std::nullopt;
}

std::optional<double> closedBandwidth_rad_s(const DeltaSystem& openLoop) {
    const double rest = openLoop.dcGain();
    const double level = (std::isfinite(rest) ? std::abs(rest / (1.0 + rest)) : 1.0) / std::sqrt(2.0);
    const auto magnitude = [&](double w) { return 1.0 / std::abs(1.0 + 1.0 / openLoop.atFrequency(w)); };
    // Between the points of the open loop lie lightly damped closed poles, which raise |T| and do not end it.
    const LoopScan scan = scanLoop(openLoop);
    for (std::size_t i = 1; i < scan.value.size(); ++i) {
        if (scan.value[i] == 0.0 || 1.0 / std::abs(1.0 + 1.0 / scan.value[i]) < level) {
            return rootBetween([&](double w) { return magnitude(w) - level; }, scan.frequency_rad_s[i - 1],
                               scan.frequency_rad_s[i]);
        }
    }
    return std::nullopt;
}

} // namespace halbench::control
