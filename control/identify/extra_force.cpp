#include "control/identify/extra_force.h"

#include "control/identify/extra_force_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr std::size_t MostTerms = 2;
constexpr int CourseCorrections = 3;

// Twice the slowest speed and up to five times it: a bend that fades below is not seen, a longer one is
// damping and a square.
std::vector<ExtraForceTerm> candidates(double slowest_rad_s) {
    std::vector<ExtraForceTerm> all;
    for (const ExtraForce force : {ExtraForce::QuadraticDrag, ExtraForce::DampingByDirection,
                                   ExtraForce::DampingByCurrent, ExtraForce::DampingDrift}) {
        all.push_back({force});
    }
    for (const double ratio : {0.6, 0.8, 1.05, 1.4, 1.9, 2.5, 3.4}) {
        ExtraForceTerm term{ExtraForce::Stribeck};
        term.stribeckSpeed_rad_s = ratio * slowest_rad_s;
        all.push_back(term);
    }
    return all;
}

// Where stretches stand out, the plain fit bends the course of their speed: each term then has to be tried on
// the course that it makes itself.
bool doStretchesStandOut(const MotionFit& fit) {
    constexpr double StandsOut_ratio = 4.0;
    std::vector<double> residuals;
    for (const SegmentBalance& balance : fit.balances) {
        residuals.push_back(balance.residualRms_rad);
    }
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return *std::max_element(middle, residuals.end()) > StandsOut_ratio * *middle;
}

// Terms on the course of the speed that they make, which the problem keeps.
Result<SolvedForces> solveWithCourse(ExtraForceProblem& problem, const std::vector<ExtraForceTerm>& terms,
                                     int corrections) {
    auto tested = solveForces(problem, terms);
    for (int i = 0; tested && i < corrections; ++i) {
        problem.correctCourses(tested->responses, tested->values);
        tested = solveForces(problem, terms);
    }
    return tested;
}

// The most probable term besides those that are taken.
std::optional<ExtraForceTerm> bestCandidate(ExtraForceProblem& problem,
                                            const std::vector<ExtraForceTerm>& taken, double slowest_rad_s,
                                            int corrections) {
    std::optional<ExtraForceTerm> best;
    const auto courses = problem.courses();
    const auto plain = solveForces(problem, taken);
    const double plainRest = plain ? plain->fit.rest.squaredNorm() : 0.0;
    double smallestRest = plainRest;
    for (const ExtraForceTerm& candidate : candidates(slowest_rad_s)) {
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const ExtraForceTerm& one) { return one.force == candidate.force; })) {
            continue;
        }
        std::vector<ExtraForceTerm> terms = taken;
        terms.push_back(candidate);
        const auto tested = solveWithCourse(problem, terms, corrections);
        problem.setCourses(courses);
        if (!tested) {
            continue;
        }
        // Where the plain fit is far off, what is left tells more than the errors, which hold the misfit too.
        const ExtraForceTerm& term = tested->terms.back();
        const double rest = tested->fit.rest.squaredNorm();
        if (!best || (corrections > 0 ? rest < smallestRest : term.probability < best->probability)) {
            best = term;
            smallestRest = rest;
        }
    }
    // One creeping plateau may carry all of such a term: its errors, of one cluster, then say nothing.
    constexpr double Explained_ratio = 0.25;
    if (best && corrections > 0 && smallestRest < Explained_ratio * plainRest) {
        best->probability = 0.0;
    }
    return best;
}

// The Stribeck speed between those that were tried, by halving the step; the last step is its error.
constexpr double FinestStep_ratio = 1.02;

void refineStribeck(ExtraForceProblem& problem, std::vector<ExtraForceTerm>& terms) {
    if (terms.back().force != ExtraForce::Stribeck) {
        return;
    }
    const auto courses = problem.courses();
    const auto restAt = [&](double speed_rad_s) {
        terms.back().stribeckSpeed_rad_s = speed_rad_s;
        const auto tested = solveWithCourse(problem, terms, 1);
        problem.setCourses(courses);
        return tested ? tested->fit.rest.squaredNorm() : std::numeric_limits<double>::infinity();
    };
    double best_rad_s = terms.back().stribeckSpeed_rad_s;
    double bestRest = restAt(best_rad_s);
    for (double step = std::sqrt(1.33); step > FinestStep_ratio; step = std::sqrt(step)) {
        for (const double speed_rad_s : {best_rad_s * step, best_rad_s / step}) {
            const double rest = restAt(speed_rad_s);
            if (rest < bestRest) {
                bestRest = rest;
                best_rad_s = speed_rad_s;
            }
        }
    }
    terms.back().stribeckSpeed_rad_s = best_rad_s;
}

// Difference between two sets of terms as an error that all segments share.
std::optional<SharedError> differenceOf(const ExtraForceProblem& problem,
                                        const std::vector<ExtraForceTerm>& terms,
                                        const std::vector<ExtraForceTerm>& others) {
    const auto one = solveForces(problem, terms);
    const auto other = solveForces(problem, others);
    if (!one || !other) {
        return std::nullopt;
    }
    const auto before = problem.balances(one->responses, one->values);
    const auto after = problem.balances(other->responses, other->values);
    SharedError error{other->values(0) - one->values(0), {}};
    for (std::size_t i = 0; i < before.size(); ++i) {
        error.balances_rad_s2.push_back(after[i] - before[i]);
    }
    return error;
}

// Balances with the terms in the model, and how all of it moves with the errors of a and the terms.
MotionFit extendedMotion(const ExtraForceProblem& problem, const MotionFit& plain,
                         const SolvedForces& tested) {
    MotionFit motion = plain;
    const double a0 = plain.damping_per_s;
    motion.damping_per_s = a0 + tested.values(0);
    motion.dampingError_per_s = std::sqrt(tested.fit.covariance(0, 0));
    motion.dampingFreedom = tested.fit.freedom.minCoeff();
    const std::vector<double> balances = problem.balances(tested.responses, tested.values);
    // Independent directions of the joint error: the first is that of a with what goes with it.
    const Eigen::MatrixXd roots = tested.fit.covariance.llt().matrixL();
    for (Eigen::Index k = 0; k < roots.cols(); ++k) {
        const auto moved = problem.balances(tested.responses, tested.values + roots.col(k));
        SharedError error;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            error.balances_rad_s2.push_back(moved[i] - balances[i]);
        }
        if (k > 0) {
            motion.sharedErrors.push_back(std::move(error));
            continue;
        }
        for (std::size_t i = 0; i < moved.size(); ++i) {
            motion.balances[i].slope_rad_s = error.balances_rad_s2[i] / motion.dampingError_per_s;
        }
    }
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < balances.size(); ++i) {
        const Eigen::Index n = problem.solution().parts[i].angle.size();
        motion.balances[i].balance_rad_s2 = balances[i];
        motion.balances[i].residualRms_rad =
            std::sqrt(tested.fit.rest.segment(row, n).squaredNorm() / static_cast<double>(n));
        row += n;
    }
    motion.residualRms_rad =
        std::sqrt(tested.fit.rest.squaredNorm() / static_cast<double>(tested.fit.rest.size()));
    return motion;
}

// A term that chance explains too well to be taken, and badly enough to be feared: all that it would move is
// one more error.
void addSuspect(ExtraForceFit& result, const ExtraForceProblem& problem) {
    constexpr double Feared = 0.05;
    if (!result.isAdequate || !result.suspect || !(result.suspect->probability < Feared)) {
        return;
    }
    std::vector<ExtraForceTerm> terms = result.terms;
    terms.push_back(*result.suspect);
    if (auto error = differenceOf(problem, result.terms, terms)) {
        result.motion.sharedErrors.push_back(std::move(*error));
    }
}

void addStribeckSpeedErrors(ExtraForceFit& result, const ExtraForceProblem& problem) {
    for (std::size_t i = 0; i < result.terms.size(); ++i) {
        std::vector<ExtraForceTerm> others = result.terms;
        others[i].stribeckSpeed_rad_s *= FinestStep_ratio;
        if (others[i].force == ExtraForce::Stribeck) {
            if (auto error = differenceOf(problem, result.terms, others)) {
                result.motion.sharedErrors.push_back(std::move(*error));
            }
        }
    }
}

} // namespace

double extraForceAtSpeed_rad_s2(const ExtraForceTerm& term, double speed_rad_s, double current_A) {
    return extraForce_rad_s2(term, speed_rad_s, current_A, 0.0);
}

Result<ExtraForceFit> fitExtraForces(std::span<const MotionSegment> segments, const MotionFit& fit,
                                     const ExtraForceConfig& config) {
    ExtraForceFit result;
    result.motion = fit;
    ExtraForceProblem problem(segments, fit, config.motion);
    while (result.terms.size() <= MostTerms) {
        if (config.motion.checkAbort) {
            if (auto goesOn = config.motion.checkAbort(); !goesOn) {
                return failure(goesOn.error());
            }
        }
        const int corrections = doStretchesStandOut(result.motion) ? CourseCorrections : 0;
        result.suspect = bestCandidate(problem, result.terms, config.slowest_rad_s, corrections);
        const bool isSignificant = result.suspect && result.suspect->probability < config.significance;
        result.isAdequate = !isSignificant;
        if (!isSignificant || result.terms.size() == MostTerms) {
            break;
        }
        result.terms.push_back(*result.suspect);
        refineStribeck(problem, result.terms);
        const auto tested = solveWithCourse(problem, result.terms, CourseCorrections);
        if (!tested) {
            return failure(tested.error());
        }
        result.terms = tested->terms;
        result.motion = extendedMotion(problem, fit, *tested);
    }
    addStribeckSpeedErrors(result, problem);
    addSuspect(result, problem);
    return result;
}

} // namespace halbench::control
