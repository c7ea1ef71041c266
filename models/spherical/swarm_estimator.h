#pragma once

#include "control/base/random.h"
#include "models/spherical/angle_model.h"
#include "models/spherical/spherical_sensing.h"

#include <functional>
#include <optional>
#include <string_view>

namespace halbench::models {

/// When the main sensor's reading of a component counts as too small.
enum class SwarmTrigger {
    Signed,  ///< below the threshold, as printed: every negative reading does
    Absolute ///< its magnitude is below the threshold
};
inline constexpr std::array<std::string_view, 2> SwarmTriggerNames = {"signed", "absolute"};

/// The residual that a component contributes.
enum class SwarmRule {
    LargestResidual,     ///< main sensor; when triggered the largest of the three
    FirstAboveThreshold, ///< main sensor; when triggered the first sensor whose reading is large enough
    AllNine              ///< all nine residuals, always
};
inline constexpr std::array<std::string_view, 3> SwarmRuleNames = {"largest", "first", "all"};

/// Box that neither stage leaves; beta may be limited to the sign of the command.
struct SwarmBox {
    OrientationAngles low{-0.78539816339744831, -0.78539816339744831, -1.5707963267948966};
    OrientationAngles high{0.78539816339744831, 0.78539816339744831, 1.5707963267948966};
};

/// The published search: particle swarm, then gradient projection. The publication names neither sizes,
/// weights, step lengths nor stop rules; these are assumed.
struct SwarmConfig {
    SwarmTrigger trigger = SwarmTrigger::Signed;
    SwarmRule rule = SwarmRule::LargestResidual;
    double threshold_T = 0.01;
    SwarmBox box;
    int particles = 30; ///< at most 128
    int iterations = 100;
    double firstInertia = 0.9;
    double lastInertia = 0.4;
    double ownPull = 2.0;
    double commonPull = 2.0;
    double velocityLimit_ratio = 0.4; ///< of half the box
    double swarmStop_T2 = 1e-3;       ///< fitness at which the second stage begins
    int projectionSteps = 200;
    double nullSpaceGain = -0.5;     ///< k in (-1, 0); multiplies zero whenever J has full rank
    double singularCut_ratio = 1e-4; ///< of the pseudo-inverse
    double stepLimit_rad = 0.5;
    double projectionStop_T2 = 1e-20;
};
constexpr int MaxParticles = 128;

/// OutOfRange or NotFinite: an empty box, no or too many particles, negative counts, a pull or a stop below
/// zero.
Result<void> checkSwarmConfig(const SwarmConfig& config);

struct SwarmEstimate {
    OrientationAngles angles; ///< gamma wrapped into (-90, 90] degrees
    double fitness_T2 = 0.0;
    double startFitness_T2 = 0.0; ///< where the second stage began
    int swarmIterations = 0;
    int projectionSteps = 0;
    ChannelMask channels{}; ///< whose residuals the last step of the projection took
};

/// F = sum over R, Theta, Phi of f^2 (T^2), f by trigger and rule. Known faults of the method, kept: J of the
/// first two rules is square, so the second stage is Newton's method; it is singular for beta = 0 and gamma =
/// 0, +-90 degrees; F has zeros at wrong poses. `watch`, if given, sees the best fitness of each swarm
/// iteration. The configuration is checked. Source: resources/help/spherical-theory.md section 5.4.
SwarmEstimate estimateBySwarm(const AngleModel& model, const SwarmConfig& config,
                              const SphericalReadings& readings_T, Random& random,
                              const std::function<void(double)>& watch = {});

/// F at one point.
double swarmFitness_T2(const AngleModel& model, const SwarmConfig& config,
                       const SphericalReadings& readings_T, const OrientationAngles& angles);

} // namespace halbench::models
