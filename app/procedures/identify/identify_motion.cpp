#include "app/procedures/identify/identify_motion.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

// What is left of the torque at speed omega is 1 - omega^2 times: T^2/24 of the hold between commutations
// every T = 1 ms, plus (2 zeta tau)^2/2 - tau^2 of the amplifier's 1 + 3.0e-4 s + 1.52e-8 s^2
// (resources/help/htm-theory.md sections 3.2 and 3.8).
constexpr double HoldLoss_s2 = 1e-6 / 24.0 + 0.5 * 3.0e-4 * 3.0e-4 - 1.52e-8;

// Of the lag that is assumed when the data do not tell it: the hold of an unknown loop may be anything up to
// a tick of 1 ms (uniform: 1/sqrt(12)), the amplifier's 0.3 ms are good to 20 %
// (resources/help/identification.md section 3.1).
constexpr double LagError_s = 0.295e-3;

Result<void> askedToEnd(const AbortCheck& check) {
    return check ? check() : Result<void>();
}

// A constant error delta of the angle and the lag tau leave cos(delta + omega tau) of the torque, of which
// -phi I delta tau omega looks like damping; it changes its sign with the direction and cancels when both
// were run (resources/help/identification.md section 3.1).
double oneWayDampingError_per_s(const control::MotionFit& motion, double lag_s) {
    constexpr double MountingError_rad = 0.0087; // sensors to coils, half a degree
    const auto balance = control::fitBalance(motion);
    const bool runsBothWays =
        std::any_of(motion.balances.begin(), motion.balances.end(), [&motion](const auto& segment) {
            return segment.direction != motion.balances.front().direction;
        });
    if (runsBothWays || !balance) {
        return 0.0;
    }
    double largest_A = 0.0;
    for (const control::SegmentBalance& segment : motion.balances) {
        largest_A = std::max(largest_A, segment.current_A);
    }
    return balance->torque_rad_s2_A.value_or(0.0) * largest_A * MountingError_rad * lag_s;
}

void addOneWayError(control::MotionFit& motion, const IdentifyConfig& config) {
    motion.dampingError_per_s =
        std::hypot(motion.dampingError_per_s, oneWayDampingError_per_s(motion, config.commutationLag_s));
}

// Are the constants of one fit further from the other than that one's intervals reach, and than 0.3 %, which
// a motor without imperfections is good to (resources/help/htm-theory.md section 7.2)? Or 2 % away?
bool areConstantsMoved(const control::MotionFit& motion, const control::BalanceFit& balance,
                       const control::MotionFit& otherMotion, const control::BalanceFit& other) {
    constexpr double Notable_ratio = 0.02;
    constexpr double Small_ratio = 0.003;
    const Eigen::Matrix3d covariance = balance.scatterCovariance + balance.dampingCovariance;
    const Eigen::Vector3d values(motion.damping_per_s, balance.friction_rad_s2.value_or(0.0),
                                 balance.torque_rad_s2_A.value_or(0.0));
    const Eigen::Vector3d others(otherMotion.damping_per_s, other.friction_rad_s2.value_or(0.0),
                                 other.torque_rad_s2_A.value_or(0.0));
    // Without friction two per cent of it are nothing: it has to be seen beside the largest torque.
    constexpr double Negligible_ratio = 1e-3;
    double largest_rad_s2 = 0.0;
    for (const control::SegmentBalance& segment : motion.balances) {
        largest_rad_s2 = std::max(largest_rad_s2, std::fabs(segment.balance_rad_s2));
    }
    const Eigen::Vector3d negligible(0.0, Negligible_ratio * largest_rad_s2, 0.0);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double moved = std::fabs(others(i) - values(i));
        const double interval =
            std::max(2.0 * std::sqrt(covariance(i, i)), Small_ratio * std::fabs(values(i)));
        if (moved > std::max(std::min(interval, Notable_ratio * std::fabs(values(i))), negligible(i))) {
            return true;
        }
    }
    return false;
}

// What a term that is too small to matter moves is one more error.
void addAsError(control::MotionFit& motion, const control::MotionFit& other) {
    control::SharedError error{other.damping_per_s - motion.damping_per_s, {}};
    for (std::size_t i = 0; i < motion.balances.size(); ++i) {
        error.balances_rad_s2.push_back(other.balances[i].balance_rad_s2 - motion.balances[i].balance_rad_s2);
    }
    motion.sharedErrors.push_back(std::move(error));
}

Result<void> takeMissingForces(std::span<const control::MotionSegment> segments,
                               const control::MotionFit& plain, const control::MotionFitConfig& motionConfig,
                               const IdentifyConfig& config, IdentifyFits& fits) {
    control::ExtraForceConfig forces;
    forces.motion = motionConfig;
    forces.slowest_rad_s = config.usableSpeed_rad_s;
    auto extended = control::fitExtraForces(segments, plain, forces);
    if (auto goesOn = askedToEnd(motionConfig.checkAbort); !goesOn) {
        return goesOn;
    }
    if (!extended) {
        return {}; // the motion is too little to tell any of them
    }
    fits.missing = {extended->terms, extended->isAdequate, false};
    addOneWayError(extended->motion, config);
    auto balance = control::fitBalance(extended->motion);
    if (!balance) {
        return {};
    }
    fits.missing.isTaken = !extended->terms.empty() &&
                           areConstantsMoved(*fits.motion, *fits.balance, extended->motion, *balance);
    if (!fits.missing.isTaken && !extended->terms.empty()) {
        addAsError(*fits.motion, extended->motion);
        balance = control::fitBalance(*fits.motion);
    } else {
        fits.motion = std::move(extended->motion);
    }
    if (balance) {
        fits.balance = std::move(*balance);
    }
    return {};
}

// A motor with much friction stops sooner than a stretch should last. Without any coast-down its friction is
// read from driven motion alone, where nothing tells it from a torque that is not proportional to the
// current. Shorter ones are too coarse for the constants, but show that.
std::optional<control::TorqueLinearity>
testByBriefCoastDowns(std::span<const double> time_s, std::span<const double> angle_rad,
                      std::span<const control::CurrentPlateau> plateaus,
                      const control::MotionFitConfig& motionConfig, const control::SegmentConfig& usual) {
    constexpr double Brief_s = 0.05;
    const auto coasts = [&usual](const auto& stretch) {
        return std::fabs(stretch.current_A) <= usual.sameCurrent_A;
    };
    control::SegmentConfig brief = usual;
    brief.shortest_s = Brief_s;
    std::vector<control::MotionSegment> segments;
    for (std::size_t i = 0; i < plateaus.size(); ++i) { // one by one, in the order of time
        auto found = control::findMotion(time_s, angle_rad, plateaus.subspan(i, 1),
                                         coasts(plateaus[i]) ? brief : usual);
        std::move(found.begin(), found.end(), std::back_inserter(segments));
    }
    if (std::none_of(segments.begin(), segments.end(), coasts)) {
        return std::nullopt;
    }
    const auto motion = control::fitMotion(segments, motionConfig);
    const auto balance = motion ? control::fitBalance(*motion) : failure(motion.error());
    return balance ? control::testTorqueLinearity(*motion, *balance) : std::nullopt;
}

bool hasCoastDown(std::span<const control::MotionSegment> segments, const control::SegmentConfig& usual) {
    return std::any_of(segments.begin(), segments.end(), [&usual](const control::MotionSegment& segment) {
        return std::fabs(segment.current_A) <= usual.sameCurrent_A;
    });
}

} // namespace

control::SegmentConfig segmentConfigOf(const IdentifyConfig& config) {
    control::SegmentConfig segments;
    segments.slowest_rad_s = config.usableSpeed_rad_s;
    return segments;
}

Result<void> fitTransients(std::span<const double> time_s, std::span<const double> angle_rad,
                           std::span<const control::CurrentPlateau> plateaus, const IdentifyConfig& config,
                           const AbortCheck& checkAbort, IdentifyFits& fits) {
    const auto segments = control::findMotion(time_s, angle_rad, plateaus, segmentConfigOf(config));
    control::MotionFitConfig motionConfig;
    motionConfig.torqueLoss_s2 = HoldLoss_s2 + 0.5 * config.commutationLag_s * config.commutationLag_s;
    motionConfig.torqueLossError_s2 = config.commutationLag_s * LagError_s;
    motionConfig.checkAbort = checkAbort;
    auto motion = control::fitMotion(segments, motionConfig);
    if (auto goesOn = askedToEnd(checkAbort); !goesOn) {
        return goesOn; // not a problem of the motion
    }
    if (!motion) {
        fits.motionProblem = motion.error().message;
        return {};
    }
    control::MotionFit plain = *motion;
    addOneWayError(*motion, config);
    constexpr double WorstDampingError = 0.25;
    if (!(motion->dampingError_per_s < WorstDampingError * std::fabs(motion->damping_per_s) + 0.02)) {
        fits.motionProblem = "the curvature of the motion is too small to determine c/J";
        return {};
    }
    fits.motion = std::move(*motion);
    auto balance = control::fitBalance(*fits.motion);
    if (!balance) {
        fits.balanceProblem = balance.error().message;
        return {};
    }
    fits.balance = std::move(*balance);
    fits.plainMotion = fits.motion;
    fits.plainBalance = fits.balance;
    if (auto goesOn = takeMissingForces(segments, plain, motionConfig, config, fits); !goesOn) {
        return goesOn;
    }
    fits.linearity = control::testTorqueLinearity(*fits.motion, *fits.balance);
    const control::SegmentConfig usual = segmentConfigOf(config);
    if (fits.linearity && !fits.linearity->isNotable && !hasCoastDown(segments, usual)) {
        const auto brief = testByBriefCoastDowns(time_s, angle_rad, plateaus, motionConfig, usual);
        if (brief && brief->isNotable) {
            fits.linearity = brief;
        }
    }
    return askedToEnd(checkAbort);
}

} // namespace halbench::app
