#include "app/procedures/identify/identify_physics.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

void remark(IdentifyResult& result, Verdict verdict, Finding finding) {
    result.quality.verdict = std::max(result.quality.verdict, verdict);
    result.quality.findings.push_back(std::move(finding));
}

bool isMeasured(const Estimate& estimate) {
    return estimate.value && estimate.source == EstimateSource::Identified;
}

// A refused result tells no value; what the user gave stays.
void refuse(IdentifyResult& result, Finding finding) {
    const auto forget = [](Estimate& estimate) {
        if (estimate.source == EstimateSource::Identified) {
            estimate = {std::nullopt, std::nullopt, EstimateSource::NotIdentifiable, estimate.unit};
        }
    };
    for (Estimate* estimate :
         {&result.inertia, &result.viscousDamping, &result.coulombFriction, &result.torqueConstant}) {
        forget(*estimate);
    }
    for (auto& [name, estimate] : result.ratios) {
        forget(estimate);
    }
    result.asymmetry.reset();
    result.covarianceNames.clear();
    result.covariance.clear();
    remark(result, Verdict::Refused, std::move(finding));
}

void refuseSign(IdentifyResult& result, std::string shown) {
    refuse(
        result,
        {"sign_reversed", "wrong sign of current or angle: " + shown,
         "invert the sign of one of the two columns (or of the command on the device), then identify again"});
}

// Estimates of one constant: its own and its ratios over something positive.
std::vector<Estimate*> estimatesOf(IdentifyResult& result, Estimate& constant,
                                   std::initializer_list<const char*> ratios) {
    std::vector<Estimate*> found;
    for (const char* name : ratios) {
        const auto ratio = result.ratios.find(name);
        if (ratio != result.ratios.end() && isMeasured(ratio->second)) {
            found.push_back(&ratio->second);
        }
    }
    if (isMeasured(constant)) {
        found.push_back(&constant);
    }
    return found;
}

// The largest torque of the run over J or phi, by which a friction or damping torque is called negligible.
struct TorqueScale {
    double overInertia_rad_s2 = 0.0;
    double overTorque_A = 0.0;
    double speed_rad_s = 0.0;
};

TorqueScale scaleOf(const IdentifyFits& fits) {
    TorqueScale scale;
    if (fits.motion) {
        for (const control::SegmentBalance& balance : fits.motion->balances) {
            scale.overInertia_rad_s2 = std::max(scale.overInertia_rad_s2, std::fabs(balance.balance_rad_s2));
            scale.overTorque_A = std::max(scale.overTorque_A, std::fabs(balance.current_A));
        }
    }
    for (const SweepPoint& point : fits.points) {
        scale.overTorque_A = std::max(scale.overTorque_A, std::fabs(point.current_A));
        scale.speed_rad_s = std::max(scale.speed_rad_s, std::fabs(point.speed_rad_s));
    }
    return scale;
}

// Friction or damping as a share of that torque, from the first of its ratios that came out.
struct Share {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

std::optional<Share> shareOf(const Estimate& overInertia, double inertiaScale, const Estimate& overTorque,
                             double torqueScale) {
    const auto of = [](const Estimate& estimate, double scale) -> std::optional<Share> {
        if (!isMeasured(estimate) || !estimate.interval95 || !(scale > 0.0)) {
            return std::nullopt;
        }
        return Share{*estimate.value / scale, estimate.interval95->first / scale,
                     estimate.interval95->second / scale};
    };
    const auto first = of(overInertia, inertiaScale);
    return first ? first : of(overTorque, torqueScale);
}

constexpr double Negligible_ratio = 1e-3; // of the largest torque: far below what a current is known to
constexpr double Notable_ratio = 0.05;    // an interval wider than this says little of friction or damping

void startAtZero(const std::vector<Estimate*>& estimates) {
    for (Estimate* estimate : estimates) {
        if (estimate->interval95) {
            const double reach = std::max({estimate->interval95->second, -*estimate->value, 0.0});
            estimate->interval95 = std::pair(std::max(estimate->interval95->first, 0.0), reach);
        }
        estimate->value = std::max(*estimate->value, 0.0);
    }
}

struct LossWords {
    const char* code;
    const char* negative;
    const char* indistinct;
    const char* undecided;
};

constexpr LossWords FrictionWords{"friction_below_zero", "negative friction, not possible for a motor",
                                  "friction not distinguishable from zero: at most {:.2g} % of the torque",
                                  "friction undetermined: between zero and {:.2g} % of the largest torque"};
constexpr LossWords DampingWords{"damping_below_zero", "negative damping, not possible for a motor",
                                 "damping not distinguishable from zero: at most {:.2g} % of the torque",
                                 "damping undetermined: between zero and {:.2g} % of the largest torque"};

void judgeFriction(IdentifyResult& result, const std::optional<Share>& share,
                   const std::vector<Estimate*>& estimates, const LossWords& words) {
    if (!share || share->low > 0.0) {
        return;
    }
    if (share->high < 0.0 && share->value < -Negligible_ratio) {
        refuse(result, {words.code, words.negative,
                        "current and angle are not consistent: check units, time shift of the columns, and "
                        "that nothing else drives the rotor"});
        return;
    }
    startAtZero(estimates);
    const double most = std::max(share->high, std::fabs(share->value));
    if (most > Notable_ratio) {
        remark(result, Verdict::Doubtful,
               {words.code, fmt::format(fmt::runtime(words.undecided), 100.0 * most),
                "record more run-ups and coast-downs, over a wider range of speed"});
    } else {
        remark(result, Verdict::Good,
               {words.code, fmt::format(fmt::runtime(words.indistinct), 100.0 * most),
                "the value is zero and its interval begins there"});
    }
}

bool judgePositive(IdentifyResult& result) {
    const auto torques = estimatesOf(result, result.torqueConstant, {"phi_over_J"});
    const auto isBelow = [](const Estimate* estimate) { return !(*estimate->value > 0.0); };
    if (std::any_of(torques.begin(), torques.end(), isBelow)) {
        refuseSign(result, "negative torque constant: the current accelerates the rotor backwards");
        return false;
    }
    if (isMeasured(result.inertia) && isBelow(&result.inertia)) {
        refuse(result, {"inertia_below_zero", "negative inertia, not possible for a rotor",
                        "check the given constants, and the units of current and angle"});
        return false;
    }
    auto positive = torques;
    positive.push_back(&result.inertia);
    const bool reachesZero = std::any_of(positive.begin(), positive.end(), [](const Estimate* estimate) {
        return isMeasured(*estimate) && estimate->interval95 && !(estimate->interval95->first > 0.0);
    });
    if (reachesZero) {
        remark(result, Verdict::Doubtful,
               {"interval_reaches_zero", "the interval of torque constant or inertia includes zero",
                "use larger and more different currents, each for a longer time"});
    }
    return true;
}

} // namespace

bool judgeColumns(IdentifyResult& result, const IdentifyFits& fits) {
    if (fits.isSpeedColumn) {
        refuse(result, {"speed_as_angle", "the angle column looks like a speed: it settles with each current",
                        "record the position, or rename the columns"});
        return false;
    }
    if (fits.wrap_rad) {
        remark(result, Verdict::Good,
               {"angle_wraps",
                fmt::format("angle wraps after {:.4g} deg: unwrapped", radiansToDegrees(*fits.wrap_rad)),
                "valid if the rotor turns by less than half of this angle between two rows"});
    }
    if (2 * fits.againstPlateaus > fits.points.size()) {
        refuseSign(result, "the rotor turns against its current");
        return false;
    }
    return true;
}

void judgeCurrents(IdentifyResult& result, const IdentifyFits& fits,
                   const std::optional<double>& recordedLimit_A) {
    // The published motor bears 4 A; mA of its sweep in a column of amperes are 400 and more.
    constexpr double Implausible_A = 100.0;
    constexpr double Rounding_ratio = 1.01; // of a current that stands at its limit
    const char* const hint = "check unit and scale of the current column, e.g. current_command_mA";
    if (recordedLimit_A && fits.largestCurrent_A > Rounding_ratio * *recordedLimit_A) {
        remark(result, Verdict::Doubtful,
               {"current_above_limit",
                fmt::format("current of {:.4g} A, above the limit of {:.4g} A of the recorded device",
                            fits.largestCurrent_A, *recordedLimit_A),
                hint});
    } else if (fits.largestCurrent_A > Implausible_A) {
        remark(result, Verdict::Doubtful,
               {"current_implausible",
                fmt::format("current of {:.4g} A, implausible for an actuator of this kind",
                            fits.largestCurrent_A),
                hint});
    }
}

void judgePhysics(IdentifyResult& result, const IdentifyFits& fits) {
    if (result.quality.verdict == Verdict::Refused || !judgePositive(result)) {
        return;
    }
    const TorqueScale scale = scaleOf(fits);
    const auto friction = shareOf(result.ratios["Kf_over_J"], scale.overInertia_rad_s2,
                                  result.ratios["Kf_over_phi"], scale.overTorque_A);
    judgeFriction(result, friction, estimatesOf(result, result.coulombFriction, {"Kf_over_J", "Kf_over_phi"}),
                  FrictionWords);
    const double perSpeed = scale.speed_rad_s > 0.0 ? 1.0 / scale.speed_rad_s : 0.0;
    const auto damping = shareOf(result.ratios["c_over_J"], perSpeed * scale.overInertia_rad_s2,
                                 result.ratios["c_over_phi"], perSpeed * scale.overTorque_A);
    judgeFriction(result, damping, estimatesOf(result, result.viscousDamping, {"c_over_J", "c_over_phi"}),
                  DampingWords);
}

} // namespace halbench::app
