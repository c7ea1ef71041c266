#include "app/analyses/spherical/estimator_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "app/documents/text/numbers.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "models/spherical/additive_model.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_motion.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 5> PoseSets = {"workspace", "trajectory1", "trajectory2",
                                                      "trajectory3", "trajectory4"};
constexpr std::array<std::string_view, 3> HarmonicNames = {"none", "h1", "h2"};

std::vector<AnalysisKey> estimatorKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = placementKeys();
    const std::vector<AnalysisKey> own = {
        {"poses", Choice, 0, 0, "workspace|trajectory1|trajectory2|trajectory3|trajectory4",
         "random poses of the workspace (default) or a published trajectory of 25"},
        {"count", Integer, 10, 1e6, "", "how many random poses; default 2000"},
        {"spin_deg", Number, -180, 180, "", "spin along a trajectory; default 0"},
        {"harmonics", Choice, 0, 0, "none|h1|h2", "harmonics of the device; default none"},
        {"passes", Integer, 0, 20, "", "how often estimators correct them; default 0: they do not know them"},
        {"known_strength", Flag, 0, 0, "", "hold the strength of the field at q_T"},
        {"only", Choice, 0, 0, "all|tensor|projector|refined|lm|closed|closed-fitted|swarm",
         "one estimator; default all"},
        {"noise_uT", Number, 0, 1e5, "", "noise of a reading, rms; default 0"},
        {"failure_deg", Number, 1e-9, 180, "", "an error above it is a failure; default 0.1"},
        {"rng_seed", Integer, 0, 4294967295.0, "", "random numbers of poses, noise and swarm; default 1"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    return keys;
}

struct Comparison {
    PlacementChoice choice;
    std::vector<Eigen::Matrix3d> truth;
    std::vector<models::SphericalReadings> readings_T;
    std::size_t inside = 0; ///< of the workspace
    double failure_rad = 0.0;
};

struct EstimatorRow {
    std::string_view name;
    std::optional<models::EstimatorErrors> errors; ///< empty: it does not suit the placement
    double shaft_rms_rad = 0.0;
    int estimated = 0; ///< poses with an estimate, right or wrong
};

void drawPoses(const AnalysisValues& values, Random& random, Comparison& work) {
    const std::size_t set = choiceIndex(PoseSets, values.text("poses"));
    const int count =
        set == 0 ? static_cast<int>(values.numberOr("count", 2000.0)) : models::PublishedSamples;
    for (int i = 0; i < count; ++i) {
        models::OrientationAngles angles;
        if (set == 0) {
            const auto angle = [&](double limit_rad) { return limit_rad * (2.0 * random.uniform() - 1.0); };
            angles.alpha_rad = angle(0.25 * Pi);
            angles.beta_rad = angle(0.25 * Pi);
            angles.gamma_rad = angle(0.5 * Pi);
        } else {
            angles = models::anglesForShaft(models::publishedShaft(static_cast<int>(set), i + 1),
                                            degreesToRadians(values.numberOr("spin_deg", 0.0)));
        }
        work.inside += models::isInWorkspace(angles);
        work.truth.push_back(models::rotationOf(angles));
    }
}

void readSensors(const AnalysisValues& values, Random& random, const models::RotorFieldConfig& config,
                 Comparison& work) {
    const models::RotorField field(config);
    const models::SensorPoses poses = work.choice.poses();
    const double noise_T = values.numberOr("noise_uT", 0.0) / 1e6;
    const bool isAdditive = work.choice.device.device == models::SphericalDevice::Additive;
    for (const Eigen::Matrix3d& rotation : work.truth) {
        models::SphericalReadings readings_T =
            isAdditive ? models::additiveReadings_T({work.choice.device.strength_T, work.choice.placement},
                                                    models::anglesOf(rotation))
                       : field.readings_T(rotation, poses);
        for (double& reading : readings_T) {
            reading += noise_T * random.gaussian();
        }
        work.readings_T.push_back(readings_T);
    }
}

Result<EstimatorRow> rowOf(const models::AnyEstimatorConfig& config, const Comparison& work) {
    EstimatorRow row{models::EstimatorNames[static_cast<std::size_t>(config.kind)], {}, 0.0, 0};
    const auto estimator = models::makeAnyEstimator(config);
    if (!estimator) {
        const bool isUnsuited = estimator.error().code == ErrorCode::OutOfRange;
        return isUnsuited ? Result<EstimatorRow>(row) : failure(estimator.error());
    }
    // The swarm goes on with its random numbers, so every pose is estimated once.
    std::vector<std::optional<Eigen::Matrix3d>> found;
    for (const models::SphericalReadings& readings_T : work.readings_T) {
        found.push_back((*estimator)(readings_T));
    }
    std::size_t next = 0;
    const models::AnyEstimator replay = [&](const models::SphericalReadings&) { return found[next++]; };
    row.errors = models::estimatorErrors(replay, work.readings_T, work.truth, work.failure_rad);
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
    row.shaft_rms_rad = row.estimated > 0 ? std::sqrt(squares / row.estimated) : 0.0;
    return row;
}

JsonValue rowJson(const EstimatorRow& row) {
    JsonValue document = JsonValue::object();
    document.set("estimator", row.name).set("suits", row.errors.has_value());
    // Without any estimate there is no error either.
    const auto degrees = [&](double value_rad) {
        return row.estimated > 0 ? JsonValue(radiansToDegrees(value_rad)) : JsonValue();
    };
    const models::EstimatorErrors errors = row.errors.value_or(models::EstimatorErrors{});
    document.set("rms_deg", degrees(errors.rms_rad)).set("worst_deg", degrees(errors.worst_rad));
    document.set("shaft_rms_deg", degrees(row.shaft_rms_rad));
    const double share = errors.poses > 0 ? static_cast<double>(errors.failures) / errors.poses : 0.0;
    document.set("failures", row.errors ? JsonValue(errors.failures) : JsonValue());
    return document.set("success_ratio", row.errors ? JsonValue(1.0 - share) : JsonValue());
}

std::string rowText(const EstimatorRow& row) {
    if (!row.errors) {
        return fmt::format("  {:<14} needs sensor 1 at (0, 0, 45) degrees\n", row.name);
    }
    if (row.estimated == 0) {
        return fmt::format("  {:<14} {:>12} {:>12} {:>12} {:>9}\n", row.name, "none", "none", "none",
                           row.errors->failures);
    }
    return fmt::format("  {:<14} {:>12.6g} {:>12.6g} {:>12.6g} {:>9}\n", row.name,
                       radiansToDegrees(row.errors->rms_rad), radiansToDegrees(row.errors->worst_rad),
                       radiansToDegrees(row.shaft_rms_rad), row.errors->failures);
}

Result<AnalysisOutcome> runEstimators(const AnalysisValues& values, const devices::RecordedFile*,
                                      const std::string&, const AnalysisControl& control) {
    Comparison work;
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    work.choice = *choice;
    work.failure_rad = degreesToRadians(values.numberOr("failure_deg", 0.1));
    Random random(static_cast<std::uint64_t>(values.numberOr("rng_seed", 1.0)));
    models::AnyEstimatorConfig config;
    config.sensing.poses = work.choice.poses();
    config.sensing.field.strength_T = work.choice.device.strength_T;
    config.sensing.field.harmonics = models::harmonicPreset(
        static_cast<models::HarmonicPreset>(choiceIndex(HarmonicNames, values.text("harmonics"))));
    config.additive = {work.choice.device.strength_T, work.choice.placement};
    drawPoses(values, random, work);
    readSensors(values, random, config.sensing.field, work);
    config.settings.harmonicPasses = static_cast<int>(values.numberOr("passes", 0.0));
    if (config.settings.harmonicPasses == 0) {
        config.sensing.field.harmonics.clear();
    }
    config.settings.fit.isStrengthFree = !values.isSet("known_strength");
    config.seed = random.bits();
    AnalysisOutcome outcome;
    JsonValue rows = JsonValue::array();
    outcome.summary = fmt::format(
        "{} poses of a device '{}', {} of them in the workspace\n  {:<14} {:>12} {:>12} "
        "{:>12} {:>9}\n",
        work.truth.size(), models::SphericalDeviceNames[static_cast<std::size_t>(work.choice.device.device)],
        work.inside, "estimator", "rms deg", "worst deg", "shaft deg", "failures");
    for (std::size_t kind = 0; kind < models::EstimatorNames.size(); ++kind) {
        if (control.isStopped && control.isStopped()) {
            return failure(ErrorCode::Interrupted, "The comparison was stopped.");
        }
        if (control.onProgress) {
            control.onProgress(static_cast<double>(kind) /
                               static_cast<double>(models::EstimatorNames.size()));
        }
        const std::string only = values.text("only");
        if (!only.empty() && only != "all" && only != models::EstimatorNames[kind]) {
            continue;
        }
        config.kind = static_cast<models::EstimatorKind>(kind);
        const Result<EstimatorRow> row = rowOf(config, work);
        if (!row) {
            return failure(row.error());
        }
        rows.push(rowJson(*row));
        outcome.summary += rowText(*row);
    }
    outcome.body.set("placement", placementJson(work.choice.device, work.choice.placement));
    outcome.body.set("poses", PoseSets[choiceIndex(PoseSets, values.text("poses"))]);
    outcome.body.set("count", static_cast<std::uint64_t>(work.truth.size()));
    outcome.body.set("in_workspace", static_cast<std::uint64_t>(work.inside));
    outcome.body.set("harmonics", HarmonicNames[choiceIndex(HarmonicNames, values.text("harmonics"))]);
    outcome.body.set("passes", config.settings.harmonicPasses);
    outcome.body.set("noise_T", values.numberOr("noise_uT", 0.0) / 1e6);
    outcome.body.set("failure_deg", radiansToDegrees(work.failure_rad)).set("estimators", rows);
    return outcome;
}

} // namespace

Analysis estimatorAnalysis() {
    return {"estimators",
            "halbench.estimators/1",
            "Compare the estimators of a spherical rotor's orientation on the same poses",
            false,
            false,
            estimatorKeys(),
            runEstimators};
}

} // namespace halbench::app
