#include "models/planar/current_source.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

// Current that goes exponentially to `target` with this rate, over t.
SourceCurrent approach(double current_A, double target_A, double rate_1_s, double t) {
    const double x = rate_1_s * t;
    const double gone = -std::expm1(-x);
    const double away_A = current_A - target_A;
    return {target_A + away_A * (1.0 - gone), target_A + away_A * (x > 0.0 ? gone / x : 1.0)};
}

} // namespace

SourceCurrent stepCurrentSource(const CurrentSourceConfig& config, double current_A, double demand_A,
                                double resistance_Ohm, double induced_V, double step_s) {
    const double target_A =
        std::clamp(demand_A, -config.limit_A, config.limit_A) - induced_V / config.output_Ohm;
    const double stiffness_Ohm = config.inductance_H * config.bandwidth_rad_s;
    const double needed_V = stiffness_Ohm * (target_A - current_A) + resistance_Ohm * current_A + induced_V;
    if (std::fabs(needed_V) <= config.supply_V) {
        return approach(current_A, target_A, config.bandwidth_rad_s, step_s);
    }
    // At the supply until the voltage needed falls below it, at the current i*.
    const double supply_V = std::copysign(config.supply_V, needed_V);
    const double rate_1_s = resistance_Ohm / config.inductance_H;
    const double final_A = (supply_V - induced_V) / resistance_Ohm;
    const double release_A =
        (stiffness_Ohm * target_A + induced_V - supply_V) / (stiffness_Ohm - resistance_Ohm);
    const double ratio = (current_A - final_A) / (release_A - final_A);
    const double slewing_s = ratio > 1.0 ? std::min(std::log(ratio) / rate_1_s, step_s) : step_s;
    const SourceCurrent slewing = approach(current_A, final_A, rate_1_s, slewing_s);
    if (slewing_s >= step_s) {
        return slewing;
    }
    const SourceCurrent rest =
        approach(slewing.atEnd_A, target_A, config.bandwidth_rad_s, step_s - slewing_s);
    return {rest.atEnd_A, (slewing.mean_A * slewing_s + rest.mean_A * (step_s - slewing_s)) / step_s};
}

} // namespace halbench::models
