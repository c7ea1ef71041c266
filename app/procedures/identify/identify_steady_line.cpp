#include "app/procedures/identify/identify_steady_line.h"

#include "control/base/distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

// Lack of fit, runs and agreement with the motion: three chances to be wrong once in a hundred.
constexpr double ImprobableSweep = 0.01 / 3.0;

void remark(IdentifyResult& result, std::string code, std::string message, std::string hint) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
    result.quality.findings.push_back({std::move(code), std::move(message), std::move(hint)});
}

void judgeModel(IdentifyResult& result, const IdentifyFits& fits) {
    if (!fits.sweep) {
        return;
    }
    const control::FrictionSweep& sweep = *fits.sweep;
    if (sweep.isRobustDifferent) {
        remark(result, "outliers",
               "ordinary and robust regression of the sweep differ by more than one standard error",
               "check the plateaus of low weight; repeat the sweep");
    }
    // Codes of the converters are rounded, the same way each time: a misfit below one of them is no friction.
    constexpr double Code_A = 10.0 / 4096.0;
    const bool isBelowOneCode = sweep.residualRms_rad_s * sweep.damping_A_s < Code_A;
    if (!isBelowOneCode && sweep.lackOfFit && sweep.lackOfFit->probability < ImprobableSweep) {
        remark(result, "model_inadequate",
               fmt::format("steady speed is not linear in the current (lack of fit, p = {:.2g})",
                           sweep.lackOfFit->probability),
               "friction may depend on speed; use only the relevant speed range");
    }
    if (!isBelowOneCode && sweep.runs.probability < ImprobableSweep) {
        remark(result, "residuals_in_runs",
               fmt::format("residuals keep their sign over neighbouring speeds (runs test, p = {:.2g})",
                           sweep.runs.probability),
               "friction may depend on speed; check the residuals");
    }
    constexpr double StrongInfluence = 2.5;
    if (sweep.largestInfluence > StrongInfluence) {
        remark(result, "one_point_decides",
               fmt::format("omitting one plateau shifts the steady line by {:.1f} standard errors",
                           sweep.largestInfluence),
               "add plateaus near it or repeat it");
    }
}

// Chance of a larger difference between plateaus and all motion than this one.
double agreement(double difference, double motionError, double sweepError, int freedom) {
    const double error = std::hypot(motionError, sweepError);
    return error > 0.0 ? control::studentTwoSided(difference / error, freedom) : 1.0;
}

// Steady line against run-ups and coast-downs: the same c/phi and K_f/phi must come out.
void judgeAgreement(IdentifyResult& result, const IdentifyFits& fits) {
    if (!fits.sweep || !fits.balance || !(fits.balance->torque_rad_s2_A.value_or(0.0) > 0.0)) {
        return;
    }
    constexpr double SmallDifference_ratio = 0.01;
    constexpr double ImprobableRatio = 0.5 * ImprobableSweep; // two are compared
    const double k = *fits.balance->torque_rad_s2_A;
    const Eigen::Matrix3d& scatter = fits.balance->scatterCovariance;
    const control::FrictionSweep& sweep = *fits.sweep;
    const double damping_A_s = fits.motion->damping_per_s / k;
    const double dampingProbability =
        agreement(sweep.damping_A_s - damping_A_s, damping_A_s * std::sqrt(scatter(2, 2)) / k,
                  std::sqrt(sweep.covariance(0, 0)), sweep.freedom);
    if (dampingProbability < ImprobableRatio &&
        std::fabs(sweep.damping_A_s / damping_A_s - 1.0) > SmallDifference_ratio) {
        remark(result, "steady_and_transient_disagree",
               fmt::format("c/phi is {:.3g} A*s/rad from plateaus and {:.3g} from all motion (p = {:.2g})",
                           sweep.damping_A_s, damping_A_s, dampingProbability),
               "friction may depend on speed");
    }
    const double friction_A = fits.balance->friction_rad_s2.value_or(0.0) / k;
    const Eigen::Vector3d gradient(0.0, 1.0 / k, -friction_A / k);
    const double frictionProbability =
        agreement(sweep.friction_A - friction_A, std::sqrt(gradient.dot(scatter * gradient)),
                  std::sqrt(sweep.covariance(1, 1)), sweep.freedom);
    double largest_A = 0.0;
    for (const SweepPoint& point : fits.points) {
        largest_A = std::max(largest_A, std::fabs(point.current_A));
    }
    if (frictionProbability < ImprobableRatio &&
        std::fabs(sweep.friction_A - friction_A) > SmallDifference_ratio * largest_A) {
        remark(result, "steady_and_transient_disagree",
               fmt::format("K_f/phi is {:.3g} A from plateaus and {:.3g} A from all motion (p = {:.2g})",
                           sweep.friction_A, friction_A, frictionProbability),
               "friction may depend on speed, or torque is not proportional to the current");
    }
}

} // namespace

void judgeSteadyLine(IdentifyResult& result, const IdentifyFits& fits) {
    judgeModel(result, fits);
    judgeAgreement(result, fits);
}

} // namespace halbench::app
