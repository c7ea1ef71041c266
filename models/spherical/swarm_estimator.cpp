#include "models/spherical/swarm_estimator.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

Eigen::Vector3d vectorOf(const OrientationAngles& angles) {
    return {angles.alpha_rad, angles.beta_rad, angles.gamma_rad};
}

OrientationAngles anglesAt(const Eigen::Vector3d& point) {
    return {point[0], point[1], point[2]};
}

bool isTriggered(const SwarmConfig& config, double reading_T) {
    const double judged_T = config.trigger == SwarmTrigger::Signed ? reading_T : std::abs(reading_T);
    return judged_T < config.threshold_T;
}

/// Channel whose residual stands for component c (0 R, 1 Theta, 2 Phi).
int selectedChannel(const SwarmConfig& config, const SphericalReadings& readings_T,
                    const SphericalReadings& residual_T, int c) {
    if (!isTriggered(config, readings_T[c])) {
        return c;
    }
    if (config.rule == SwarmRule::FirstAboveThreshold) {
        for (int i = 1; i < 3; ++i) {
            if (!isTriggered(config, readings_T[3 * i + c])) {
                return 3 * i + c;
            }
        }
        return c;
    }
    int chosen = c;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(residual_T[3 * i + c]) > std::abs(residual_T[chosen])) {
            chosen = 3 * i + c;
        }
    }
    return chosen;
}

double fitnessOf(const SwarmConfig& config, const SphericalReadings& readings_T,
                 const SphericalReadings& residual_T) {
    if (config.rule == SwarmRule::AllNine) {
        return residual_T.squaredNorm();
    }
    double sum_T2 = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double chosen_T = residual_T[selectedChannel(config, readings_T, residual_T, c)];
        sum_T2 += chosen_T * chosen_T;
    }
    return sum_T2;
}

struct Particle {
    Eigen::Vector3d place;
    Eigen::Vector3d velocity;
    Eigen::Vector3d best;
    double bestFitness_T2 = 0.0;
};

Eigen::Vector3d draw(Random& random) {
    Eigen::Vector3d drawn;
    for (double& entry : drawn) {
        entry = random.uniform();
    }
    return drawn;
}

/// First stage: point and fitness.
std::pair<Eigen::Vector3d, double> swarm(const AngleModel& model, const SwarmConfig& config,
                                         const SphericalReadings& readings_T, Random& random,
                                         const std::function<void(double)>& watch, int& iterations) {
    const Eigen::Vector3d low = vectorOf(config.box.low);
    const Eigen::Vector3d high = vectorOf(config.box.high);
    const Eigen::Vector3d fastest = 0.5 * config.velocityLimit_ratio * (high - low);
    std::array<Particle, MaxParticles> particles;
    Eigen::Vector3d best = low;
    double bestFitness_T2 = HUGE_VAL;
    for (int i = 0; i < config.particles; ++i) {
        Particle& particle = particles[static_cast<std::size_t>(i)];
        particle.place = low + draw(random).cwiseProduct(high - low);
        particle.velocity = (2.0 * draw(random).array() - 1.0).matrix().cwiseProduct(fastest);
        particle.best = particle.place;
        particle.bestFitness_T2 = swarmFitness_T2(model, config, readings_T, anglesAt(particle.place));
        if (particle.bestFitness_T2 < bestFitness_T2) {
            best = particle.best;
            bestFitness_T2 = particle.bestFitness_T2;
        }
    }
    while (iterations < config.iterations && bestFitness_T2 >= config.swarmStop_T2) {
        const double elapsed = config.iterations > 1 ? iterations / (config.iterations - 1.0) : 0.0;
        const double inertia = config.firstInertia + (config.lastInertia - config.firstInertia) * elapsed;
        for (int i = 0; i < config.particles; ++i) {
            Particle& particle = particles[static_cast<std::size_t>(i)];
            const Eigen::Vector3d own = draw(random);
            const Eigen::Vector3d common = draw(random);
            particle.velocity = inertia * particle.velocity +
                                config.ownPull * own.cwiseProduct(particle.best - particle.place) +
                                config.commonPull * common.cwiseProduct(best - particle.place);
            particle.velocity = particle.velocity.cwiseMax(-fastest).cwiseMin(fastest);
            particle.place = (particle.place + particle.velocity).cwiseMax(low).cwiseMin(high);
            const double fitness_T2 = swarmFitness_T2(model, config, readings_T, anglesAt(particle.place));
            if (fitness_T2 < particle.bestFitness_T2) {
                particle.best = particle.place;
                particle.bestFitness_T2 = fitness_T2;
            }
            if (fitness_T2 < bestFitness_T2) {
                best = particle.place;
                bestFitness_T2 = fitness_T2;
            }
        }
        ++iterations;
        if (watch) {
            watch(bestFitness_T2);
        }
    }
    return {best, bestFitness_T2};
}

/// J^+ r + k (I - J^+ J) grad F, grad F = -2 J^T r, by the singular value decomposition.
template <int Rows>
Eigen::Vector3d projectedStep(const SwarmConfig& config, const Eigen::Matrix<double, Rows, 3>& jacobian,
                              const Eigen::Matrix<double, Rows, 1>& residual_T) {
    // The eigenvectors of J^T J are the right singular vectors; Jacobi's rotations keep small ones accurate.
    const Eigen::JacobiSVD<Eigen::Matrix<double, Rows, 3>> svd(jacobian,
                                                               Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d gradient = -2.0 * jacobian.transpose() * residual_T;
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d v = svd.matrixV().col(i);
        const double singular = svd.singularValues()[i];
        if (singular > config.singularCut_ratio * svd.singularValues()[0]) {
            step += svd.matrixU().col(i).dot(residual_T) / singular * v;
        } else {
            step += config.nullSpaceGain * v.dot(gradient) * v;
        }
    }
    return step;
}

} // namespace

Result<void> checkSwarmConfig(const SwarmConfig& config) {
    const Eigen::Vector3d low = vectorOf(config.box.low);
    const Eigen::Vector3d high = vectorOf(config.box.high);
    for (const double value :
         {low.sum(), high.sum(), config.threshold_T, config.firstInertia, config.lastInertia, config.ownPull,
          config.commonPull, config.velocityLimit_ratio, config.swarmStop_T2, config.nullSpaceGain,
          config.singularCut_ratio, config.stepLimit_rad, config.projectionStop_T2}) {
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite, "A setting of the particle swarm is not a finite number.");
        }
    }
    if ((high - low).minCoeff() <= 0.0) {
        return failure(ErrorCode::OutOfRange, "The box of the particle swarm is empty.");
    }
    if (config.particles < 1 || config.particles > MaxParticles || config.iterations < 0 ||
        config.projectionSteps < 0) {
        return failure(ErrorCode::OutOfRange,
                       "The particle swarm needs 1 to 128 particles and numbers of steps of at least 0.");
    }
    if (config.threshold_T < 0.0 || config.ownPull < 0.0 || config.commonPull < 0.0 ||
        config.velocityLimit_ratio <= 0.0 || config.swarmStop_T2 < 0.0 || config.singularCut_ratio < 0.0 ||
        config.stepLimit_rad <= 0.0 || config.projectionStop_T2 < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       "Thresholds, pulls and stops of the particle swarm are at least zero, its limits of "
                       "velocity and step positive.");
    }
    return {};
}

double swarmFitness_T2(const AngleModel& model, const SwarmConfig& config,
                       const SphericalReadings& readings_T, const OrientationAngles& angles) {
    return fitnessOf(config, readings_T, readings_T - model(angles, nullptr));
}

SwarmEstimate estimateBySwarm(const AngleModel& model, const SwarmConfig& config,
                              const SphericalReadings& readings_T, Random& random,
                              const std::function<void(double)>& watch) {
    HB_ASSERT(checkSwarmConfig(config).has_value());
    SwarmEstimate estimate;
    auto [point, fitness_T2] = swarm(model, config, readings_T, random, watch, estimate.swarmIterations);
    estimate.startFitness_T2 = fitness_T2;
    while (estimate.projectionSteps < config.projectionSteps && fitness_T2 >= config.projectionStop_T2) {
        ++estimate.projectionSteps;
        OrientationJacobian whole;
        const SphericalReadings residual_T = readings_T - model(anglesAt(point), &whole);
        Eigen::Vector3d step;
        if (config.rule == SwarmRule::AllNine) {
            estimate.channels = AllChannels;
            step = projectedStep<9>(config, whole, residual_T);
        } else {
            estimate.channels = {};
            Eigen::Matrix3d jacobian;
            Eigen::Vector3d chosen_T;
            for (int c = 0; c < 3; ++c) {
                const int channel = selectedChannel(config, readings_T, residual_T, c);
                estimate.channels[static_cast<std::size_t>(channel)] = true;
                jacobian.row(c) = whole.row(channel);
                chosen_T[c] = residual_T[channel];
            }
            step = projectedStep<3>(config, jacobian, chosen_T);
        }
        point += step.cwiseMax(-config.stepLimit_rad).cwiseMin(config.stepLimit_rad);
        point = point.cwiseMax(vectorOf(config.box.low)).cwiseMin(vectorOf(config.box.high));
        fitness_T2 = swarmFitness_T2(model, config, readings_T, anglesAt(point));
    }
    estimate.fitness_T2 = fitness_T2;
    point[2] = std::remainder(point[2], Pi);
    estimate.angles = anglesAt(point);
    return estimate;
}

} // namespace halbench::models
