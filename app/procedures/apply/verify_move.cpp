#include "app/procedures/apply/verify_move.h"

#include "app/procedures/apply/prediction_monitor.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/axis_zero.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/move/leave_end.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

Result<models::IdealTrace> predict(const ApplyVerification& verification, const control::PositionPlant& plant,
                                   const control::SampledPositionLaw& law) {
    const auto reference = idealReference(verification.reference);
    if (!reference) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("no prediction available for a {}", moveShapeName(verification.reference.shape)),
            "Verify with a step, ramp, sine or staircase.");
    }
    models::IdealLoopConfig loop;
    loop.rotor.inertia_kg_m2 = 1.0; // the motion depends on the ratios to J only
    loop.rotor.viscousDamping_Nm_s = plant.dampingRate_1_s;
    loop.rotor.coulombFriction_Nm = plant.breakawayCurrent_A * plant.accelerationGain_rad_s2_A;
    loop.torqueConstant_Nm_per_A = plant.accelerationGain_rad_s2_A;
    loop.law = law;
    loop.reference = *reference;
    loop.duration_s = verification.duration_s;
    return models::runIdealLoop(loop);
}

// Where friction holds the rotor against the gains depends on how it got there: no prediction can say it.
double frictionBand_rad(const control::PositionPlant& plant, const control::SampledPositionLaw& law) {
    constexpr double StaticFriction_ratio = 1.15; // resources/help/htm-theory.md section 9
    return law.kp_A_per_rad > 0.0
               ? control::frictionBand_rad(StaticFriction_ratio * plant.breakawayCurrent_A, law.kp_A_per_rad,
                                           law.stiction_A, law.stictionThreshold_rad)
               : 0.0;
}

/// Before what else was noticed: it is why the old gains are back.
void refuse(DataQuality& quality, const char* code, const Error& why) {
    quality.verdict = Verdict::Refused;
    quality.findings.insert(quality.findings.begin(), {code, why.message, why.hint});
}

/// Readings of an axis scatter: at rest by so much that a narrower band would refuse what is right. Up to its
/// end tolerance, so that a loop that swings by itself is not excused.
double seenNoise(const ApplyVerification& verification, const MoveFigures& seen) {
    constexpr double Deviations = 4.0; // of some thousand readings one may be that far
    return verification.axis && seen.restRms
               ? std::min(Deviations * *seen.restRms, verification.axis->endTolerance)
               : 0.0;
}

void judge(const ApplyVerification& verification, ApplyResult& result) {
    const MoveFigures& predicted = *result.predicted;
    const MoveFigures& measured = result.verification->measured;
    VerificationBand& band = *result.band;
    const std::string unitOfError = verification.axis ? verification.axis->positionUnit : "rad";
    const auto expect = [&](const char* what, double seen, double allowed, const std::string& unit) {
        if (!(seen <= allowed)) {
            refuse(result.quality, "verification_failed",
                   {ErrorCode::Refused,
                    fmt::format("{}: {:.3g} {}, limit of the prediction {:.3g} {}", what, seen, unit, allowed,
                                unit),
                    "Old values restored. Identify the motor again, or use lower gains."});
        }
    };
    if (predicted.overshoot_percent && measured.overshoot_percent) {
        const double noise_percent =
            100.0 * seenNoise(verification, measured) / std::fabs(verification.reference.amplitude);
        band.allowedOvershoot_percent =
            *predicted.overshoot_percent + verification.overshootTolerance_percent + noise_percent;
        band.allowed_rad =
            std::max(std::fabs(predicted.finalError), band.friction_rad) + verification.errorTolerance_rad;
        expect("overshoot", *measured.overshoot_percent, *band.allowedOvershoot_percent, "%");
        expect("final error", std::fabs(measured.finalError), band.allowed_rad, unitOfError);
    } else {
        constexpr double Margin_ratio = 1.5; // friction scatter is the largest part of a tracking error
        band.allowed_rad =
            Margin_ratio * std::max(predicted.rmsError, band.friction_rad) + verification.errorTolerance_rad;
        expect("rms error", measured.rmsError, band.allowed_rad, unitOfError);
    }
}

/// Measured against predicted at the same time; between two rows of the prediction on the straight line.
void compareCurves(const MoveResult& move, const std::string& position, VerificationBand& band) {
    const Recording& measured = move.recording;
    const std::vector<double> position_rad = measured.column(position);
    const models::IdealTrace& predicted = band.predicted;
    for (std::size_t i = 0; i < position_rad.size(); ++i) {
        const double time_s = measured.time_s[i];
        const auto after = std::lower_bound(predicted.time_s.begin(), predicted.time_s.end(), time_s);
        if (after == predicted.time_s.begin() || after == predicted.time_s.end()) {
            continue;
        }
        const auto next = static_cast<std::size_t>(after - predicted.time_s.begin());
        const double share_ratio =
            (time_s - predicted.time_s[next - 1]) / (predicted.time_s[next] - predicted.time_s[next - 1]);
        const double angle_rad =
            std::lerp(predicted.angle_rad[next - 1], predicted.angle_rad[next], share_ratio);
        const double off_rad = position_rad[i] - move.restPosition - angle_rad;
        if (std::fabs(off_rad) > std::fabs(band.largestOff_rad)) {
            band.largestOff_rad = off_rad;
            band.largestOffTime_s = time_s;
        }
    }
}

/// The motor with its uncertainty; one that was given without any may be off by as much as motors of one make
/// are.
Result<MotorEstimate> withUncertainty(const MotorEstimate& motor) {
    constexpr double Assumed_ratio = 0.05; // 1 sigma of each ratio
    const auto plant = plantFromEstimate(motor);
    if (!plant || !motor.covarianceNames.empty()) {
        return plant ? motor : Result<MotorEstimate>(failure(plant.error()));
    }
    MotorEstimate assumed;
    assumed.values = {{"c_over_J", plant->dampingRate_1_s},
                      {"phi_over_J", plant->accelerationGain_rad_s2_A},
                      {"Kf_over_phi", plant->breakawayCurrent_A}};
    for (const auto& [name, value] : assumed.values) {
        std::vector<double> row(assumed.values.size(), 0.0);
        row[assumed.covarianceNames.size()] = std::pow(Assumed_ratio * value, 2);
        assumed.covarianceNames.push_back(name);
        assumed.covariance.push_back(std::move(row));
    }
    return assumed;
}

/// What the model of an axis leaves out (coil spread, harmonics, the local scale of its pose) is one more
/// uncertainty of its acceleration gain.
MotorEstimate withUnmodelled(MotorEstimate motor) {
    constexpr double Unmodelled_ratio = 0.05; // 1 sigma; planar positioners of one make scatter so
    for (std::size_t i = 0; i < motor.covarianceNames.size(); ++i) {
        if (motor.covarianceNames[i] == "phi_over_J") {
            motor.covariance[i][i] += std::pow(Unmodelled_ratio * motor.values.at("phi_over_J"), 2);
        }
    }
    return motor;
}

/// Where the motion of this law may lie; of a reference that has a prediction.
Result<MotionEnvelope> bandOf(const ApplyVerification& verification, const control::SampledPositionLaw& law) {
    if (verification.band) {
        return *verification.band;
    }
    const auto motor = withUncertainty(verification.motor);
    const auto motors =
        motor ? bandMotors(verification.axis ? withUnmodelled(*motor) : *motor, verification.draws)
              : failure(motor.error());
    if (!motors) {
        return failure(motors.error());
    }
    const control::LoopReference reference = *idealReference(verification.reference);
    std::vector<control::ReferencePoint> points;
    for (int i = 0; i * law.period_s <= verification.duration_s; ++i) {
        points.push_back(control::evaluateReference(reference, i * law.period_s));
    }
    const auto rows = static_cast<std::size_t>(std::lround(1e3 * verification.duration_s)) + 1;
    return expectedMotion(*motors, law, points, rows, verification.bandTolerance_rad);
}

/// The angle of a move in rows 1 ms apart, from where the rotor was: the board may send fewer, and some may
/// be lost. Ends where the recording does.
std::vector<double> everyMillisecond(const MoveResult& result, const std::string& position) {
    constexpr double Row_s = 1e-3;
    const Recording& move = result.recording;
    const std::vector<double> position_rad = move.column(position);
    std::vector<double> angle_rad;
    std::size_t next = 0;
    for (std::size_t row = 0; !position_rad.empty(); ++row) {
        const double time_s = move.time_s.front() + Row_s * static_cast<double>(row);
        while (next < move.time_s.size() && move.time_s[next] < time_s - 1e-9) {
            ++next;
        }
        if (next >= position_rad.size()) {
            break;
        }
        const std::size_t before = next == 0 ? 0 : next - 1;
        const double step_s = move.time_s[next] - move.time_s[before];
        const double share = step_s > 0.0 ? (time_s - move.time_s[before]) / step_s : 1.0;
        angle_rad.push_back(std::lerp(position_rad[before], position_rad[next], share) - result.restPosition);
    }
    return angle_rad;
}

/// A motor that is not the model may end its move where the model does: the whole way must be one that the
/// uncertainty of the model allows.
void judgeWay(const ApplyVerification& verification, const MotionEnvelope& band, const std::string& position,
              ApplyResult& result) {
    const std::vector<double> angle_rad = everyMillisecond(*result.verification, position);
    result.band->widening_ratio = neededWidening_ratio(band, angle_rad, 0.0);
    BandCheck check(band);
    for (std::size_t row = 0; row < angle_rad.size(); ++row) {
        check.add(1e-3 * static_cast<double>(row), angle_rad[row]);
    }
    if (check.departure()) {
        refuse(result.quality, "left_predicted_band",
               verification.axis ? departureError(*check.departure(), *verification.axis)
                                 : departureError(*check.departure()));
    } else if (result.band->widening_ratio > 1.0) {
        refuse(result.quality, "left_predicted_band",
               {ErrorCode::Refused, "more than 5 % of the measured motion outside the predicted band",
                "Old values restored. Identify the motor again, or use lower gains."});
    }
}

/// One sigma of the acceleration gain; of a model without uncertainty what motors of one make differ by.
double gainDeviation_ratio(const MotorEstimate& motor, const control::PositionPlant& plant) {
    constexpr double Assumed_ratio = 0.05;
    for (std::size_t i = 0; i < motor.covarianceNames.size(); ++i) {
        if (motor.covarianceNames[i] == "phi_over_J") {
            return std::sqrt(std::max(0.0, motor.covariance[i][i])) / plant.accelerationGain_rad_s2_A;
        }
    }
    return Assumed_ratio;
}

/// A gain that is not the model's moves the poles of a loop little where the law is strong: position alone
/// does not show it.
void judgeEffort(const ApplyVerification& verification, const control::PositionPlant& plant,
                 const devices::Catalogue& catalogue, ApplyResult& result) {
    constexpr double Start_s = 0.05; // shorter than any loop of a board rises
    if (!verification.axis) {
        return;
    }
    const EffortColumns columns{signalOf(catalogue, verification.axis->roles.position),
                                signalOf(catalogue, verification.axis->roles.effort)};
    const double until_s = std::max(Start_s, 2.0 * result.predicted->riseTime_s.value_or(Start_s));
    std::optional<EffortAgreement>& effort = result.band->effort;
    effort = effortAgreement(result.verification->recording, columns, plant,
                             gainDeviation_ratio(verification.motor, plant), until_s);
    if (effort && !effort->isWithin()) {
        refuse(result.quality, "effort_differs",
               {ErrorCode::Refused,
                fmt::format("the motion took {:.3g} times the effort that the model needs for it, {:.3g} to "
                            "{:.3g} are allowed",
                            effort->ratio, effort->low, effort->high),
                "The old values run again. The mass, the inertia or the force constant is not the one of the "
                "model: identify the axes anew."});
    }
}

/// What of a recording was not seen: rows that are missing inside, and the time after its last one.
struct Unseen {
    double total_s = 0.0;
    double longest_s = 0.0;
};

Unseen unseenOf(const Recording& recording, double duration_s) {
    const std::vector<double>& time_s = recording.time_s;
    if (time_s.size() < 2) {
        return {duration_s, duration_s};
    }
    double period_s = duration_s;
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        period_s = std::min(period_s, time_s[i] - time_s[i - 1]);
    }
    Unseen unseen;
    const auto add = [&](double from_s, double to_s) {
        const double missing_s = to_s - from_s - 1.5 * period_s; // half a period for the rounding of times
        if (missing_s > 0.0) {
            unseen.total_s += missing_s + period_s / 2.0;
            unseen.longest_s = std::max(unseen.longest_s, missing_s + period_s / 2.0);
        }
    };
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        add(time_s[i - 1], time_s[i]);
    }
    add(time_s.back(), duration_s);
    return unseen;
}

/// What the move itself tells of its data speaks of the verification too; a move of which much is missing
/// verifies nothing, however well the rest fits.
void judgeData(const ApplyVerification& verification, ApplyResult& result) {
    constexpr double MostUnseen_ratio = 0.1;
    constexpr double LongestUnseen_ratio = 0.02; // a gap longer than that may hide the overshoot
    const Unseen unseen = unseenOf(result.verification->recording, verification.duration_s);
    DataQuality& quality = result.quality;
    quality = result.verification->quality;
    if (unseen.total_s > MostUnseen_ratio * verification.duration_s ||
        unseen.longest_s > LongestUnseen_ratio * verification.duration_s) {
        quality.verdict = Verdict::Refused;
        quality.findings.push_back(
            {"verification_incomplete",
             fmt::format("only {:.2f} of {:.2f} s of the verification move were recorded",
                         verification.duration_s - unseen.total_s, verification.duration_s),
             "Old values restored. Check that the link is not overloaded, then apply again."});
    }
}

/// The law of the loop that is verified.
Result<control::SampledPositionLaw> lawOnDevice(devices::Device& device,
                                                const ApplyVerification& verification) {
    if (!verification.axis) {
        return readPositionLaw(device);
    }
    auto law = readPositionLaw(device, catalogueOfAxis(device.catalogue(), *verification.axis));
    if (law) {
        law->limit_A = verification.effortLimit;
    }
    return law;
}

std::optional<ApplyVerification> withSeenNoise(const ApplyVerification& verification,
                                               const MoveFigures& seen) {
    const double noise = seenNoise(verification, seen);
    if (noise <= verification.bandTolerance_rad) {
        return std::nullopt;
    }
    ApplyVerification wider = verification;
    wider.bandTolerance_rad = noise;
    return wider;
}

/// An axis with an end may stand at it, since a platen without current glides: it leaves the end, against
/// which its loop would wind up, and steps on towards the middle of its travel, where its zero is.
Result<ApplyVerification> towardsMiddle(devices::Device& device, ApplyVerification verification,
                                        const ProcedureObserver& observer) {
    if (!verification.axis || verification.axis->turnsForever || verification.band) {
        return verification;
    }
    if (auto known = awaitZero(device, observer); !known) {
        return failure(known.error());
    }
    if (auto left = leaveEnd(device, *verification.axis, observer); !left) {
        return failure(left.error());
    }
    const std::string names[] = {signalOf(device.catalogue(), verification.axis->roles.position)};
    const auto position = device.readSignals(names);
    if (!position) {
        return failure(position.error());
    }
    const double distance = std::fabs(verification.reference.amplitude);
    verification.reference.amplitude = position->front() > 0.0 ? -distance : distance;
    return verification;
}

} // namespace

MoveConfig moveOf(const ApplyVerification& verification) {
    MoveConfig config;
    config.reference = verification.reference;
    config.duration_s = verification.duration_s;
    config.axis = verification.axis ? verification.axis->id : std::string();
    return config;
}

Result<void> verifyMove(devices::Device& device, const ApplyVerification& wanted,
                        const ProcedureObserver& observer, ApplyResult& result) {
    if (auto entered = enterState(observer, ProcedureState::Verify); !entered) {
        return entered;
    }
    const auto placed = towardsMiddle(device, wanted, observer);
    if (!placed) {
        return failure(placed.error());
    }
    const ApplyVerification& verification = *placed;
    const auto plant = plantFromEstimate(verification.motor);
    if (!plant) {
        return failure(plant.error());
    }
    const auto law = lawOnDevice(device, verification);
    if (!law) {
        return failure(law.error());
    }
    auto trace = predict(verification, *plant, *law);
    if (!trace) {
        return failure(trace.error());
    }
    const auto predicted =
        measureMove({trace->time_s, trace->reference_rad, trace->angle_rad}, moveOf(verification));
    if (!predicted) {
        return failure(predicted.error());
    }
    auto band = bandOf(verification, *law);
    if (!band) {
        return failure(band.error());
    }
    ProcedureObserver quiet = observer;
    quiet.onState = nullptr; // all of the move is one state here
    const auto seen = performMove(device, moveOf(verification), quiet);
    if (!seen) {
        return failure(seen.error());
    }
    if (const auto wider = withSeenNoise(verification, seen->measured)) {
        band = bandOf(*wider, *law);
    }
    result.predicted = *predicted;
    result.verification = *seen;
    result.band.emplace();
    result.band->predicted = *std::move(trace);
    result.band->friction_rad = frictionBand_rad(*plant, *law);
    const std::string position =
        verification.axis ? signalOf(device.catalogue(), verification.axis->roles.position) : "position";
    compareCurves(*seen, position, *result.band);
    judgeData(verification, result);
    judgeWay(verification, *band, position, result);
    judgeEffort(verification, *plant, device.catalogue(), result);
    judge(verification, result);
    return {};
}

} // namespace halbench::app
