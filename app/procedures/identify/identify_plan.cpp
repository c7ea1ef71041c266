#include "app/procedures/identify/identify_plan.h"

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
constexpr double SpeedShare = 0.8;  // of the limit that a plateau may reach
constexpr double CoastShare = 0.75; // of the limit that a short run-up may reach
constexpr double LowShare = 0.3;    // of the highest speed at which a sweep that had to be fitted begins
constexpr double SlowShare = 1.5;   // of the usable speed, so that the pilot's error does not leave it
constexpr double GuardShare = 0.9;  // of the limit at which a run is ended

/// Speed after some time under a constant current, of a rotor that turns that way already and stops at rest.
double speedAfter_rad_s(const PilotEstimate& pilot, double start_rad_s, double current_A, double duration_s) {
    const double drive_rad_s2 = pilot.torque_rad_s2_A * current_A - pilot.friction_rad_s2;
    const double x = pilot.damping_per_s * duration_s;
    const double grown = x > 1e-6 ? -std::expm1(-x) / pilot.damping_per_s : duration_s;
    return std::max(start_rad_s * std::exp(-x) + drive_rad_s2 * grown, 0.0);
}

double fastest_rad_s(const PilotEstimate& pilot, double current_A, int pairs, double dwell_s) {
    double speed_rad_s = 0.0;
    double fastest = 0.0;
    for (int i = 0; i < pairs; ++i) {
        speed_rad_s = speedAfter_rad_s(pilot, speed_rad_s, current_A, dwell_s);
        fastest = std::max(fastest, speed_rad_s);
        speed_rad_s = speedAfter_rad_s(pilot, speed_rad_s, 0.0, dwell_s);
    }
    return fastest;
}

/// The current of a steady speed.
double steadyCurrent_A(const PilotEstimate& pilot, double speed_rad_s) {
    return (pilot.friction_rad_s2 + pilot.damping_per_s * speed_rad_s) / pilot.torque_rad_s2_A;
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

} // namespace

double PilotEstimate::steadySpeed_rad_s(double current_A) const {
    const double drive = torque_rad_s2_A * current_A - friction_rad_s2;
    return damping_per_s > 0.0 ? drive / damping_per_s : std::numeric_limits<double>::infinity();
}

PilotEstimate nominalMotor() {
    // resources/help/htm-theory.md section 2: a, f, k
    return {2.236364, 37.2727, 26.0, 0.0};
}

std::vector<double> suitedCurrents_A(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                     const PilotEstimate& pilot) {
    const double most_rad_s = SpeedShare * config.speedLimit_rad_s;
    const double least_rad_s = SlowShare * config.usableSpeed_rad_s;
    const auto usable = std::count_if(currents_A.begin(), currents_A.end(), [&](double current) {
        return pilot.steadySpeed_rad_s(current) >= config.usableSpeed_rad_s;
    });
    const bool isSlow = 2 * usable < static_cast<std::ptrdiff_t>(currents_A.size());
    const bool isFast = pilot.steadySpeed_rad_s(currents_A.back()) > most_rad_s;
    if (!isFast && !isSlow) {
        return currents_A;
    }
    const double high_A = std::min(currents_A.back(), steadyCurrent_A(pilot, most_rad_s));
    const double low_A = std::max(std::min(currents_A.front(), steadyCurrent_A(pilot, LowShare * most_rad_s)),
                                  steadyCurrent_A(pilot, least_rad_s));
    if (low_A >= high_A) {
        return isFast ? std::vector<double>() : currents_A;
    }
    std::vector<double> suited;
    const double steps = std::max(static_cast<double>(currents_A.size()) - 1.0, 1.0);
    for (std::size_t i = 0; i < currents_A.size(); ++i) {
        const double current = high_A - (high_A - low_A) * static_cast<double>(i) / steps;
        suited.insert(suited.begin(), std::floor(current * 1e4) / 1e4);
    }
    return suited;
}

PlateauRun coastRun(const PilotEstimate& pilot, double highest_A, int pairs, double dwell_s,
                    double speedLimit_rad_s) {
    constexpr double LongestCoast_s = 4.0;
    constexpr double Step_s = 0.1;
    const double limit = CoastShare * speedLimit_rad_s;
    PlateauRun run;
    run.dwell_s = dwell_s;
    const double reached = std::min(limit, speedAfter_rad_s(pilot, 0.0, highest_A, dwell_s));
    while (run.dwell_s < LongestCoast_s && speedAfter_rad_s(pilot, reached, 0.0, run.dwell_s) > 0.0) {
        run.dwell_s += Step_s;
    }
    double low_A = 0.0;
    double current_A = highest_A;
    if (fastest_rad_s(pilot, highest_A, pairs, run.dwell_s) > limit) {
        constexpr int Halvings = 30;
        for (int i = 0; i < Halvings; ++i) {
            const double middle_A = 0.5 * (low_A + current_A);
            (fastest_rad_s(pilot, middle_A, pairs, run.dwell_s) > limit ? current_A : low_A) = middle_A;
        }
        current_A = std::floor(low_A * 1e4) / 1e4;
    }
    for (int i = 0; i < pairs; ++i) {
        run.currents_A.insert(run.currents_A.end(), {current_A, 0.0});
    }
    run.mayReach_rad_s = GuardShare * speedLimit_rad_s;
    return run;
}

std::vector<PlateauRun> planRuns(const IdentifyConfig& config, const std::vector<double>& currents_A,
                                 const PilotEstimate& pilot) {
    const double settle_s = SettleTimes / std::max(pilot.damping_per_s, 1e-6);
    const std::vector<double> suited = suitedCurrents_A(config, currents_A, pilot);
    constexpr std::size_t FewestCurrents = 3;
    const bool canSweep = suited.size() >= FewestCurrents && settle_s + SteadinessWindows_s <= LongestDwell_s;
    std::vector<PlateauRun> runs;
    Random random = Random(config.seed).fork(1);
    for (const double sign : {1.0, -1.0}) {
        if ((sign > 0.0 && config.directions == SweepDirections::Reverse) ||
            (sign < 0.0 && config.directions == SweepDirections::Forward)) {
            continue;
        }
        if (canSweep) {
            runs.push_back(sweepRun(suited, sign, settle_s + SteadinessWindows_s, random));
        }
        if (config.coastDownsPerDirection > 0) {
            PlateauRun run = coastRun(pilot, currents_A.back(), config.coastDownsPerDirection,
                                      canSweep ? 1.0 : LoneRunUp_s, config.speedLimit_rad_s);
            for (double& current : run.currents_A) {
                current *= sign;
            }
            run.text = sign > 0.0 ? "coast-downs forward" : "coast-downs reverse";
            runs.push_back(std::move(run));
        }
    }
    for (PlateauRun& run : runs) {
        run.mayReach_rad_s = GuardShare * config.speedLimit_rad_s;
    }
    return runs;
}

} // namespace halbench::app
