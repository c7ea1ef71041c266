#pragma once

#include "app/procedures/identify/identify_procedure.h"
#include "devices/open/open_device.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// How often the 95 % intervals of c, K_f and phi hold the plant's parameters on motors with all default
/// imperfections, J given.
struct Coverage {
    std::array<int, 3> covered{};
    std::array<int, 3> missedAndGood{}; ///< intervals that exclude the truth in a result that is called good
    std::vector<double> dampingHalfWidths_ratio; ///< of the intervals of c, to c itself
    int runs = 0;
    int notGood = 0; ///< verdicts
};

/// A motor's constants in SI units.
struct TrueMotor {
    double damping = 1.23e-3; // the published motor, resources/help/htm-theory.md section 2
    double friction = 2.05e-2;
    double torque = 1.43e-2;
    double inertia = 5.5e-4;
};

/// `overrides` of the motor, "&KEY=VALUE..."; the current's tolerance where one is stated.
inline Coverage countCoverage(int firstSeed, int lastSeed, const std::string& overrides = {},
                              std::optional<double> currentTolerance_percent = {},
                              const TrueMotor& motor = {}) {
    const std::array truth = {motor.damping, motor.friction, motor.torque};
    Coverage coverage;
    for (int seed = firstSeed; seed <= lastSeed; ++seed) {
        const auto device =
            devices::openDevice(fmt::format("sim:htm?seed={}&c={}&Kf={}&phi={}&J={}{}", seed, motor.damping,
                                            motor.friction, motor.torque, motor.inertia, overrides),
                                {});
        if (!device) {
            ADD_FAILURE() << device.error().message;
            return coverage;
        }
        IdentifyConfig config;
        config.given.inertia_kg_m2 = motor.inertia;
        config.currentTolerance_percent = currentTolerance_percent;
        config.seed = static_cast<std::uint64_t>(seed);
        const auto result = runIdentify(**device, config, {});
        if (!result) {
            ADD_FAILURE() << "seed " << seed << ": " << result.error().message;
            continue;
        }
        const std::array estimates = {&result->viscousDamping, &result->coulombFriction,
                                      &result->torqueConstant};
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const auto& interval = estimates[i]->interval95;
            const bool isHeld = interval && interval->first <= truth[i] && truth[i] <= interval->second;
            coverage.covered[i] += isHeld;
            coverage.missedAndGood[i] += interval && !isHeld && result->quality.verdict == Verdict::Good;
        }
        if (const auto& interval = result->viscousDamping.interval95) {
            coverage.dampingHalfWidths_ratio.push_back(0.5 * (interval->second - interval->first) /
                                                       motor.damping);
        }
        coverage.notGood += result->quality.verdict != Verdict::Good;
        ++coverage.runs;
    }
    return coverage;
}

} // namespace halbench::app
