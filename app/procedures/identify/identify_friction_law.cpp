#include "app/procedures/identify/identify_friction_law.h"

#include "control/base/distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

using control::ExtraForce;
using control::ExtraForceTerm;

void remark(IdentifyResult& result, std::string code, std::string message, std::string hint) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    result.quality.findings.push_back({std::move(code), std::move(message), std::move(hint)});
}

// A term with its 95 % interval, in N*m where the inertia is known and over the inertia elsewhere.
struct TermSize {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
    std::string unit;

    std::string text() const { return fmt::format("{:.3g} [{:.3g}, {:.3g}] {}", value, low, high, unit); }
};

TermSize sizeOf(const IdentifyResult& result, const ExtraForceTerm& term, double factor,
                const char* torqueUnit, const char* accelerationUnit) {
    // The errors of the sensors and the time between rows leave up to 0.7 % of it on simulated motors.
    constexpr double Bias_ratio = 0.01;
    const double half = control::studentQuantile(0.975, std::max(term.freedom, 1.0)) *
                        std::hypot(term.error, Bias_ratio * term.value);
    const double scale = factor * result.inertia.value.value_or(1.0);
    return {scale * term.value, scale * (term.value - half), scale * (term.value + half),
            result.inertia.value ? torqueUnit : accelerationUnit};
}

void addNotes(IdentifyResult& result, const std::string& name, const TermSize& size) {
    result.notes[name] = size.value;
    result.notes[name + "_lo"] = size.low;
    result.notes[name + "_hi"] = size.high;
}

void remarkBeyond(IdentifyResult& result, std::string message) {
    remark(result, "friction_beyond_model", std::move(message),
           "the intervals do not include this error: use the relevant speeds, warm up the bearings first, "
           "and check the residuals");
}

void remarkTerm(IdentifyResult& result, const ExtraForceTerm& term, double slowest_rad_s) {
    if (term.force == ExtraForce::QuadraticDrag && term.value > 0.0) {
        const TermSize size = sizeOf(result, term, 1.0, "N*m*s^2/rad^2", "1/rad");
        addNotes(result, "quadratic_drag", size);
        remark(result, "quadratic_drag", fmt::format("quadratic drag of the speed, {}", size.text()),
               "c, K_f and phi are given without this term; the tuning model has no quadratic drag");
    } else if (term.force == ExtraForce::Stribeck && term.value > 0.0) {
        const double there = -control::extraForceAtSpeed_rad_s2(term, slowest_rad_s, 0.0);
        const TermSize size = sizeOf(result, term, there, "N*m", "rad/s^2");
        addNotes(result, "stribeck_friction", size);
        result.notes["stribeck_speed_rad_s"] = term.stribeckSpeed_rad_s;
        remark(
            result, "stribeck_friction",
            fmt::format("friction falls with the speed (Stribeck): at {:.3g} rad/s it is higher by {}, above "
                        "about {:.2g} rad/s it is constant",
                        slowest_rad_s, size.text(), 2.0 * term.stribeckSpeed_rad_s),
            "c, K_f and phi are valid at high speed without this term; near standstill friction is higher");
    } else if (term.force == ExtraForce::DampingByDirection) {
        remarkBeyond(result, "model inadequate: the damping differs between the directions");
    } else if (term.force == ExtraForce::DampingByCurrent) {
        remark(result, "stray_field_wrong",
               "damping changes with the current: the torque angle depends on it, typical for a wrong "
               "stray-field compensation",
               "phi is too small by up to a few per cent: calibrate the stray field, then identify again");
    } else if (term.force == ExtraForce::DampingDrift) {
        remarkBeyond(result, "model inadequate: the damping changes during the recording");
    } else {
        remarkBeyond(result, "model inadequate: the speed dependence of friction follows no known law");
    }
}

} // namespace

void addLossAmbiguity(control::MotorRatios& ratios, const IdentifyFits& fits) {
    if (!fits.motion || !fits.motion->isTorqueLossFitted || !fits.balance || !fits.balance->torque_rad_s2_A ||
        !(fits.motion->damping_per_s > 0.0)) {
        return;
    }
    constexpr double Published_s2 = 3.9e-7; // resources/help/identification.md section 3.1
    constexpr double Lag_s = 0.8e-3;
    constexpr double Fastest_rad_s = 40.0;
    const control::MotionFit& motion = *fits.motion;
    const double excess_s2 = std::fabs(motion.torqueLoss_s2 - Published_s2) - 3.0 * motion.torqueLossError_s2;
    if (!(excess_s2 > 0.0)) {
        return;
    }
    double balance_rad_s2 = 0.0;
    double current_A = 0.0;
    for (const control::SegmentBalance& segment : motion.balances) {
        balance_rad_s2 = std::max(balance_rad_s2, segment.balance_rad_s2);
        current_A = std::max(current_A, segment.current_A);
    }
    const double speed_rad_s = std::min(balance_rad_s2 / motion.damping_per_s, Fastest_rad_s);
    // kappa I tau omega stands for L omega^2 where the rotor is at about half of its highest speed; a quarter
    // of the difference of both is left to the damping.
    const double angle_rad = 2.0 * excess_s2 * speed_rad_s / Lag_s;
    const double torque_rad_s2_A = *fits.balance->torque_rad_s2_A;
    const double dampingError = 0.25 * torque_rad_s2_A * current_A * speed_rad_s * excess_s2;
    const double torqueError = 0.5 * angle_rad * angle_rad * torque_rad_s2_A;
    // The torque bends with the current as I - b I^3; a least-squares line through it from 0.4 to all of the
    // largest current is off by 0.7 b I^3 at no current: 0.35 of what bends the torque there, once the
    // coast-downs have had their half. 0.25 is one sigma.
    const double frictionError = 0.25 * torqueError * current_A;
    const auto count = static_cast<Eigen::Index>(ratios.ratios.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto numerator = ratios.ratios[static_cast<std::size_t>(i)].numerator;
        if (numerator == control::MotorConstant::Damping) {
            covariance(i, i) = dampingError * dampingError;
        } else if (numerator == control::MotorConstant::Torque) {
            covariance(i, i) = torqueError * torqueError;
        } else if (numerator == control::MotorConstant::Friction) {
            covariance(i, i) = frictionError * frictionError;
        }
    }
    ratios.errors.push_back({covariance, std::numeric_limits<double>::infinity()});
}

void judgeFrictionLaw(IdentifyResult& result, const IdentifyFits& fits) {
    if (!fits.missing.isTaken) {
        return;
    }
    for (const ExtraForceTerm& term : fits.missing.terms) {
        remarkTerm(result, term, fits.slowest_rad_s);
    }
    if (!fits.missing.isAdequate) {
        remarkBeyond(result, "model inadequate: the speed dependence of friction follows no known law");
    }
}

} // namespace halbench::app
