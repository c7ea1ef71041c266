#include "app/analyses/spherical/orientation_analysis.h"

#include "app/analyses/spherical/orientation_confidence.h"
#include "app/analyses/spherical/orientation_quality.h"
#include "app/analyses/spherical/swarm_settings.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/result_text.h"
#include "control/base/units.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/orientation_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace halbench::app {

namespace {

constexpr std::array VerdictNames = {"determined", "reduced", "ambiguous", "not_determined", "not_converged"};
constexpr std::array GapNames = {"", "singular", "not_settled", "model_does_not_fit"};
constexpr std::size_t ListedPoses = 1000;
constexpr std::size_t ListedProblems = 50;
constexpr std::size_t RowsBetweenQuestions = 256;

std::vector<AnalysisKey> orientationKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = {
        {"readings", Text, 0, 0, "", "nine signals, R, Theta, Phi of sensors 0, 1, 2; default field.0.r ..."},
        {"estimator", Choice, 0, 0, "refined|tensor|projector|lm|closed|closed-fitted|swarm",
         "estimator; default refined"},
    };
    for (const AnalysisKey& key : placementKeys()) {
        if (key.name != "device") { // the estimator says what it believes
            keys.push_back(key);
        }
    }
    const std::vector<AnalysisKey> own = {
        {"harmonics", Choice, 0, 0, "none|h1|h2", "harmonics of the field that are corrected; default none"},
        {"passes", Integer, 0, 20, "",
         "how often they are predicted and subtracted; default 4 with harmonics"},
        {"range_mT", Number, 1, 1e4, "", "range of the sensors: readings at its end are left out"},
        {"stray", Flag, 0, 0, "", "estimate a uniform stray field too"},
        {"known_strength", Flag, 0, 0, "", "hold the strength of the field at q_T"},
        {"truth", Flag, 0, 0, "", "compare with the true angles in the recording"},
        {"truth_signals", Text, 0, 0, "", "their names; default truth.alpha,truth.beta,truth.gamma"},
        {"rng_seed", Integer, 0, 4294967295.0, "", "random numbers of the swarm; default 1"},
    };
    const std::vector<AnalysisKey> confidence = confidenceKeys();
    keys.insert(keys.end(), confidence.begin(), confidence.end());
    keys.insert(keys.end(), own.begin(), own.end());
    const std::vector<AnalysisKey> search = swarmSettingKeys();
    keys.insert(keys.end(), search.begin(), search.end());
    return keys;
}

models::SphericalSensing sensingFrom(const AnalysisValues& values, const Orientation& work) {
    models::SphericalSensing sensing = work.confidence->sensing(work.confidence->deviation_T());
    sensing.hasUniformField = values.isSet("stray");
    sensing.rotorRadius_m = work.choice.device.rotorRadius_m;
    return sensing;
}

/// The closed form and the swarm believe the additive model, which has neither harmonics nor a stray field: a
/// setting that changes nothing would be believed to have done its work.
Result<void> checkTensorSettings(const AnalysisValues& values, models::EstimatorKind kind) {
    if (kind < models::EstimatorKind::Closed) {
        return {};
    }
    const std::string harmonics = values.text("harmonics");
    const std::pair<const char*, bool> given[] = {{"--stray", values.isSet("stray")},
                                                  {"--passes", values.number("passes").has_value()},
                                                  {"--harmonics", !harmonics.empty() && harmonics != "none"},
                                                  {"--known-strength", values.isSet("known_strength")}};
    for (const auto& [option, isGiven] : given) {
        if (isGiven) {
            return failure(
                ErrorCode::Usage,
                fmt::format("{} means nothing to the estimator {}, which takes the device for an additive "
                            "one",
                            option, models::EstimatorNames[static_cast<std::size_t>(kind)]),
                "leave it out, or use --estimator refined");
        }
    }
    return {};
}

void finish(OrientedPose& pose) {
    pose.angles = models::anglesOf(pose.estimate.rotation);
    pose.shaft = models::shaftOf(pose.estimate.rotation);
    if (pose.hasUncertainty) {
        pose.interval = models::angleIntervals95(pose.angles, pose.estimate.covariance_rad2);
        pose.cone_rad = models::shaftCone95_rad(pose.estimate.rotation, pose.estimate.covariance_rad2);
    }
}

using PoseSolver = std::function<OrientedPose(std::size_t row)>;

/// Errors of the readings over the smallest singular value: by so much the tensor errs where it and a uniform
/// field are hardest to tell apart.
double tensorErrorWithStray_ratio(const models::SphericalSensing& sensing,
                                  const OrientationConfidence& sensors) {
    const double error_T = sensors.deviation_T() * std::sqrt(1.0 + sensors.errorShare());
    return error_T / models::TensorSystem(sensing).smallestSingularValue() / sensing.field.strength_T;
}

Result<PoseSolver> tensorSolver(const AnalysisValues& values, Orientation& work) {
    models::OrientationConfig config;
    config.method = static_cast<models::OrientationMethod>(static_cast<int>(work.kind));
    const models::SphericalSensing sensing = sensingFrom(values, work);
    config.harmonicPasses =
        static_cast<int>(values.numberOr("passes", sensing.field.harmonics.empty() ? 0 : 4));
    config.fit.isStrengthFree = !values.isSet("known_strength");
    config.possibleLimit_ratio = 1.0 + work.confidence->errorShare();
    auto estimator = models::OrientationEstimator::make(sensing, config);
    if (!estimator) {
        return failure(estimator.error());
    }
    work.tensorError_ratio =
        sensing.hasUniformField ? tensorErrorWithStray_ratio(sensing, *work.confidence) : 0.0;
    const double possible = config.chiSquareLimit * config.possibleLimit_ratio;
    return PoseSolver([estimator = *std::move(estimator), possible, &work](std::size_t row) {
        OrientedPose pose;
        pose.estimate = estimator.estimate(work.confidence->corrected_T(work.readings.readings_T[row],
                                                                        work.readings.used[row],
                                                                        work.readings.coilCurrent_A[row]),
                                           work.readings.used[row]);
        if (pose.isOriented() && pose.estimate.freedom > 0 && pose.estimate.chiSquare > possible) {
            pose.estimate.verdict = models::OrientationVerdict::NotConverged;
        }
        pose.hasUncertainty = pose.isOriented();
        if (pose.hasUncertainty) {
            pose.estimate.covariance_rad2 = work.confidence->covariance_rad2(pose.estimate);
        }
        return pose;
    });
}

/// Cone, intervals and misfit of an estimate of the additive model. Chi-square is that of the noise alone, as
/// with the others.
void judgeAdditive(const models::AdditiveModel& model, const models::AdditiveEstimate& found,
                   const models::SphericalReadings& readings_T, const Orientation& work, OrientedPose& pose) {
    const double share = work.confidence->errorShare();
    const double deviation_T = work.confidence->deviation_T() * std::sqrt(1.0 + share);
    const models::AdditiveUncertainty known =
        models::additiveUncertainty(model, work.choice.poses(), found, readings_T, deviation_T);
    pose.gap = known.gap;
    pose.hasUncertainty = known.gap == models::UncertaintyGap::None;
    pose.estimate.covariance_rad2 = known.covariance_rad2;
    pose.estimate.chiSquare = known.chiSquare * (1.0 + share);
    pose.estimate.freedom = models::AdditiveFreedom;
    pose.misfit_ratio =
        (models::additiveReadings_T(model, found.angles) - readings_T).norm() / readings_T.norm();
}

/// Estimators of the additive model take all nine readings.
Result<PoseSolver> additiveSolver(const AnalysisValues& values, const Orientation& work) {
    models::AnyEstimatorConfig config;
    config.kind = work.kind;
    config.additive = models::additiveModelOf(work.choice.device, work.choice.placement);
    config.swarm = work.swarm;
    config.seed = static_cast<std::uint64_t>(values.numberOr("rng_seed", 1.0));
    auto estimator = models::makeAdditiveEstimator(config);
    if (!estimator) {
        return failure(estimator.error());
    }
    return PoseSolver([estimator = *std::move(estimator), model = config.additive, &work](std::size_t row) {
        OrientedPose pose;
        if (work.readings.used[row] == models::AllChannels) {
            const models::SphericalReadings readings_T = work.confidence->corrected_T(
                work.readings.readings_T[row], work.readings.used[row], work.readings.coilCurrent_A[row]);
            const std::optional<models::AdditiveEstimate> found = estimator(readings_T);
            pose.estimate.verdict =
                found ? models::OrientationVerdict::Determined : models::OrientationVerdict::NotConverged;
            pose.estimate.strength_T = work.choice.device.strength_T;
            if (found) {
                pose.estimate.rotation = models::representative(models::rotationOf(found->angles));
                judgeAdditive(model, *found, readings_T, work, pose);
            }
        }
        return pose;
    });
}

Result<void> solveAll(const AnalysisValues& values, const AnalysisControl& control, Orientation& work) {
    const Result<PoseSolver> solver =
        work.isTensor() ? tensorSolver(values, work) : additiveSolver(values, work);
    if (!solver) {
        return failure(solver.error());
    }
    const std::size_t rows = work.readings.time_s.size();
    work.poses.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        if (row % RowsBetweenQuestions == 0) {
            if (control.isStopped && control.isStopped()) {
                return failure(ErrorCode::Interrupted, "The estimation was stopped.");
            }
            if (control.onProgress) {
                control.onProgress(static_cast<double>(row) / static_cast<double>(rows));
            }
        }
        OrientedPose pose = (*solver)(row);
        if (!work.readings.truth.empty() && pose.isOriented()) {
            const Eigen::Matrix3d truth = models::rotationOf(work.readings.truth[row]);
            pose.error_rad = models::symmetricError_rad(pose.estimate.rotation, truth);
            // Told as the image of the truth: the others are the same field.
            pose.estimate.rotation = models::nearestImage(pose.estimate.rotation, truth);
        }
        finish(pose);
        work.poses.push_back(pose);
    }
    return {};
}

JsonValue chiSquareJson(const Orientation& work) {
    const auto chi = ofPoses(work, [](const OrientedPose& pose) {
        return pose.hasUncertainty ? pose.estimate.chiSquare : Missing;
    });
    if (chi.empty()) {
        return {};
    }
    double freedom = 0.0;
    for (const OrientedPose& pose : work.poses) {
        freedom += pose.hasUncertainty ? pose.estimate.freedom : 0;
    }
    JsonValue document = JsonValue::object();
    const double count = static_cast<double>(chi.size());
    document.set("mean", std::accumulate(chi.begin(), chi.end(), 0.0) / count);
    document.set("freedom", freedom / count);
    return document.set("highest", *std::max_element(chi.begin(), chi.end()));
}

JsonValue spreadJson(const std::vector<double>& values_rad) {
    if (values_rad.empty()) {
        return {};
    }
    JsonValue document = JsonValue::object();
    document.set("median", radiansToDegrees(percentile(values_rad, 0.5)));
    return document.set("highest", radiansToDegrees(*std::max_element(values_rad.begin(), values_rad.end())));
}

JsonValue truthJson(const Orientation& work) {
    const auto error = ofPoses(work, [](const OrientedPose& pose) { return pose.error_rad; });
    if (error.empty()) {
        return {};
    }
    double squares = 0.0;
    for (const double value : error) {
        squares += value * value;
    }
    std::size_t worst = 0;
    for (std::size_t row = 0; row < work.poses.size(); ++row) {
        const bool isWorse = std::isfinite(work.poses[row].error_rad) &&
                             !(work.poses[row].error_rad <= work.poses[worst].error_rad);
        worst = isWorse ? row : worst;
    }
    JsonValue document = JsonValue::object();
    document.set("poses", static_cast<std::uint64_t>(error.size()));
    document.set("rms_deg", radiansToDegrees(std::sqrt(squares / static_cast<double>(error.size()))));
    document.set("p999_deg", radiansToDegrees(percentile(error, 0.999)));
    document.set("worst_deg", radiansToDegrees(work.poses[worst].error_rad));
    document.set("worst_at_s", work.readings.time_s[worst]);
    const auto wrong =
        std::count_if(error.begin(), error.end(), [](double e) { return e > BranchLimit_rad; });
    return document.set("wrong_branches", static_cast<std::int64_t>(wrong));
}

JsonValue poseJson(const Orientation& work, std::size_t row) {
    const OrientedPose& pose = work.poses[row];
    JsonValue document = JsonValue::object();
    document.set("time_s", work.readings.time_s[row]);
    document.set("verdict", VerdictNames[static_cast<std::size_t>(pose.estimate.verdict)]);
    const bool isKnown = pose.isOriented();
    const auto angle = [&](const char* name, double value_rad, bool isGiven) {
        document.set(name, isGiven ? JsonValue(radiansToDegrees(value_rad)) : JsonValue());
    };
    angle("alpha_deg", pose.angles.alpha_rad, isKnown);
    angle("beta_deg", pose.angles.beta_rad, isKnown);
    angle("gamma_deg", pose.angles.gamma_rad, isKnown);
    angle("alpha_half95_deg", pose.interval.alpha_rad, pose.hasUncertainty);
    angle("beta_half95_deg", pose.interval.beta_rad, pose.hasUncertainty);
    angle("gamma_half95_deg", pose.interval.gamma_rad, pose.hasUncertainty);
    angle("theta_deg", pose.shaft.theta_rad, isKnown);
    angle("phi_deg", pose.shaft.phi_rad, isKnown);
    angle("cone95_deg", pose.cone_rad, pose.hasUncertainty);
    document.set("cone95_missing", pose.gap == models::UncertaintyGap::None
                                       ? JsonValue()
                                       : JsonValue(GapNames[static_cast<std::size_t>(pose.gap)]));
    document.set("chi_square", pose.hasUncertainty ? JsonValue(pose.estimate.chiSquare) : JsonValue());
    angle("error_deg", pose.error_rad, std::isfinite(pose.error_rad));
    if (pose.estimate.verdict == models::OrientationVerdict::Ambiguous) {
        const auto one = models::anglesOf(pose.estimate.rotation);
        const auto other = models::anglesOf(models::representative(pose.estimate.other));
        JsonValue images = JsonValue::array();
        images.push(anglesJson(one.alpha_rad, one.beta_rad, one.gamma_rad));
        document.set("possible", images.push(anglesJson(other.alpha_rad, other.beta_rad, other.gamma_rad)));
    }
    return document;
}

JsonValue toBody(const Orientation& work) {
    JsonValue body = JsonValue::object();
    body.set("estimator", models::EstimatorNames[static_cast<std::size_t>(work.kind)]);
    body.set("search", work.kind == models::EstimatorKind::Swarm ? swarmJson(work.swarm) : JsonValue());
    body.set("noise_T", work.confidence->deviation_T());
    body.set("placement", placementJson(work.choice.device, work.choice.placement));
    body.set("rows", static_cast<std::uint64_t>(work.poses.size()));
    for (std::size_t i = 0; i < VerdictNames.size(); ++i) {
        body.set(VerdictNames[i],
                 static_cast<std::uint64_t>(work.count(static_cast<models::OrientationVerdict>(i))));
    }
    const auto strength = ofPoses(work, [](const OrientedPose& pose) { return pose.estimate.strength_T; });
    body.set("strength_T", finiteOrNull(percentile(strength, 0.5)));
    body.set("chi_square", chiSquareJson(work));
    body.set("cone95_deg", spreadJson(ofPoses(work, [](const OrientedPose& p) { return p.cone_rad; })));
    JsonValue intervals = JsonValue::object();
    const auto half = [&](const char* name, double models::AngleIntervals::*angle) {
        intervals.set(name, spreadJson(ofPoses(work, [angle](const OrientedPose& pose) {
                          return pose.hasUncertainty ? pose.interval.*angle : Missing;
                      })));
    };
    half("alpha", &models::AngleIntervals::alpha_rad);
    half("beta", &models::AngleIntervals::beta_rad);
    half("gamma", &models::AngleIntervals::gamma_rad);
    body.set("half95_deg", intervals).set("truth", truthJson(work));
    const std::size_t step = 1 + (work.poses.size() - 1) / ListedPoses;
    JsonValue poses = JsonValue::array();
    JsonValue problems = JsonValue::array();
    for (std::size_t row = 0; row < work.poses.size(); ++row) {
        if (row % step == 0) {
            poses.push(poseJson(work, row));
        }
        if (work.poses[row].estimate.verdict != models::OrientationVerdict::Determined &&
            problems.items().size() < ListedProblems) {
            problems.push(poseJson(work, row));
        }
    }
    body.set("poses_step", static_cast<std::uint64_t>(step)).set("poses", poses);
    return body.set("problems", problems);
}

AnalysisTable toTable(const Orientation& work) {
    AnalysisTable table;
    table.columns = {"time_s",          "alpha_rad",        "beta_rad",   "gamma_rad",  "theta_rad",
                     "phi_rad",         "strength_T",       "chi_square", "cone95_rad", "alpha_half95_rad",
                     "beta_half95_rad", "gamma_half95_rad", "verdict",    "error_rad"};
    for (std::size_t row = 0; row < work.poses.size(); ++row) {
        const OrientedPose& pose = work.poses[row];
        const auto known = [&](double value) { return pose.isOriented() ? value : Missing; };
        const auto sure = [&](double value) { return pose.hasUncertainty ? value : Missing; };
        table.values.insert(
            table.values.end(),
            {work.readings.time_s[row], known(pose.angles.alpha_rad), known(pose.angles.beta_rad),
             known(pose.angles.gamma_rad), known(pose.shaft.theta_rad), known(pose.shaft.phi_rad),
             known(pose.estimate.strength_T), sure(pose.estimate.chiSquare), sure(pose.cone_rad),
             sure(pose.interval.alpha_rad), sure(pose.interval.beta_rad), sure(pose.interval.gamma_rad),
             static_cast<double>(pose.estimate.verdict), pose.error_rad});
    }
    return table;
}

/// The angles over the time, beside the true ones.
AnalysisPlot anglesPlot(const Orientation& work) {
    constexpr std::array Names = {"alpha", "beta", "gamma"};
    constexpr std::array Angles = {&models::OrientationAngles::alpha_rad,
                                   &models::OrientationAngles::beta_rad,
                                   &models::OrientationAngles::gamma_rad};
    AnalysisPlot plot;
    plot.title = "Orientation, M = Rx(alpha) Ry(beta) Rz(gamma)";
    plot.x = {"time", "s"};
    const std::size_t step = 1 + (work.poses.size() - 1) / ListedPoses;
    const bool hasTruth = !work.readings.truth.empty();
    for (std::size_t angle = 0; angle < Angles.size(); ++angle) {
        AnalysisCurve truth{"true", {}, {}};
        AnalysisCurve found{hasTruth ? "estimated" : "", {}, {}, true};
        for (std::size_t row = 0; row < work.poses.size(); row += step) {
            const double time_s = work.readings.time_s[row];
            if (hasTruth) {
                truth.x.push_back(time_s);
                truth.y.push_back(radiansToDegrees(work.readings.truth[row].*Angles[angle]));
            }
            if (work.poses[row].isOriented()) {
                found.x.push_back(time_s);
                found.y.push_back(radiansToDegrees(work.poses[row].angles.*Angles[angle]));
            }
        }
        AnalysisPanel panel{{Names[angle], "deg"}, {found}};
        if (hasTruth) {
            panel.curves.push_back(truth);
        }
        plot.panels.push_back(panel);
    }
    return plot;
}

/// Errors of all rows, modulo the symmetry.
AnalysisPlot errorPlot(const Orientation& work) {
    AnalysisCurve error{"", {}, {}};
    const std::size_t step = 1 + (work.poses.size() - 1) / ListedPoses;
    for (std::size_t row = 0; row < work.poses.size(); row += step) {
        error.x.push_back(work.readings.time_s[row]);
        error.y.push_back(radiansToDegrees(work.poses[row].error_rad));
    }
    return {"Error of the orientation", {"time", "s"}, {{{"error", "deg"}, {error}}}};
}

std::string summaryOf(const Orientation& work, const DataQuality& quality) {
    std::string text =
        fmt::format("orientation by '{}', {} rows\n",
                    models::EstimatorNames[static_cast<std::size_t>(work.kind)], work.poses.size());
    for (std::size_t i = 0; i < VerdictNames.size(); ++i) {
        if (const std::size_t count = work.count(static_cast<models::OrientationVerdict>(i));
            count > 0 || i == 0) {
            text += fmt::format("  {:<22} {}\n", VerdictNames[i], count);
        }
    }
    const auto line = [&](const char* name, double value, const char* unit) {
        if (std::isfinite(value)) {
            text += fmt::format("  {:<22} {:.6g} {}\n", name, value, unit);
        }
    };
    const auto median = [&](auto value) { return percentile(ofPoses(work, value), 0.5); };
    line("strength q", median([](const OrientedPose& pose) { return pose.estimate.strength_T; }), "T");
    line("95 % cone of the shaft",
         radiansToDegrees(median([](const OrientedPose& pose) { return pose.cone_rad; })), "deg");
    const JsonValue truth = truthJson(work);
    if (const JsonValue* rms = truth.find("rms_deg")) {
        text += "  errors modulo the symmetry of the rotor\n";
        line("  rms", rms->number(), "deg");
        line("  99.9 %", truth.find("p999_deg")->number(), "deg");
        line("  worst", truth.find("worst_deg")->number(), "deg");
        text += fmt::format("  {:<22} {}\n", "  wrong branches", truth.find("wrong_branches")->number());
    }
    return text + findingLines(quality);
}

Result<AnalysisOutcome> runOrientation(const AnalysisValues& values, const devices::RecordedFile* file,
                                       const std::string& origin, const AnalysisControl& control) {
    Orientation work;
    const std::string estimator = values.text("estimator");
    work.kind = static_cast<models::EstimatorKind>(
        choiceIndex(models::EstimatorNames, estimator.empty() ? "refined" : estimator));
    if (work.kind == models::EstimatorKind::Swarm) {
        work.swarm = swarmSettings(values);
    } else if (auto checked = checkNoSwarmSettings(values, "add --estimator swarm, or leave it out");
               !checked) {
        return failure(checked.error());
    }
    if (auto checked = checkTensorSettings(values, work.kind); !checked) {
        return failure(checked.error());
    }
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    work.choice = *choice;
    const Result<OrientationConfidence> confidence = OrientationConfidence::make(values, work.choice);
    if (!confidence) {
        return failure(confidence.error());
    }
    work.confidence = *confidence;
    Result<OrientationReadings> readings = orientationReadings(values, *file, origin);
    if (!readings) {
        return failure(readings.error());
    }
    work.readings = *std::move(readings);
    if (const Result<void> solved = solveAll(values, control, work); !solved) {
        return failure(solved.error());
    }
    AnalysisOutcome result;
    result.quality = qualityOf(work);
    result.body = toBody(work);
    result.summary = summaryOf(work, result.quality);
    result.table = toTable(work);
    result.plots.push_back(anglesPlot(work));
    if (!work.readings.truth.empty()) {
        result.plots.push_back(errorPlot(work));
    }
    return result;
}

/// Nine readings, and with `truth` the true angles that a simulated device has.
std::vector<std::string> recordedSignals(const AnalysisValues& values) {
    std::vector<std::string> signals = splitList(values.text("readings"));
    if (signals.empty()) {
        signals = fieldSignals();
    }
    if (values.isSet("truth")) {
        const std::string truth = values.text("truth_signals");
        const std::vector<std::string> names =
            splitList(truth.empty() ? UsualTruthSignals : std::string_view(truth));
        signals.insert(signals.end(), names.begin(), names.end());
    }
    return signals;
}

} // namespace

Analysis orientationAnalysis() {
    AnalysisDevice device = sensingDevice();
    device.signals = recordedSignals;
    device.extraSignals = {"coil.current", "channels_left_out"};
    return {"orient",
            "halbench.orientation/1",
            "Orientation of a spherical rotor from nine field readings, recorded or of a device",
            RecordingUse::Required,
            true,
            orientationKeys(),
            runOrientation,
            device,
            true};
}

} // namespace halbench::app
