#include "app/analyses/spherical/estimator_comparison.h"

#include "control/base/random.h"
#include "control/base/units.h"
#include "models/spherical/additive_model.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_motion.h"

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::app {

namespace {

/// Poses between two looks at the stop.
constexpr std::size_t PosesInAPart = 256;

/// What a pose costs in relation to the others, for the progress alone: tensor, projector, refined, lm,
/// closed, closed-fitted, swarm (resources/help/spherical-theory.md sections 5.4 and 8).
constexpr std::array<double, models::EstimatorNames.size()> Costs = {0.2, 0.2, 0.4, 2.0, 0.2, 2.0, 100.0};

struct ComparedReadings {
    std::vector<Eigen::Matrix3d> truth;
    std::vector<models::SphericalReadings> readings_T;
    int inside = 0;
};

models::OrientationAngles poseOf(const EstimatorComparisonConfig& config, int index, Random& random) {
    if (config.poses != ComparedPoses::Workspace) {
        return models::anglesForShaft(models::publishedShaft(static_cast<int>(config.poses), index + 1),
                                      config.spin_rad);
    }
    const auto angle = [&](double limit_rad) { return limit_rad * (2.0 * random.uniform() - 1.0); };
    models::OrientationAngles angles;
    angles.alpha_rad = angle(0.25 * Pi);
    angles.beta_rad = angle(0.25 * Pi);
    angles.gamma_rad = angle(0.5 * Pi);
    return angles;
}

ComparedReadings takeRows(const RecordedRows& rows) {
    ComparedReadings work;
    work.readings_T = rows.readings_T;
    for (const models::OrientationAngles& angles : rows.truth) {
        work.truth.push_back(models::rotationOf(angles));
        work.inside += models::isInWorkspace(models::anglesOf(models::representative(work.truth.back())));
    }
    return work;
}

ComparedReadings readSensors(const EstimatorComparisonConfig& config, Random& random) {
    ComparedReadings work;
    const int count = config.poses == ComparedPoses::Workspace ? config.count : models::PublishedSamples;
    for (int i = 0; i < count; ++i) {
        const models::OrientationAngles angles = poseOf(config, i, random);
        work.inside += models::isInWorkspace(angles);
        work.truth.push_back(models::rotationOf(angles));
    }
    const models::RotorField field(config.sensing.field);
    for (const Eigen::Matrix3d& rotation : work.truth) {
        models::SphericalReadings readings_T =
            config.device == models::SphericalDevice::Additive
                ? models::additiveReadings_T(config.additive, models::anglesOf(rotation))
                : field.readings_T(rotation, config.sensing.poses);
        for (double& reading : readings_T) {
            reading += config.noise_T * random.gaussian();
        }
        work.readings_T.push_back(readings_T);
    }
    return work;
}

models::AnyEstimatorConfig estimatorConfig(const EstimatorComparisonConfig& config, std::uint64_t seed) {
    models::AnyEstimatorConfig estimator;
    estimator.sensing = config.sensing;
    estimator.additive = config.additive;
    estimator.settings.harmonicPasses = config.passes;
    if (config.passes == 0) {
        estimator.sensing.field.harmonics.clear();
    }
    estimator.settings.fit.isStrengthFree = config.isStrengthFree;
    estimator.settings.possibleLimit_ratio = config.possibleLimit_ratio;
    estimator.seed = seed;
    estimator.swarm = config.swarm;
    return estimator;
}

using Estimates = std::vector<std::optional<Eigen::Matrix3d>>;

/// The swarm goes on with its random numbers, so every pose is estimated once. `onDone`: how many are;
/// false ends it.
bool estimateAll(const models::AnyEstimator& estimator, const ComparedReadings& work,
                 const std::function<bool(std::size_t)>& onDone, Estimates& found) {
    found.assign(work.readings_T.size(), std::nullopt);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i % PosesInAPart == 0 && !onDone(i)) {
            return false;
        }
        found[i] = estimator(work.readings_T[i]);
    }
    return true;
}

void judge(const Estimates& found, const ComparedReadings& work, double failureLimit_rad,
           ComparedEstimator& row) {
    std::size_t next = 0;
    const models::AnyEstimator replay = [&](const models::SphericalReadings&) { return found[next++]; };
    row.errors = models::estimatorErrors(replay, work.readings_T, work.truth, failureLimit_rad);
    double squares = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i]) {
            const Eigen::Vector3d shaft = models::nearestImage(*found[i], work.truth[i]).col(2);
            const double off_rad =
                std::atan2(shaft.cross(work.truth[i].col(2)).norm(), shaft.dot(work.truth[i].col(2)));
            squares += off_rad * off_rad;
            ++row.estimated;
        }
    }
    row.shaftRms_rad = row.estimated > 0 ? std::sqrt(squares / row.estimated) : 0.0;
}

/// Rows without true angles have the poses of one estimator in their place; those that it cannot give are
/// left out.
Result<void> supplyTruth(models::AnyEstimatorConfig settings, ComparedReadings& work) {
    settings.kind = models::EstimatorKind::Refined;
    const auto estimator = models::makeAnyEstimator(settings);
    if (!estimator) {
        return failure(estimator.error());
    }
    ComparedReadings known;
    for (const models::SphericalReadings& readings_T : work.readings_T) {
        if (const std::optional<Eigen::Matrix3d> rotation = (*estimator)(readings_T)) {
            known.truth.push_back(*rotation);
            known.readings_T.push_back(readings_T);
            known.inside += models::isInWorkspace(models::anglesOf(*rotation));
        }
    }
    work = std::move(known);
    return work.truth.empty()
               ? failure(ErrorCode::Refused, "The readings of no recorded row fit an orientation.",
                         "Check where the sensors are and how strong the rotor is, or calibrate.")
               : Result<void>();
}

/// What pictures are drawn of.
std::vector<std::optional<Eigen::Matrix3d>> nearestImages(const Estimates& found,
                                                          const std::vector<Eigen::Matrix3d>& truth) {
    std::vector<std::optional<Eigen::Matrix3d>> images(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i]) {
            images[i] = models::nearestImage(*found[i], truth[i]);
        }
    }
    return images;
}

bool isWanted(const EstimatorComparisonConfig& config, std::size_t kind) {
    return !config.only || *config.only == static_cast<models::EstimatorKind>(kind);
}

/// Progress over all wanted estimators.
class CostProgress {
public:
    CostProgress(const EstimatorComparisonConfig& config, const AnalysisControl& control)
        : m_control(control) {
        for (std::size_t kind = 0; kind < Costs.size(); ++kind) {
            m_total += isWanted(config, kind) ? Costs[kind] : 0.0;
        }
    }

    /// `share` of the estimator that works now. False: it was stopped.
    bool tell(std::size_t kind, double share) const {
        if (m_control.onProgress) {
            m_control.onProgress((m_before + share * Costs[kind]) / m_total);
        }
        return !m_control.isStopped || !m_control.isStopped();
    }
    void finish(std::size_t kind) { m_before += Costs[kind]; }

private:
    const AnalysisControl& m_control;
    double m_total = 0.0;
    double m_before = 0.0;
};

} // namespace

Result<EstimatorComparison> compareEstimators(const EstimatorComparisonConfig& config,
                                              const AnalysisControl& control, const StopWatch& now_s) {
    Random random(config.seed);
    ComparedReadings work = config.rows ? takeRows(*config.rows) : readSensors(config, random);
    models::AnyEstimatorConfig settings = estimatorConfig(config, random.bits());
    EstimatorComparison comparison;
    comparison.isAgainstTruth = !work.truth.empty();
    if (const auto done = work.truth.empty() ? supplyTruth(settings, work) : Result<void>(); !done) {
        return failure(done.error());
    }
    comparison.poses = static_cast<int>(work.truth.size());
    comparison.inside = work.inside;
    CostProgress progress(config, control);
    Estimates found;
    for (std::size_t kind = 0; kind < models::EstimatorNames.size(); ++kind) {
        if (!isWanted(config, kind)) {
            continue;
        }
        settings.kind = static_cast<models::EstimatorKind>(kind);
        ComparedEstimator row;
        row.kind = settings.kind;
        const auto estimator = models::makeAnyEstimator(settings);
        if (!estimator && estimator.error().code != ErrorCode::OutOfRange) {
            return failure(estimator.error());
        }
        if (!estimator) {
            row.reason = estimator.error().message;
        } else {
            const double start_s = now_s ? now_s() : 0.0;
            const auto tell = [&](std::size_t done) {
                return progress.tell(kind, static_cast<double>(done) / static_cast<double>(comparison.poses));
            };
            if (!estimateAll(*estimator, work, tell, found)) {
                return failure(ErrorCode::Interrupted, "The comparison was stopped.");
            }
            if (now_s && comparison.poses > 0) {
                row.timePerPose_s = (now_s() - start_s) / comparison.poses;
            }
            judge(found, work, config.failureLimit_rad, row);
            if (config.keepsPoses) {
                row.found = nearestImages(found, work.truth);
            }
        }
        progress.finish(kind);
        comparison.estimators.push_back(std::move(row));
    }
    if (config.keepsPoses) {
        comparison.truth = std::move(work.truth);
    }
    return comparison;
}

} // namespace halbench::app
