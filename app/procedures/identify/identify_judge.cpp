#include "app/procedures/identify/identify_estimate.h"
#include "app/procedures/identify/identify_friction_law.h"
#include "app/procedures/identify/identify_physics.h"
#include "app/procedures/identify/identify_steady_line.h"
#include "app/procedures/identify/identify_torque_law.h"
#include "control/base/counted.h"
#include "control/base/distributions.h"
#include "control/identify/added_inertia.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::MotorConstant;

// Current that really flows: gain of the two converters 0.2 % each, their bow of up to two codes 0.06 %
// (resources/help/htm-theory.md section 9); it cannot show in angle or speed. Where the user states a
// tolerance, it stands in for this one.
constexpr double CurrentError_ratio = 1.5e-3;
// Torque constant per kelvin of the magnets; they are at ambient, which the coils show before they warm up.
constexpr double MagnetTemperature_per_K = 1.2e-3;
constexpr double ThermometerError_K = 1.0;
constexpr double Improbable = 0.01;

control::TorqueScaleError torqueErrorOf(const IdentifyFits& fits, const IdentifyConfig& config) {
    const double away_K = std::fabs(fits.startTemperature_degC - 25.0);
    const double magnets_ratio = MagnetTemperature_per_K * std::max(away_K, ThermometerError_K);
    if (!config.currentTolerance_percent) {
        return {std::hypot(CurrentError_ratio, magnets_ratio), 0.0};
    }
    // The torque per commanded ampere is phi (1 + e) with |e| <= t: phi lies within t/(1 - t) of it.
    const double tolerance_ratio = *config.currentTolerance_percent / 100.0;
    return {magnets_ratio, tolerance_ratio / (1.0 - tolerance_ratio)};
}

void remark(DataQuality& quality, Verdict verdict, std::string code, std::string message, std::string hint) {
    quality.verdict = std::max(quality.verdict, verdict);
    quality.findings.push_back({std::move(code), std::move(message), std::move(hint)});
}

std::optional<control::MotorRatios> ratiosOf(const IdentifyFits& fits, const IdentifyConfig& config) {
    if (fits.motion) {
        return control::motorRatios(*fits.motion, fits.balance, torqueErrorOf(fits, config));
    }
    if (fits.sweep) {
        return control::motorRatios(*fits.sweep, torqueErrorOf(fits, config));
    }
    return std::nullopt;
}

void takeEstimate(IdentifyResult& result, const control::JointEstimate& joint) {
    const auto at = [&joint](MotorConstant constant) {
        return joint.constants[static_cast<std::size_t>(constant)];
    };
    result.inertia = at(MotorConstant::Inertia);
    result.viscousDamping = at(MotorConstant::Damping);
    result.coulombFriction = at(MotorConstant::Friction);
    result.torqueConstant = at(MotorConstant::Torque);
    result.ratios = joint.ratios;
    result.covarianceNames = joint.covarianceNames;
    result.covariance.clear();
    for (Eigen::Index row = 0; row < joint.covariance.rows(); ++row) {
        const Eigen::RowVectorXd values = joint.covariance.row(row);
        result.covariance.emplace_back(values.data(), values.data() + values.size());
    }
}

void takeAsymmetry(IdentifyResult& result, const IdentifyFits& fits) {
    std::optional<double> value;
    double error = 0.0;
    double freedom = 0.0;
    if (fits.balance && fits.balance->asymmetry) {
        value = fits.balance->asymmetry;
        error = fits.balance->asymmetryError;
        freedom = std::max(fits.balance->freedom, 1);
    } else if (fits.sweep && fits.sweep->asymmetry) {
        value = fits.sweep->asymmetry;
        error = fits.sweep->asymmetryError;
        freedom = fits.sweep->freedom;
    }
    if (!value || std::fabs(*value) > 1.0) { // almost no friction: one direction came out below zero
        return;
    }
    const double half = control::studentQuantile(0.975, freedom) * error;
    result.asymmetry =
        control::Estimate{*value, std::pair(std::max(*value - half, -1.0), std::min(*value + half, 1.0)),
                          control::EstimateSource::Identified, ""};
    if (std::fabs(*value) > std::max(half, smallestAsymmetry(fits, CurrentError_ratio))) {
        remark(result.quality, Verdict::Good, "friction_asymmetry",
               fmt::format("friction differs between the directions by {:.1f} % of its mean",
                           200.0 * std::fabs(*value)),
               "the mean of both directions is reported");
    }
}

void judgeAmount(IdentifyResult& result, const IdentifyFits& fits) {
    if (fits.stoppedPlateaus > 0) {
        remark(result.quality, Verdict::Good, "plateaus_stopped",
               counted(fits.stoppedPlateaus, "one plateau came to rest and was excluded",
                       "{} plateaus came to rest and were excluded"),
               "start the sweep further above the breakaway current");
    }
    if (fits.slowPlateaus > 0) {
        remark(result.quality, Verdict::Good, "plateaus_too_slow",
               counted(fits.slowPlateaus,
                       "one plateau was too slow to distinguish friction from creep and was excluded",
                       "{} plateaus were too slow to distinguish friction from creep and were excluded"),
               "start the sweep further above the breakaway current");
    }
    if (fits.unsteadyPlateaus > 0) {
        constexpr double ManyOfThem = 0.25;
        const bool areMany =
            static_cast<double>(fits.unsteadyPlateaus) > ManyOfThem * static_cast<double>(fits.points.size());
        remark(result.quality, areMany ? Verdict::Doubtful : Verdict::Good, "plateaus_not_steady",
               counted(fits.unsteadyPlateaus, "one plateau was not steady at its end and was excluded",
                       "{} plateaus were not steady at their end and were excluded"),
               "use a longer time at each current");
    }
    if (fits.lostRows > 0) {
        remark(
            result.quality, Verdict::Doubtful, "rows_lost",
            counted(fits.lostRows, "one row of the recording was lost", "{} rows of the recording were lost"),
            "");
    }
    if (!fits.motion && !fits.motionProblem.empty()) {
        remark(result.quality, Verdict::Good, "no_transients",
               "run-ups and coast-downs could not be used: " + fits.motionProblem,
               "record run-ups and coast-downs at 100 Hz or more");
    }
    if (fits.balance && fits.balance->isScatterAssumed) {
        remark(result.quality, Verdict::Doubtful, "friction_scatter_assumed",
               "as many unknowns as segments: the friction scatter between segments is assumed (3.3 % of the "
               "friction torque), not measured",
               "record more run-ups and coast-downs at different currents, in both directions");
    }
    if (!fits.balanceProblem.empty()) {
        remark(result.quality, Verdict::Good, "torque_not_separated", fits.balanceProblem,
               "use a higher current, so that the coast-down above 3 rad/s lasts longer than 0.12 s, or a "
               "second "
               "current");
    }
}

// Residual of the worst stretch over the median of all: what the model leaves is the sensors' noise, the same
// in every stretch; friction that depends on speed bends the slow ones (resources/help/identification.md 5).
double worstStretch_ratio(const control::MotionFit& motion) {
    std::vector<double> residuals;
    for (const control::SegmentBalance& balance : motion.balances) {
        residuals.push_back(balance.residualRms_rad);
    }
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return *middle > 0.0 ? *std::max_element(middle, residuals.end()) / *middle : 1.0;
}

// White noise of twelve samples or more exceeds this less than once in 1e9 stretches; of 60 simulated motors
// with all imperfections, which each have some hundred stretches, the worst one reaches 4.1.
constexpr double InadequateStretch_ratio = 4.5;
// No friction does this: an angle that the line damaged did.
constexpr double DamagedStretch_ratio = 50.0;

void judgeStretches(IdentifyResult& result, const IdentifyFits& fits) {
    constexpr std::size_t EnoughStretches = 5;
    if (!fits.motion || fits.motion->balances.size() < EnoughStretches) {
        return;
    }
    const double ratio = worstStretch_ratio(*fits.motion);
    if (ratio > DamagedStretch_ratio) {
        remark(result.quality, Verdict::Refused, "stretch_damaged",
               fmt::format("model inadequate: the residual of one segment is {:.1f} times larger than usual",
                           ratio),
               "look for a jump of the angle in the recording, then measure again");
    } else if (ratio > InadequateStretch_ratio) {
        remark(result.quality, Verdict::Doubtful, "friction_depends_on_speed",
               fmt::format("model inadequate: the residual of one segment is {:.1f} times larger than usual",
                           ratio),
               "friction may depend on speed: the intervals do not include this error; use higher currents "
               "only");
    }
}

// A lag tau of the currents costs torque, tau^2/2 of it times omega^2: 3.5 ms is a tick of hold, the
// millisecond that a small processor takes and an amplifier five times as slow as the published one. An angle
// kappa I of a stray field that is not compensated adds kappa I tau omega, of either sign, and takes (kappa
// I)^2/2 of the torque constant at any speed.
void judgeTorqueLoss(IdentifyResult& result, const IdentifyFits& fits) {
    if (!fits.motion || !fits.motion->isTorqueLossFitted) {
        return;
    }
    constexpr double LargestLag_s = 3.5e-3;
    constexpr double Significant = 3.0; // standard errors
    const double loss_s2 = fits.motion->torqueLoss_s2;
    const double highest_s2 = loss_s2 + Significant * fits.motion->torqueLossError_s2;
    if (highest_s2 < 0.0 || loss_s2 > 0.5 * LargestLag_s * LargestLag_s) {
        remark(result.quality, Verdict::Doubtful, "torque_changes_with_speed",
               "torque changes with speed more than current lag explains: commutation angle or stray-field "
               "compensation is wrong",
               "calibrate the stray field and the Hall sensors, then identify again");
    }
}

// Twice the torque per ampere and half the current turn the rotor alike: the scale of the current is assumed
// wherever one constant alone gives the scale of torque (resources/help/identification.md section 5.1).
void remarkAssumedCurrent(IdentifyResult& result, const IdentifyConfig& config) {
    const auto torque = result.ratios.find("phi_over_J");
    if (torque == result.ratios.end() || !torque->second.value) {
        return;
    }
    std::string message =
        "the current is taken as commanded within 0.3 %: a gain error of the drive moves phi, or J, c and "
        "K_f where phi is given, by as much and shows in no recording";
    if (config.currentTolerance_percent) {
        message = fmt::format("the current is taken as commanded within {:.3g} %, as stated: the intervals "
                              "include a gain error of the drive up to that; a larger one shows in no "
                              "recording",
                              *config.currentTolerance_percent);
    }
    remark(result.quality, Verdict::Good, "current_not_measured", std::move(message),
           "state how well the current is known (--current-tolerance-percent), compare the current that "
           "flows with the commanded one, or give both J and phi: the program then finds a contradiction");
}

void judgeGiven(IdentifyResult& result, const control::JointEstimate& joint, const IdentifyConfig& config) {
    if (joint.consistency && joint.consistency->probability < Improbable) {
        remark(result.quality, Verdict::Doubtful, "given_constants_disagree",
               fmt::format("the given constants contradict the data (p = {:.2g})",
                           joint.consistency->probability),
               "compare the current that flows with the commanded one, since a gain error of the drive "
               "contradicts "
               "so; then give only the best-known constant");
    } else if (!joint.consistency) {
        remarkAssumedCurrent(result, config);
    }
    if (config.given.isEmpty() && !config.added) {
        remark(result.quality, Verdict::Good, "scale_not_given",
               "angle and current determine only ratios of the constants",
               "give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a "
               "known inertia fixed to the rotor (--bare, --added-inertia)");
    } else if (!config.added) {
        for (const control::Estimate& estimate : joint.constants) {
            if (estimate.source == control::EstimateSource::NotIdentifiable) {
                remark(result.quality, Verdict::Good, "not_all_identifiable",
                       "data and given constants do not determine all four constants",
                       "add transients (run-up and coast-down), or another given constant");
                return;
            }
        }
    }
}

std::optional<control::MountingRatios> mountingOf(const MotorEstimate& estimate) {
    control::MountingRatios mounting;
    const char* const names[] = {"c_over_J", "Kf_over_J", "phi_over_J"};
    for (int i = 0; i < 3; ++i) {
        const auto value = estimate.values.find(names[i]);
        if (value == estimate.values.end()) {
            return std::nullopt;
        }
        mounting.values(i) = value->second;
        for (int k = 0; k < 3; ++k) {
            const auto row =
                std::find(estimate.covarianceNames.begin(), estimate.covarianceNames.end(), names[i]);
            const auto column =
                std::find(estimate.covarianceNames.begin(), estimate.covarianceNames.end(), names[k]);
            if (row == estimate.covarianceNames.end() || column == estimate.covarianceNames.end()) {
                return std::nullopt;
            }
            mounting.covariance(i, k) =
                estimate.covariance[static_cast<std::size_t>(row - estimate.covarianceNames.begin())]
                                   [static_cast<std::size_t>(column - estimate.covarianceNames.begin())];
        }
    }
    return mounting;
}

// The ratios of the loaded run become those of the bare motor, with the relative intervals that they had: the
// values of one result belong together.
void takeBareRatios(IdentifyResult& result) {
    struct Ratio {
        const char* name;
        const control::Estimate& above;
        const control::Estimate& below;
    };
    for (const Ratio& one : {Ratio{"c_over_J", result.viscousDamping, result.inertia},
                             Ratio{"Kf_over_J", result.coulombFriction, result.inertia},
                             Ratio{"phi_over_J", result.torqueConstant, result.inertia},
                             Ratio{"c_over_phi", result.viscousDamping, result.torqueConstant},
                             Ratio{"Kf_over_phi", result.coulombFriction, result.torqueConstant}}) {
        const auto found = result.ratios.find(one.name);
        if (found == result.ratios.end() || !found->second.value || *found->second.value == 0.0 ||
            *one.below.value == 0.0) {
            continue;
        }
        const double factor = *one.above.value / *one.below.value / *found->second.value;
        *found->second.value *= factor;
        if (auto& interval = found->second.interval95; interval) {
            interval->first *= factor;
            interval->second *= factor;
        }
    }
}

// The bare motor's four constants replace those of this run, whose inertia is not the motor's own.
void applyAdded(IdentifyResult& result, const AddedInertia& added) {
    const auto bare = mountingOf(added.bare);
    const auto loaded = mountingOf(motorEstimate(result));
    if (!bare || !loaded) {
        remark(result.quality, Verdict::Refused, "added_inertia_without_ratios",
               "both runs must determine c/J, K_f/J and phi/J with covariance, without given constants",
               "identify the bare motor again without --given");
        return;
    }
    const auto estimate = control::inertiaFromAdded(*bare, *loaded, added.inertia_kg_m2);
    if (!estimate) {
        remark(result.quality, Verdict::Refused, "added_inertia_too_small", estimate.error().message,
               estimate.error().hint);
        return;
    }
    if (!estimate->usesDamping) {
        remark(result.quality, Verdict::Doubtful, "mounting_changed_friction",
               fmt::format("the damping gives another inertia ({:.1f} standard errors): the added part "
                           "changed the friction",
                           estimate->disagreement),
               "only the torque constant is used");
    }
    control::Estimate* const places[] = {&result.inertia, &result.viscousDamping, &result.coulombFriction,
                                         &result.torqueConstant};
    result.covarianceNames.clear();
    result.covariance.assign(4, std::vector<double>(4, 0.0));
    for (int i = 0; i < 4; ++i) {
        const auto& name = control::motorConstantName(static_cast<MotorConstant>(i));
        const double half = control::normalQuantile(0.975) * std::sqrt(estimate->covariance(i, i));
        const double value = estimate->values(i);
        *places[i] = {value, std::pair(value - half, value + half), control::EstimateSource::Identified,
                      name.unit};
        result.covarianceNames.emplace_back(name.name);
        for (int k = 0; k < 4; ++k) {
            result.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
                estimate->covariance(i, k);
        }
    }
    takeBareRatios(result);
}

void addNotes(IdentifyResult& result, const IdentifyFits& fits) {
    if (fits.sweep) {
        result.rSquared = fits.sweep->rSquared;
        result.residualRms_rad_s = fits.sweep->residualRms_rad_s;
        result.notes["sweep_c_over_phi"] = fits.sweep->damping_A_s;
        result.notes["sweep_Kf_over_phi"] = fits.sweep->friction_A;
        result.notes["runs_test_p"] = fits.sweep->runs.probability;
        result.notes["largest_influence"] = fits.sweep->largestInfluence;
        if (fits.sweep->lackOfFit) {
            result.notes["lack_of_fit_p"] = fits.sweep->lackOfFit->probability;
        }
        if (fits.sweep->bootstrap95.size() == 2) {
            result.notes["bootstrap_c_over_phi_lo"] = fits.sweep->bootstrap95[0].first;
            result.notes["bootstrap_c_over_phi_hi"] = fits.sweep->bootstrap95[0].second;
            result.notes["bootstrap_Kf_over_phi_lo"] = fits.sweep->bootstrap95[1].first;
            result.notes["bootstrap_Kf_over_phi_hi"] = fits.sweep->bootstrap95[1].second;
        }
    }
    if (fits.motion) {
        result.notes["motion_segments"] = static_cast<double>(fits.motion->balances.size());
        result.notes["angle_residual_rms_rad"] = fits.motion->residualRms_rad;
        result.notes["torque_loss_s2"] = fits.motion->torqueLoss_s2;
        result.notes["torque_loss_error_s2"] = fits.motion->torqueLossError_s2;
        result.notes["worst_stretch_ratio"] = worstStretch_ratio(*fits.motion);
    }
    if (fits.balance && fits.balance->friction_rad_s2 && *fits.balance->friction_rad_s2 > 0.0) {
        result.notes["friction_scatter_ratio"] =
            fits.balance->scatter_rad_s2 / *fits.balance->friction_rad_s2;
    }
}

} // namespace

IdentifyResult judgeFits(const IdentifyFits& fits, const IdentifyConfig& config) {
    IdentifyResult result;
    result.points = fits.points;
    result.highestTemperature_degC = fits.highestTemperature_degC;
    addNotes(result, fits);
    auto ratios = ratiosOf(fits, config);
    if (ratios) {
        addLossAmbiguity(*ratios, fits);
        addDepartureError(*ratios, fits);
    }
    control::JointEstimate joint = control::resolveConstants(
        ratios.value_or(control::MotorRatios{}), config.added ? control::GivenConstants{} : config.given);
    takeEstimate(result, joint);
    judgeAmount(result, fits);
    if (!judgeColumns(result, fits)) {
        return result;
    }
    if (!ratios) {
        remark(result.quality, Verdict::Refused, "nothing_identified",
               fmt::format("neither transients nor plateaus could be used: {}; {}", fits.motionProblem,
                           fits.sweepProblem),
               "use currents well above the breakaway current for several seconds each");
        return result;
    }
    judgeCurrents(result, fits, config.recordedLimit_A);
    takeAsymmetry(result, fits);
    judgeFrictionLaw(result, fits);
    judgeTorqueLaw(result, fits);
    judgeStretches(result, fits);
    judgeTorqueLoss(result, fits);
    judgeSteadyLine(result, fits);
    judgeGiven(result, joint, config);
    if (config.added) {
        applyAdded(result, *config.added);
    }
    judgePhysics(result, fits);
    return result;
}

} // namespace halbench::app
