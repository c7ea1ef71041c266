#pragma once

#include "control/base/random.h"
#include "control/base/result.h"
#include "control/law/position_loop.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace halbench::control {

/// How a design fares over the uncertainty of the identified motor. Margins are those of the draws whose loop
/// is stable: an unstable loop has none, and `unstable_fraction` says how many there are.
struct Robustness {
    int draws = 0;
    double unstable_fraction = 0.0; ///< draws whose sampled loop is unstable
    bool isUncertain = false;       ///< else every draw is the same plant
    /// 5th percentile, nothing when no draw is stable; infinite when that draw has no phase crossing.
    std::optional<double> gainMargin_ratio_p5 = {};
    std::optional<double> phaseMargin_deg_p5 = {};

    /// The middle nine tenths. Nothing is known of it for a plant without uncertainty, or when no draw is
    /// stable.
    struct Interval {
        double p5 = 0.0;
        double p95 = 0.0;
    };
    std::optional<Interval> gainMargin_ratio = {};
    std::optional<Interval> phaseMargin_deg = {};
    std::optional<Interval> delayMargin_s = {};
    std::optional<Interval> modulusMargin = {};
    std::optional<Interval> gainCrossover_rad_s = {}; ///< also unknown when a draw has none

    /// 5th percentile of the factor by which the gain may change either way: of a loop whose gain may neither
    /// fall nor rise freely some draws have their nearest limit below and others above, and a percentile of
    /// `gainMargin_ratio` says nothing of how near.
    std::optional<double> gainMarginEitherWay_ratio_p5 = {};
};

/// A joint normal uncertainty of some parameters and how they make a plant. A draw that is no motor (gain not
/// positive) counts as unstable.
struct UncertainPlant {
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
    std::function<PositionPlant(const Eigen::VectorXd&)> toPlant;
};

/// Plants of `draws` (at least 1000) draws, with damping and friction of at least zero; a draw whose gain is
/// not positive is kept and is no motor. Deterministic for a seed. Errors: InvalidInput (sizes, covariance
/// not positive semi-definite), NotFinite, OutOfRange (draws).
Result<std::vector<PositionPlant>> drawPlants(const UncertainPlant& plant, int draws, Random random);

/// Draws `draws` (at least 1000) plants and judges the sampled loop of each. Deterministic for a seed.
/// Errors: InvalidInput (sizes, covariance not positive semi-definite), NotFinite, OutOfRange (draws).
Result<Robustness> assessRobustness(const UncertainPlant& plant, const PidGains& gains,
                                    const LoopTiming& timing, int draws, Random random);

} // namespace halbench::control
