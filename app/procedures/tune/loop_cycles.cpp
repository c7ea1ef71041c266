#include "app/procedures/tune/loop_cycles.h"

#include "control/assess/friction_cycles.h"
#include "control/base/units.h"
#include "control/law/board_gains.h"
#include "control/law/filtered_delta.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace halbench::app {

std::optional<std::vector<PredictedCycle>>
predictCycles(const control::PositionPlant& plant, const LoopLaw& law, const LoopConditions& conditions) {
    if (law.law.stictionCurrent_A > 0.0 || plant.breakawayCurrent_A <= 0.0) {
        return std::nullopt;
    }
    const double period_s = conditions.timing.period_s;
    const auto controller = control::deltaController(asFiltered(law), period_s);
    if (!controller) {
        return std::nullopt;
    }
    const auto cycles =
        control::frictionCycles(plant, *controller, conditions.timing, conditions.currentLimit_A);
    if (!cycles) {
        return std::nullopt;
    }
    std::vector<PredictedCycle> result;
    for (const control::LimitCycle& cycle : *cycles) {
        result.push_back({cycle.amplitude, cycle.frequency_rad_s / (2.0 * Pi), cycle.isStable});
    }
    return result;
}

std::optional<Finding> cycleWarning(const std::vector<PredictedCycle>& cycles) {
    const auto swing = std::find_if(cycles.begin(), cycles.end(),
                                    [](const PredictedCycle& cycle) { return cycle.isStable; });
    if (swing == cycles.end()) {
        return std::nullopt;
    }
    const std::string from =
        swing == cycles.begin()
            ? std::string("any motion")
            : fmt::format("an oscillation above +-{:.2g} deg", radiansToDegrees((swing - 1)->amplitude_rad));
    return Finding{"limit_cycle",
                   fmt::format("{} grows into a limit cycle of about +-{:.2g} deg at {:.2g} Hz", from,
                               radiansToDegrees(swing->amplitude_rad), swing->frequency_Hz),
                   "use small steps only, or a smaller K_P"};
}

double releaseTime_s(const control::PositionPlant& plant, const control::PositionLaw& law,
                     double frictionBand_rad) {
    const auto gains = control::boardGains(law.gains);
    const double error_rad = 0.5 * frictionBand_rad;
    if (!gains || !(gains->integral * error_rad > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    control::PositionPlant rest = plant;
    rest.breakawayCurrent_A -= error_rad > law.stictionThreshold_rad ? law.stictionCurrent_A : 0.0;
    return control::breakLooseTime_s(rest, *gains, error_rad);
}

} // namespace halbench::app
