#include "app/procedures/identify_plan.h"

#include "control/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

// After a jump of seven times the new speed e^-9 leaves 0.1 % of it; 7 would leave the slow plateaus
// unsteady.
constexpr double SettleTimes = 9.0;
constexpr double SteadinessWindows_s = 2.1; // two windows of 1 s and the samples at their ends
constexpr double LongestDwell_s = 15.0;
constexpr double LoneRunUp_s = 2.0; // without a sweep the run-ups alone must bend enough to show c/J
constexpr double SpeedShare = 0.9;  // of the limit that a plateau may reach
constexpr double GuardShare = 0.95; // of the limit at which a run is ended

double runUpSpeed_rad_s(const PilotEstimate& pilot, double current_A, double duration_s) {
    const double start = pilot.torque_rad_s2_A * current_A - pilot.friction_rad_s2;
    const double x = pilot.damping_per_s * duration_s;
    return x > 1e-6 ? start / pilot.damping_per_s * -std::expm1(-x) : start * duration_s;
}

void shuffle(std::vector<double>& values, Random& random) {
    for (std::size_t i = values.size(); i > 1; --i) {
        std::swap(values[i - 1], values[static_cast<std::size_t>(random.below(i))]);
    }
}

PlateauRun sweepRun(const std::vector<double>& currents, double sign, double dwell_s, Random& random) {
    std::vector<double> order(currents.begin(), currents.end() - 1);
    shuffle(order, random);
    PlateauRun run;
    run.currents_A.push_back(sign * currents.back()); // from rest, well above the static friction
    for (const double current : order) {
        run.currents_A.push_back(sign * current);
    }
    run.currents_A.push_back(sign * currents.back());
    run.currents_A.push_back(0.0);
    run.dwell_s = dwell_s;
    run.text = sign > 0.0 ? "sweep forward" : "sweep reverse";
    return run;
}

// As fast as this dwell makes it, but below the speed limit; the coast-down takes no longer than that.
PlateauRun coastRun(const IdentifyConfig& config, const std::vector<double>& currents, double sign,
                    const PilotEstimate& pilot, double dwell_s) {
    PlateauRun run;
    run.dwell_s = dwell_s;
    const double limit = 0.8 * config.speedLimit_rad_s;
    while (run.dwell_s > 0.2 && runUpSpeed_rad_s(pilot, currents.back(), run.dwell_s) > limit) {
        run.dwell_s -= 0.05;
    }
    for (int i = 0; i < config.coastDownsPerDirection; ++i) {
        run.currents_A.push_back(sign * currents.back());
        run.currents_A.push_back(0.0);
    }
    run.text = sign > 0.0 ? "coast-downs forward" : "coast-downs reverse";
    return run;
}

} // namespace

double PilotEstimate::steadySpeed_rad_s(double current_A) const {
    const double drive = torque_rad_s2_A * current_A - friction_rad_s2;
    return damping_per_s > 0.0 ? drive / damping_per_s : std::numeric_limits<double>::infinity();
}

PilotEstimate nominalMotor() {
    // resources/help/htm-theory.md section 2: a, f, k
    return {2.236364, 37.2727, 26.0, 0.0};
}

std::vector<double> admissibleCurrents_A(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                         const PilotEstimate& pilot) {
    std::vector<double> admissible;
    for (const double current : currents_A) {
        if (pilot.steadySpeed_rad_s(current) <= SpeedShare * config.speedLimit_rad_s) {
            admissible.push_back(current);
        }
    }
    return admissible;
}

std::vector<PlateauRun> planRuns(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                 const PilotEstimate& pilot) {
    const double settle_s = SettleTimes / std::max(pilot.damping_per_s, 1e-6);
    const std::vector<double> admissible = admissibleCurrents_A(config, currents_A, pilot);
    constexpr std::size_t FewestCurrents = 3;
    const bool canSweep =
        admissible.size() >= FewestCurrents && settle_s + SteadinessWindows_s <= LongestDwell_s;
    std::vector<PlateauRun> runs;
    Random random = Random(config.seed).fork(1);
    for (const double sign : {1.0, -1.0}) {
        if ((sign > 0.0 && config.directions == SweepDirections::Reverse) ||
            (sign < 0.0 && config.directions == SweepDirections::Forward)) {
            continue;
        }
        if (canSweep) {
            runs.push_back(sweepRun(admissible, sign, settle_s + SteadinessWindows_s, random));
        }
        if (config.coastDownsPerDirection > 0) {
            runs.push_back(coastRun(config, currents_A, sign, pilot, canSweep ? 1.0 : LoneRunUp_s));
        }
    }
    for (PlateauRun& run : runs) {
        run.mayReach_rad_s = GuardShare * config.speedLimit_rad_s;
    }
    return runs;
}

} // namespace halbench::app
