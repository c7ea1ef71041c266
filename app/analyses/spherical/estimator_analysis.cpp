#include "app/analyses/spherical/estimator_analysis.h"

#include "app/analyses/spherical/estimator_comparison.h"
#include "app/analyses/spherical/placement_choice.h"
#include "app/analyses/spherical/recorded_rows.h"
#include "app/analyses/spherical/swarm_settings.h"
#include "app/analyses/spherical/trajectory_plots.h"
#include "control/base/units.h"
#include "models/spherical/calibration_remainder.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

constexpr double UsualPasses = 4.0; ///< where the harmonics are known
constexpr std::array<std::string_view, 3> HarmonicNames = {"none", "h1", "h2"};

std::vector<AnalysisKey> estimatorKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = placementKeys();
    const std::vector<AnalysisKey> own = {
        {"poses", Choice, 0, 0, "workspace|trajectory1|trajectory2|trajectory3|trajectory4",
         "random poses of the workspace (default) or a published trajectory of 25"},
        {"count", Integer, 10, 1e6, "",
         "how many random poses or, evenly chosen, rows of a recording; default 2000"},
        {"spin_deg", Number, -180, 180, "", "spin along a trajectory; default 0"},
        {"harmonics", Choice, 0, 0, "none|h1|h2", "harmonics of the device; default none"},
        {"passes", Integer, 0, 20, "", "how often estimators correct them; default 0: they do not know them"},
        {"known_strength", Flag, 0, 0, "", "hold the strength of the field at q_T"},
        {"only", Choice, 0, 0, "all|tensor|projector|refined|lm|closed|closed-fitted|swarm",
         "one estimator; default all"},
        {"noise_uT", Number, 0, 1e5, "",
         "noise of a reading, rms; default 0, of a recording that of its board"},
        {"failure_deg", Number, 1e-9, 180, "", "an error above it is a failure; default 0.1"},
        {"rng_seed", Integer, 0, 4294967295.0, "", "random numbers of poses, noise and swarm; default 1"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    const std::vector<AnalysisKey> search = swarmSettingKeys();
    keys.insert(keys.end(), search.begin(), search.end());
    return keys;
}

struct EstimatorSetup {
    PlacementChoice choice;
    EstimatorComparisonConfig config;
    std::string harmonics = "none";
};

bool runsSwarm(const EstimatorComparisonConfig& config) {
    return !config.only || *config.only == models::EstimatorKind::Swarm;
}

/// The rows, sensors and field of a recording.
Result<void> takeRecording(const AnalysisValues& values, const devices::RecordedFile& file,
                           const std::string& origin, EstimatorSetup& setup) {
    EstimatorComparisonConfig& config = setup.config;
    SensingBoard board = chosenBoard(values).value_or(SensingBoard());
    if (!chosenBoard(values)) {
        board.calibration = models::nominalCalibration(setup.choice.poses(), config.sensing.field);
        board.tolerance_T =
            models::RemainingError(board.calibration, models::assemblyRemainder(board.calibration, {}))
                .readingDeviation_T(); // sensors as assembled
    } else if (values.text("harmonics").empty()) {
        config.sensing.field = board.calibration.field;
        std::erase_if(config.sensing.field.harmonics,
                      [](const auto& term) { return term.amplitude_T == 0.0; });
        const bool isKnown = !config.sensing.field.harmonics.empty();
        config.passes = static_cast<int>(values.numberOr("passes", isKnown ? UsualPasses : 0.0));
        setup.harmonics = isKnown ? "board" : "none";
    }
    Result<RecordedRows> rows = recordedRows(file, origin, board, config.count);
    if (!rows) {
        return failure(rows.error());
    }
    config.rows = std::make_shared<const RecordedRows>(*std::move(rows));
    config.sensing.deviation_T = models::SphericalReadings::Constant(noiseChoice_T(values));
    config.possibleLimit_ratio = rowsLimit_ratio(board, noiseChoice_T(values));
    return {};
}

Result<EstimatorSetup> setupOf(const AnalysisValues& values, const devices::RecordedFile* file,
                               const std::string& origin) {
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    EstimatorSetup setup{
        *choice, {}, std::string(HarmonicNames[choiceIndex(HarmonicNames, values.text("harmonics"))])};
    EstimatorComparisonConfig& config = setup.config;
    config.device = choice->device.device;
    config.sensing.poses = choice->poses();
    config.sensing.field.strength_T = choice->device.strength_T;
    config.sensing.field.harmonics = models::harmonicPreset(
        static_cast<models::HarmonicPreset>(choiceIndex(HarmonicNames, values.text("harmonics"))));
    config.additive = models::additiveModelOf(choice->device, choice->placement);
    config.poses = static_cast<ComparedPoses>(choiceIndex(ComparedPosesNames, values.text("poses")));
    config.count = static_cast<int>(values.numberOr("count", config.count));
    config.keepsPoses = file == nullptr && config.poses != ComparedPoses::Workspace;
    config.spin_rad = degreesToRadians(values.numberOr("spin_deg", 0.0));
    config.passes = static_cast<int>(values.numberOr("passes", 0.0));
    config.isStrengthFree = !values.isSet("known_strength");
    config.noise_T = values.numberOr("noise_uT", 0.0) / 1e6;
    config.failureLimit_rad = degreesToRadians(values.numberOr("failure_deg", 0.1));
    config.seed = static_cast<std::uint64_t>(values.numberOr("rng_seed", 1.0));
    const std::string only = values.text("only");
    if (!only.empty() && only != "all") {
        config.only = static_cast<models::EstimatorKind>(choiceIndex(models::EstimatorNames, only));
    }
    config.swarm = swarmSettings(values);
    if (!runsSwarm(config)) {
        if (auto checked = checkNoSwarmSettings(values, "leave it out, or compare 'swarm' too"); !checked) {
            return failure(checked.error());
        }
    }
    if (const Result<void> taken =
            file == nullptr ? Result<void>() : takeRecording(values, *file, origin, setup);
        !taken) {
        return failure(taken.error());
    }
    return setup;
}

std::string_view nameOf(const ComparedEstimator& row) {
    return models::EstimatorNames[static_cast<std::size_t>(row.kind)];
}

JsonValue rowJson(const ComparedEstimator& row) {
    JsonValue document = JsonValue::object();
    document.set("estimator", nameOf(row)).set("suits", row.errors.has_value());
    // Without any estimate there is no error either.
    const auto degrees = [&](double value_rad) {
        return row.estimated > 0 ? JsonValue(radiansToDegrees(value_rad)) : JsonValue();
    };
    const models::EstimatorErrors errors = row.errors.value_or(models::EstimatorErrors{});
    document.set("rms_deg", degrees(errors.rms_rad)).set("worst_deg", degrees(errors.worst_rad));
    document.set("shaft_rms_deg", degrees(row.shaftRms_rad));
    const double share = errors.poses > 0 ? static_cast<double>(errors.failures) / errors.poses : 0.0;
    document.set("failures", row.errors ? JsonValue(errors.failures) : JsonValue());
    return document.set("success_ratio", row.errors ? JsonValue(1.0 - share) : JsonValue());
}

std::string rowText(const ComparedEstimator& row) {
    if (!row.errors) {
        return fmt::format("  {:<14} {}\n", nameOf(row), row.reason);
    }
    if (row.estimated == 0) {
        return fmt::format("  {:<14} {:>12} {:>12} {:>12} {:>9}\n", nameOf(row), "none", "none", "none",
                           row.errors->failures);
    }
    return fmt::format("  {:<14} {:>12.6g} {:>12.6g} {:>12.6g} {:>9}\n", nameOf(row),
                       radiansToDegrees(row.errors->rms_rad), radiansToDegrees(row.errors->worst_rad),
                       radiansToDegrees(row.shaftRms_rad), row.errors->failures);
}

std::string headOf(const EstimatorComparisonConfig& config, const EstimatorComparison& comparison) {
    const std::string poses =
        config.rows
            ? fmt::format("{} of {} recorded rows{}, compared with {}", comparison.poses, config.rows->rows,
                          config.rows->incomplete > 0
                              ? fmt::format(" ({} without all readings left out)", config.rows->incomplete)
                              : "",
                          comparison.isAgainstTruth ? "their true angles" : "'refined'")
            : fmt::format("{} poses of a device '{}'", comparison.poses,
                          models::SphericalDeviceNames[static_cast<std::size_t>(config.device)]);
    return fmt::format("{}, {} of them in the workspace\n  {:<14} {:>12} {:>12} {:>12} {:>9}\n", poses,
                       comparison.inside, "estimator", "rms deg", "worst deg", "shaft deg", "failures");
}

Result<AnalysisOutcome> runEstimators(const AnalysisValues& values, const devices::RecordedFile* file,
                                      const std::string& origin, const AnalysisControl& control) {
    const Result<EstimatorSetup> setup = setupOf(values, file, origin);
    if (!setup) {
        return failure(setup.error());
    }
    const EstimatorComparisonConfig& config = setup->config;
    const Result<EstimatorComparison> comparison = compareEstimators(config, control, control.now_s);
    if (!comparison) {
        return failure(comparison.error());
    }
    AnalysisOutcome outcome;
    JsonValue rows = JsonValue::array();
    outcome.summary = headOf(config, *comparison);
    for (const ComparedEstimator& row : comparison->estimators) {
        rows.push(rowJson(row));
        outcome.summary += rowText(row);
    }
    outcome.body.set("placement", placementJson(setup->choice.device, setup->choice.placement));
    outcome.body.set("poses", config.rows ? std::string_view("recording")
                                          : ComparedPosesNames[static_cast<std::size_t>(config.poses)]);
    outcome.body.set("compared_with", comparison->isAgainstTruth ? "truth" : "refined");
    outcome.body.set("count", comparison->poses).set("in_workspace", comparison->inside);
    outcome.body.set("harmonics", setup->harmonics);
    outcome.body.set("passes", config.passes);
    outcome.body.set("search", runsSwarm(config) ? swarmJson(config.swarm) : JsonValue());
    outcome.body.set("noise_T", config.rows ? config.sensing.deviation_T[0] : config.noise_T);
    outcome.body.set("failure_deg", radiansToDegrees(config.failureLimit_rad)).set("estimators", rows);
    outcome.plots = trajectoryPlots(*comparison, config.device,
                                    std::string(ComparedPosesNames[static_cast<std::size_t>(config.poses)]));
    outcome.timing = timingText(*comparison);
    return outcome;
}

} // namespace

Analysis estimatorAnalysis() {
    return {"estimators",
            "halbench.estimators/1",
            "Compare the estimators of a spherical rotor's orientation on the same poses",
            RecordingUse::Optional,
            false,
            estimatorKeys(),
            runEstimators,
            sensingDevice(),
            true};
}

} // namespace halbench::app
