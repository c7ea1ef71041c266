#pragma once

#include "control/identify/extra_force.h"
#include "control/identify/motion_projection.h"
#include "control/identify/motion_shape.h"

namespace halbench::control {

/// Acceleration of a term with b = 1; `time` from -1 to 1 over the recording.
double extraForce_rad_s2(const ExtraForceTerm& term, double speed_rad_s, double current_A, double time);

/// All segments, the course of their speed, and the linear unknowns of the plain fit solved at its damping.
class ExtraForceProblem {
public:
    ExtraForceProblem(std::span<const MotionSegment> segments, const MotionFit& fit,
                      const MotionFitConfig& config);

    const MotionSolution& solution() const { return m_solution; }
    const std::vector<MotionSegment>& segments() const { return m_segments; }

    const std::vector<Eigen::VectorXd>& courses() const { return m_courses; }
    void setCourses(const std::vector<Eigen::VectorXd>& courses) { m_courses = courses; }

    /// Response to a damping of 1/s more, angle and speed of each segment.
    std::vector<ForceResponse> dampingResponse() const;
    std::vector<ForceResponse> responseTo(const ExtraForceTerm& term) const;

    /// Without what start and shared unknowns explain, stacked.
    Eigen::VectorXd column(const std::vector<ForceResponse>& response) const;

    /// Start of each segment for these coefficients of these responses, shared unknowns solved along.
    std::vector<Eigen::Vector3d> locals(const std::vector<std::vector<ForceResponse>>& responses,
                                        const Eigen::VectorXd& values) const;

    /// s (omega' + a omega + what the terms take) at the start of each segment.
    std::vector<double> balances(const std::vector<std::vector<ForceResponse>>& responses,
                                 const Eigen::VectorXd& values) const;

    void correctCourses(const std::vector<std::vector<ForceResponse>>& responses,
                        const Eigen::VectorXd& values);

private:
    Eigen::VectorXd stacked(const std::vector<ForceResponse>& response) const;

    Eigen::VectorXd plainCourse(std::size_t which, const Eigen::Vector3d& local) const;

    std::vector<MotionSegment> m_segments;
    const MotionFit& m_fit;
    MotionSolution m_solution;
    std::vector<Eigen::VectorXd> m_courses;
    double m_middle_s = 0.0;
    double m_half_s = 1.0;
};

/// Terms solved together with the damping.
struct SolvedForces {
    std::vector<ExtraForceTerm> terms;
    Eigen::VectorXd values; ///< of a - a0, then of the terms
    ClusterFit fit;
    std::vector<std::vector<ForceResponse>> responses;
};

/// Regression on the given courses, with the errors and the probability of each term. Errors: Refused (the
/// motion does not tell the terms apart).
Result<SolvedForces> solveForces(const ExtraForceProblem& problem, const std::vector<ExtraForceTerm>& terms);

} // namespace halbench::control
