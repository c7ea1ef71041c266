#include "control/robustness/robustness.h"

#include "control/base/assert.h"
#include "control/robustness/loop_batch.h"
#include "control/robustness/percentiles.h"
#include "control/robustness/sampled_assessments.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::control {

namespace {

/// Matrix M with M M^T = covariance, through the eigenvalues of the correlation (units differ by decades).
Result<Eigen::MatrixXd> factor(const Eigen::MatrixXd& covariance) {
    if (covariance.size() == 0) {
        return covariance; // a motor known exactly
    }
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd inverse = deviation.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 0.0; });
    const Eigen::MatrixXd correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
    constexpr double Rounding = 1e-6; // a covariance that went through a text file
    const bool isSymmetric = (correlation - correlation.transpose()).cwiseAbs().maxCoeff() < Rounding;
    const Eigen::MatrixXd rest = covariance - deviation.asDiagonal() * correlation * deviation.asDiagonal();
    const bool isBounded = (rest.array().abs() <= Rounding * covariance.cwiseAbs().maxCoeff()).all();
    if (covariance.diagonal().minCoeff() < 0.0 || !isSymmetric || !isBounded ||
        solver.eigenvalues().minCoeff() < -Rounding) {
        return failure(ErrorCode::InvalidInput, "the covariance of the model is not valid",
                       "it must be symmetric and positive semi-definite: identify the motor again");
    }
    const Eigen::VectorXd scale = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return Eigen::MatrixXd(deviation.asDiagonal() * solver.eigenvectors() * scale.asDiagonal());
}

Result<void> check(const UncertainPlant& plant, int draws) {
    constexpr int LeastDraws = 1000;
    constexpr int MostDraws = 1000000;
    if (draws < LeastDraws || draws > MostDraws) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} draws are not between {} and {}", draws, LeastDraws, MostDraws));
    }
    if (plant.covariance.rows() != plant.mean.size() || plant.covariance.cols() != plant.mean.size()) {
        return failure(ErrorCode::InvalidInput, "the covariance does not have the size of the parameters");
    }
    if (!plant.mean.allFinite() || !plant.covariance.allFinite()) {
        return failure(ErrorCode::NotFinite, "the model or its covariance holds a value that is not finite");
    }
    return {};
}

/// Each draw on its own loop, all of them together. One that is no motor, or a law that is none, has nothing.
std::vector<SampledAssessment> judge(const std::vector<PositionPlant>& plants, const PidGains& gains,
                                     const LoopTiming& timing) {
    std::vector<SampledAssessment> judged(plants.size());
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return judged;
    }
    const std::vector<BatchVerdict> verdicts = judgeBatch(*batch);
    for (std::size_t lane = 0; lane < verdicts.size(); ++lane) {
        const BatchVerdict& verdict = verdicts[lane];
        judged[batch->plantOfLane()[lane]] = {verdict.isStable, verdict.margins};
    }
    return judged;
}

template <typename Figure>
Robustness::Interval spread(const std::vector<StabilityMargins>& margins, Figure figure) {
    Eigen::ArrayXd values(static_cast<Eigen::Index>(margins.size()));
    for (std::size_t i = 0; i < margins.size(); ++i) {
        values[static_cast<Eigen::Index>(i)] = figure(margins[i]);
    }
    const MiddleNineTenths middle = middleNineTenths(values);
    return {middle.p5, middle.p95};
}

double eitherWay_ratio(const StabilityMargins& margins) {
    const double ratio = margins.gainMargin_ratio;
    return ratio > 0.0 ? std::max(ratio, 1.0 / ratio) : std::min(ratio, 1.0);
}

std::vector<StabilityMargins> marginsOfStable(const std::vector<SampledAssessment>& draws) {
    std::vector<StabilityMargins> margins;
    margins.reserve(draws.size());
    for (const SampledAssessment& draw : draws) {
        if (draw.isStable) {
            margins.push_back(draw.margins);
        }
    }
    return margins;
}

} // namespace

bool isUncertain(const UncertainPlant& plant) {
    return plant.covariance.size() > 0 && plant.covariance.diagonal().maxCoeff() > 0.0;
}

Robustness robustnessOf(const std::vector<SampledAssessment>& draws, bool isUncertain) {
    const std::vector<StabilityMargins> stable = marginsOfStable(draws);
    const auto unstable = static_cast<double>(draws.size() - stable.size());
    Robustness robust{static_cast<int>(draws.size()), unstable / static_cast<double>(draws.size()),
                      isUncertain};
    if (stable.empty()) {
        return robust;
    }
    const auto gain = spread(stable, [](const StabilityMargins& m) { return m.gainMargin_ratio; });
    const auto phase = spread(stable, [](const StabilityMargins& m) { return m.phaseMargin_deg; });
    robust.gainMargin_ratio_p5 = gain.p5;
    robust.phaseMargin_deg_p5 = phase.p5;
    robust.gainMarginEitherWay_ratio_p5 = spread(stable, eitherWay_ratio).p5;
    if (!isUncertain) {
        return robust;
    }
    robust.gainMargin_ratio = gain;
    robust.phaseMargin_deg = phase;
    robust.delayMargin_s = spread(stable, [](const StabilityMargins& m) { return m.delayMargin_s; });
    robust.modulusMargin = spread(stable, [](const StabilityMargins& m) { return m.modulusMargin; });
    if (std::all_of(stable.begin(), stable.end(),
                    [](const StabilityMargins& m) { return m.gainCrossover_rad_s.has_value(); })) {
        robust.gainCrossover_rad_s =
            spread(stable, [](const StabilityMargins& m) { return *m.gainCrossover_rad_s; });
    }
    return robust;
}

Result<std::vector<PositionPlant>> drawPlants(const UncertainPlant& plant, int draws, Random random) {
    HB_ASSERT(plant.toPlant != nullptr);
    if (const auto valid = check(plant, draws); !valid) {
        return failure(valid.error());
    }
    const auto root = factor(plant.covariance);
    if (!root) {
        return failure(root.error());
    }
    std::vector<PositionPlant> plants;
    plants.reserve(static_cast<std::size_t>(draws));
    Eigen::VectorXd normal(plant.mean.size());
    for (int i = 0; i < draws; ++i) {
        for (double& value : normal) {
            value = random.gaussian();
        }
        PositionPlant drawn = plant.toPlant(plant.mean + *root * normal);
        // Damping below zero is taken as none: a draw beyond the edge of what a motor can be, no negative
        // brake.
        drawn.dampingRate_1_s = std::max(drawn.dampingRate_1_s, 0.0);
        drawn.breakawayCurrent_A = std::max(drawn.breakawayCurrent_A, 0.0);
        plants.push_back(drawn);
    }
    return plants;
}

Result<Robustness> assessRobustness(const UncertainPlant& plant, const PidGains& gains,
                                    const LoopTiming& timing, int draws, Random random) {
    const auto plants = drawPlants(plant, draws, random);
    if (!plants) {
        return failure(plants.error());
    }
    return robustnessOf(judge(*plants, gains, timing), isUncertain(plant));
}

} // namespace halbench::control
