#pragma once

#include "models/spherical/swarm_estimator.h"
#include "tests/models/spherical/orientation_cases.h"

namespace halbench::models {

struct SwarmSuccess {
    double right_ratio = 0.0;    ///< error below 0.1 degrees
    double wrongFit_ratio = 0.0; ///< the readings are met at a wrong pose
};

/// Rates of section 5.4 of resources/help/spherical-theory.md.
struct SwarmCase {
    SwarmTrigger trigger;
    SwarmRule rule;
    bool knowsSignOfBeta;
    double right_ratio;
};
constexpr std::array SwarmCases = {
    SwarmCase{SwarmTrigger::Signed, SwarmRule::LargestResidual, false, 0.899},
    SwarmCase{SwarmTrigger::Absolute, SwarmRule::LargestResidual, false, 0.645},
    SwarmCase{SwarmTrigger::Absolute, SwarmRule::FirstAboveThreshold, false, 0.593},
    SwarmCase{SwarmTrigger::Signed, SwarmRule::AllNine, false, 0.966},
    SwarmCase{SwarmTrigger::Signed, SwarmRule::LargestResidual, true, 0.963},
    SwarmCase{SwarmTrigger::Absolute, SwarmRule::LargestResidual, true, 0.888},
};

inline SwarmConfig configOf(const SwarmCase& given) {
    SwarmConfig config;
    config.trigger = given.trigger;
    config.rule = given.rule;
    if (given.knowsSignOfBeta) {
        config.swarmStop_T2 = 1e-4;
    }
    return config;
}

/// Readings and model both additive; poses uniform in the workspace.
inline SwarmSuccess swarmSuccess(SwarmConfig config, bool knowsSignOfBeta, int poses, std::uint64_t seed) {
    const AdditiveModel additive;
    const AngleModel model = angleModel(additive);
    Random random(seed);
    int right = 0;
    int wrong = 0;
    const SwarmBox whole;
    for (int i = 0; i < poses; ++i) {
        const OrientationAngles truth = drawn(random);
        config.box = whole;
        if (knowsSignOfBeta) {
            (truth.beta_rad >= 0.0 ? config.box.low : config.box.high).beta_rad = 0.0;
        }
        const SwarmEstimate found =
            estimateBySwarm(model, config, additiveReadings_T(additive, truth), random);
        const bool isRight =
            symmetricError_rad(rotationOf(found.angles), rotationOf(truth)) < degreesToRadians(0.1);
        right += isRight;
        wrong += !isRight && found.fitness_T2 < 1e-16;
    }
    return {static_cast<double>(right) / poses, static_cast<double>(wrong) / poses};
}

} // namespace halbench::models
