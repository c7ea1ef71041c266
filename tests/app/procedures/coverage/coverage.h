#pragma once

#include "app/procedures/identify/identify_procedure.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>

namespace halbench::app {

/// How often the 95 % intervals of c, K_f and phi hold the plant's parameters on motors with all default
/// imperfections, J given.
struct Coverage {
    std::array<int, 3> covered{};
    int runs = 0;
    int notGood = 0; ///< verdicts
};

/// `overrides` of the motor, "&KEY=VALUE..."; the current's tolerance where one is stated.
inline Coverage countCoverage(int firstSeed, int lastSeed, const std::string& overrides = {},
                              std::optional<double> currentTolerance_percent = {}) {
    // resources/help/htm-theory.md section 2
    constexpr std::array Truth = {1.23e-3, 2.05e-2, 1.43e-2};
    Coverage coverage;
    for (int seed = firstSeed; seed <= lastSeed; ++seed) {
        const auto device = devices::openDevice("sim:htm?seed=" + std::to_string(seed) + overrides, {});
        if (!device) {
            ADD_FAILURE() << device.error().message;
            return coverage;
        }
        IdentifyConfig config;
        config.given.inertia_kg_m2 = 5.5e-4;
        config.currentTolerance_percent = currentTolerance_percent;
        config.seed = static_cast<std::uint64_t>(seed);
        const auto result = runIdentify(**device, config, {});
        if (!result) {
            ADD_FAILURE() << "seed " << seed << ": " << result.error().message;
            continue;
        }
        const std::array estimates = {&result->viscousDamping, &result->coulombFriction,
                                      &result->torqueConstant};
        for (std::size_t i = 0; i < Truth.size(); ++i) {
            const auto& interval = estimates[i]->interval95;
            coverage.covered[i] += interval && interval->first <= Truth[i] && Truth[i] <= interval->second;
        }
        coverage.notGood += result->quality.verdict != Verdict::Good;
        ++coverage.runs;
    }
    return coverage;
}

} // namespace halbench::app
