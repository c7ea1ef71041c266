#include "app/actuators/spherical/sensing_fit.h"

#include "app/actuators/spherical/missing_orientations.h"
#include "app/actuators/spherical/rotation_order.h"
#include "app/actuators/spherical/sensing_signs.h"
#include "control/base/units.h"
#include "models/spherical/calibration_fit.h"
#include "models/spherical/calibration_remainder.h"
#include "models/spherical/orientation_estimator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using models::CalibrationKind;

constexpr double LeastTemperature_K = 2.0;
constexpr double LeastCurrent_A = 0.5;
/// Tolerance of the places in each direction, a cut Gaussian: rms 88 % of 0.1 mm.
constexpr double Place_m = 0.88e-4;
/// A healthy gain is within this; a dead channel has none.
constexpr double LargestGainError_ratio = 0.3;
/// A poor sensor has noise of 1 mT, the largest of resources/help/spherical-theory.md 3.5, found within a
/// fifth.
constexpr double HealthyNoise_T = 1.2e-3;
constexpr double LargestNoise_T = 2e-3;
constexpr std::size_t ListedOrientations = 3;

bool isChosen(const CalibrateConfig& config, Calibration calibration) {
    return std::find(config.which.begin(), config.which.end(), calibration) != config.which.end();
}

void note(CalibrateResult& result, Verdict verdict, const char* code, std::string message, std::string hint) {
    result.quality.verdict = std::max(result.quality.verdict, verdict);
    result.quality.findings.push_back({code, std::move(message), std::move(hint)});
}

const char* unitOf(CalibrationKind kind) {
    switch (kind) {
    case CalibrationKind::Strength:
    case CalibrationKind::Harmonic:
    case CalibrationKind::Offset:
        return "T";
    case CalibrationKind::Turn:
    case CalibrationKind::Direction:
        return "rad";
    case CalibrationKind::Drift:
        return "1/K";
    case CalibrationKind::Coil:
        return "T/A";
    case CalibrationKind::Gain:
    case CalibrationKind::Skew:
        break;
    }
    return "";
}

std::string figureName(const models::CalibrationUnknown& unknown, const models::RotorFieldConfig& field) {
    constexpr std::array Channels = {"r", "theta", "phi"};
    constexpr std::array Pairs = {"r_theta", "r_phi", "theta_phi"};
    constexpr std::array Axes = {"x", "y", "z"};
    const auto c = static_cast<std::size_t>(unknown.component);
    switch (unknown.kind) {
    case CalibrationKind::Strength:
        return "rotor.strength";
    case CalibrationKind::Drift:
        return "rotor.drift";
    case CalibrationKind::Harmonic:
        return fmt::format("rotor.harmonic_{}_{}", field.harmonics[c].degree, field.harmonics[c].order);
    case CalibrationKind::Gain:
        return fmt::format("sensor{}.gain_{}", unknown.sensor, Channels[c]);
    case CalibrationKind::Skew:
        return fmt::format("sensor{}.skew_{}", unknown.sensor, Pairs[c]);
    case CalibrationKind::Offset:
        return fmt::format("sensor{}.offset_{}", unknown.sensor, Channels[c]);
    case CalibrationKind::Turn:
        return fmt::format("sensor{}.turn_{}", unknown.sensor, Axes[c]);
    case CalibrationKind::Direction:
        return fmt::format("sensor{}.place_{}", unknown.sensor, c + 1);
    case CalibrationKind::Coil:
        break;
    }
    return fmt::format("sensor{}.coil_{}", unknown.sensor, Channels[c]);
}

void addFigure(CalibrateResult& result, std::string name, const char* unit, double value, double half95) {
    result.figures.push_back(
        {std::move(name),
         unit,
         {value, std::pair(value - half95, value + half95), control::EstimateSource::Identified, unit}});
}

void addPlainFigure(CalibrateResult& result, const char* name, const char* unit, double value) {
    control::Estimate estimate;
    estimate.value = value;
    estimate.source = control::EstimateSource::Identified;
    estimate.unit = unit;
    result.figures.push_back({name, unit, estimate});
}

/// Turns as the board holds them: those of before and the change, which is small.
void addFigures(CalibrateResult& result, const models::CalibrationFit& fit, const SensingBoard& board,
                const CalibrateConfig& config) {
    for (const models::CalibratedValue& value : fit.values) {
        const bool isCoil = value.unknown.kind == CalibrationKind::Coil;
        if (!isChosen(config, isCoil ? Calibration::Stray : Calibration::Hall)) {
            continue;
        }
        double shown = value.value;
        if (value.unknown.kind == CalibrationKind::Gain) {
            shown -= 1.0; // an error, as the board's parameter
        } else if (value.unknown.kind == CalibrationKind::Turn) {
            const auto i = static_cast<std::size_t>(value.unknown.sensor);
            const Eigen::Matrix3d plain =
                models::sensorPose(models::placementRotation(board.placement[i], board.frames), 1.0).axes;
            shown = models::vectorOfRotation(fit.calibration.sensors[i].pose.axes *
                                             plain.transpose())[value.unknown.component];
        }
        addFigure(result, figureName(value.unknown, fit.calibration.field), unitOf(value.unknown.kind), shown,
                  value.half95);
    }
}

/// rms angle between the orientations of the fit and those that the values from before give.
double errorBefore_rad(const SensedMotion& motion, const SensingBoard& board,
                       const models::CalibrationFit& fit) {
    models::OrientationConfig method;
    method.harmonicPasses = 3; // as the board
    const auto estimator =
        models::OrientationEstimator::make(models::sensingOf(board.calibration, board.deviation_T), method);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; estimator && i < fit.sample.size(); ++i) {
        const models::CalibrationSample& sample = motion.samples[fit.sample[i]];
        const auto was = estimator->estimate(
            models::correctedReadings_T(board.calibration, sample.readings_T, sample.coilCurrent_A),
            sample.used);
        if (was.verdict == models::OrientationVerdict::Determined) {
            const double off_rad = models::symmetricError_rad(was.rotation, fit.rotation[i]);
            sum += off_rad * off_rad;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : std::nan("");
}

/// rms of noise and of what the calibration leaves, over the orientations of the record.
double errorAfter_rad(const models::CalibrationFit& fit, const models::RemainingError& remaining,
                      double noise_T) {
    const auto estimator =
        models::OrientationEstimator::make(models::sensingOf(fit.calibration, noise_T), {});
    if (!estimator || fit.rotation.empty()) {
        return std::nan("");
    }
    double sum = 0.0;
    const std::vector<models::CalibrationUnknown> none;
    const models::CalibrationModel model(fit.calibration, none);
    for (const Eigen::Matrix3d& rotation : fit.rotation) {
        const models::SphericalReadings readings_T =
            models::correctedReadings_T(fit.calibration, model.at(rotation, {}).readings_T);
        sum += estimator->estimate(readings_T).covariance_rad2.trace() +
               remaining.covariance_rad2(rotation).trace();
    }
    return std::sqrt(sum / static_cast<double>(fit.rotation.size()));
}

/// Values fitted to such readings would mean nothing.
bool preventsFit(const Finding& finding) {
    return finding.code == "sensor_missing" || finding.code == "readings_reversed" ||
           finding.code == "references_do_not_fit";
}

/// A few orientations that do not fit are left out and said; with more the model is wrong.
void judgeStrange(CalibrateResult& result, const models::CalibrationFit& fit) {
    constexpr double FewShare = 0.002; // one of 600, the usual record
    constexpr double MostShare = 0.02; // more are not left out
    const std::size_t all = fit.sample.size() + (fit.isStrangeLeftOut ? fit.strange : 0);
    const double share = static_cast<double>(fit.strange) / static_cast<double>(all);
    if (fit.strange == 0) {
        return;
    }
    const Verdict verdict = share > MostShare  ? Verdict::Refused
                            : share > FewShare ? Verdict::Doubtful
                                               : Verdict::Good;
    note(result, verdict, "orientations_do_not_fit",
         fmt::format("{} of {} orientations do not fit the calibrated model", fit.strange, all),
         "Check for harmonics of the field beyond those that are fitted, a loose sensor or iron near the "
         "rotor.");
}

void judge(CalibrateResult& result, const models::CalibrationFit& fit, double noise_T) {
    for (const models::CalibratedValue& value : fit.values) {
        if (value.unknown.kind == CalibrationKind::Gain &&
            std::abs(value.value - 1.0) > LargestGainError_ratio) {
            note(result, Verdict::Refused, "channel_without_field",
                 fmt::format("{} comes out as {:.2f}: the channel is dead, stuck or wired wrongly",
                             value.unknown.name, value.value),
                 "Check the sensor; leave the channel out with channels.off and calibrate again.");
        }
    }
    judgeStrange(result, fit);
    if (noise_T > HealthyNoise_T) {
        note(result, noise_T > LargestNoise_T ? Verdict::Refused : Verdict::Doubtful, "model_does_not_fit",
             fmt::format("the readings differ from the calibrated model by {:.3g} T rms", noise_T),
             "Check for a stuck channel, a changing stray field or iron near the rotor.");
    }
    for (const std::string& text : fit.notes) {
        note(result, Verdict::Good, "not_identifiable", text, "");
    }
}

void judgeMotion(CalibrateResult& result, const SensedMotion& motion, const CalibrateConfig& config) {
    const bool isHall = isChosen(config, Calibration::Hall);
    const bool isStray = isChosen(config, Calibration::Stray);
    if (motion.lostRows > 0) {
        note(result, Verdict::Doubtful, "rows_lost", fmt::format("{} rows are missing", motion.lostRows),
             "measure again");
        nameRowLoss(result.quality, motion.loss);
    }
    if (isHall && motion.temperatureSpan_K < LeastTemperature_K) {
        note(result, Verdict::Good, "drift_not_determined",
             fmt::format("the temperature changed by {:.1f} K only: the drift of the field keeps its value",
                         motion.temperatureSpan_K),
             "Record while the magnet warms up by 2 K or more.");
    }
    if (isStray && motion.currentSpan_A < LeastCurrent_A) {
        note(result, isHall ? Verdict::Good : Verdict::Refused, "coil_not_determined",
             fmt::format("the coil's current changed by {:.2f} A only: its field keeps its value",
                         motion.currentSpan_A),
             "Record with the coil's current switched between 0 and 1 A or more.");
    }
    if (isHall && motion.currentSpan_A < LeastCurrent_A && std::abs(motion.current_A) > LeastCurrent_A) {
        note(result, Verdict::Doubtful, "coil_current_flows",
             fmt::format("{:.2f} A flow through the coil all the time: its field is taken for offsets",
                         motion.current_A),
             "Switch the coil off, or change its current in the record.");
    }
}

/// Channels that never read anything; a sensor without any cannot be calibrated.
void judgeChannels(CalibrateResult& result, const models::ChannelMask& channels) {
    const std::vector<std::string> names = fieldSignals();
    std::string silent;
    std::string sensors;
    for (std::size_t i = 0; i < 3; ++i) {
        int missing = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            missing += !channels[c];
            silent += channels[c] ? "" : (silent.empty() ? "" : ", ") + names[c];
        }
        if (missing == 3) {
            sensors += fmt::format("{}{}", sensors.empty() ? "" : ", ", i);
        }
    }
    if (!sensors.empty()) {
        note(result, Verdict::Refused, "sensor_missing",
             fmt::format("sensor {} gave no reading in the whole record", sensors),
             "Connect it, or check channels.off and its range: the calibration needs all three sensors.");
    } else if (!silent.empty()) {
        note(result, Verdict::Doubtful, "channel_left_out",
             fmt::format("{} gave no reading: its gain and offset keep their values", silent),
             "Leave it out with channels.off, or repair it and calibrate again.");
    }
}

void refuse(CalibrateResult& result, const Error& error, const SensedMotion& motion,
            const SensingBoard& board, const models::CalibrationConfig& config) {
    note(result, Verdict::Refused, "not_determined", error.message, error.hint);
    const auto excitation = models::calibrationExcitation(board.calibration, motion.samples, config);
    if (excitation) {
        std::vector<std::string> missing;
        for (const models::OrientationAngles& angles :
             missingOrientations(board.calibration, *excitation, config, ListedOrientations)) {
            missing.push_back(orientationText(angles));
        }
        note(result, Verdict::Refused, "orientations_missing",
             fmt::format("orientations that are missing most: {} ({})", fmt::join(missing, "; "),
                         orientationOrder()),
             "Move the rotor there too. A simulated rotor moves with motion=tumble or motion=walk in its "
             "address.");
    }
}

Result<models::CalibrationFit> fitWith(const SensedMotion& motion, const SensingBoard& board,
                                       const models::CalibrationConfig& config) {
    auto fit = models::calibrate(board.calibration, motion.samples, config);
    if (!fit || fit->excess_ratio > 0.9) {
        return fit;
    }
    // Less noise than the board was told: intervals of the noise that there is.
    models::CalibrationConfig quieter = config;
    quieter.deviation_T *= std::max(1e-3, fit->excess_ratio);
    return models::calibrate(board.calibration, motion.samples, quieter);
}

} // namespace

models::CalibrationConfig sensingFitConfig(const SensedMotion& motion, const SensingBoard& board,
                                           bool isStray) {
    models::CalibrationConfig config;
    config.deviation_T = board.deviation_T;
    config.selection.harmonics = config.selection.skews = config.selection.directions = true;
    config.selection.drift = motion.temperatureSpan_K >= LeastTemperature_K;
    config.selection.channels = motion.channels;
    config.selection.coil = isStray && motion.currentSpan_A >= LeastCurrent_A;
    config.placeDeviation_rad = Place_m / board.calibration.sensors[0].pose.position_m.norm();
    return config;
}

Result<void> concludeSensing(const SensedMotion& motion, const SensingBoard& board,
                             const CalibrateConfig& asked, const AbortCheck& checkAbort,
                             CalibrateResult& result) {
    const bool isHall = isChosen(asked, Calibration::Hall);
    models::CalibrationConfig config = sensingFitConfig(motion, board, isChosen(asked, Calibration::Stray));
    std::optional<Error> aborted;
    config.isStopped = [&] {
        const Result<void> goOn = checkAbort ? checkAbort() : Result<void>();
        if (!goOn) {
            aborted = goOn.error();
        }
        return aborted.has_value();
    };
    judgeMotion(result, motion, asked);
    judgeChannels(result, motion.channels);
    if (const std::optional<Finding> wrong = contradictingReadings(motion, board)) {
        note(result, Verdict::Refused, wrong->code.c_str(), wrong->message, wrong->hint);
    }
    if (std::any_of(result.quality.findings.begin(), result.quality.findings.end(), preventsFit)) {
        return {};
    }
    const auto fit = fitWith(motion, board, config);
    if (aborted) {
        return failure(*aborted);
    }
    if (!fit && fit.error().code != ErrorCode::Refused) {
        return failure(fit.error());
    }
    if (!fit) {
        config.isStopped = nullptr;
        refuse(result, fit.error(), motion, board, config);
        return {};
    }
    const double noise_T = fit->deviation_T;
    addFigures(result, *fit, board, asked);
    judge(result, *fit, noise_T);
    models::CalibrationRemainder left;
    for (const models::CalibratedValue& value : fit->values) {
        left.unknowns.push_back(value.unknown);
    }
    left.covariance = fit->covariance;
    const models::RemainingError remaining(fit->calibration, std::move(left));
    result.residualBefore_rad = errorBefore_rad(motion, board, *fit);
    result.residualAfter_rad = errorAfter_rad(*fit, remaining, noise_T);
    if (config.selection.coil) {
        result.proposed = coilValues(fit->calibration);
    }
    if (!motion.hasReference) {
        note(result, Verdict::Good, "sign_not_observable",
             "The common sign of all readings is not observable without a known orientation: reversed, they "
             "are those of a rotor that is spun by 90 degrees.",
             "Compare one orientation with the rotor, or record reference.alpha, .beta and .gamma.");
    }
    if (isHall) {
        const double tolerance_T = remaining.readingDeviation_T();
        addPlainFigure(result, "sensor.deviation", "T", noise_T);
        addPlainFigure(result, "sensor.tolerance", "T", tolerance_T);
        note(result, Verdict::Good, "rotation_order",
             fmt::format("the placement angles of a sensor turn it in this order: {}",
                         placementOrder(board.frames)),
             "Its values turn_x, turn_y and turn_z are one rotation vector along the stator's axes.");
        const std::vector<ParameterValue> values = sensingValues(board, fit->calibration);
        result.proposed.insert(result.proposed.end(), values.begin(), values.end());
        result.proposed.push_back({"sensor.deviation", noise_T});
        result.proposed.push_back({"sensor.tolerance", tolerance_T});
        if (config.selection.drift) {
            result.proposed.push_back({"rotor.drift", fit->calibration.drift_per_K});
        }
    }
    return {};
}

} // namespace halbench::app
