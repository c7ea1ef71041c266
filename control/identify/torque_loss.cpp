#include "control/identify/torque_loss.h"

#include "control/identify/motion_shape.h"

#include <cmath>

namespace halbench::control {

std::vector<Eigen::VectorXd> torqueLossResponse(std::span<const MotionSegment> segments, const MotionFit& fit,
                                                const MotionColumns& columns) {
    const auto balance = fitBalance(fit);
    const double torque = balance ? balance->torque_rad_s2_A.value_or(0.0) : 0.0;
    const MotionSolution solution = solveMotion(segments, fit.damping_per_s, columns);
    std::vector<Eigen::VectorXd> response;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Eigen::Vector3d& local = solution.local[i];
        const MotionSegment& segment = segments[i];
        const double rest = segment.current_A == 0.0 ? 0.0 : fit.balances[i].balance_rad_s2;
        const double drive = torque > 0.0 ? torque * segment.current_A : segment.direction * rest;
        response.emplace_back(-drive * forceShape(segment, fit.damping_per_s, {local(1), local(2)},
                                                  [](double speed) { return speed * speed; }));
    }
    return response;
}

std::vector<MotionSegment> withoutTorqueLoss(std::span<const MotionSegment> segments,
                                             const std::vector<Eigen::VectorXd>& response, double loss_s2) {
    std::vector<MotionSegment> corrected(segments.begin(), segments.end());
    for (std::size_t i = 0; i < corrected.size(); ++i) {
        for (std::size_t row = 0; row < corrected[i].angle_rad.size(); ++row) {
            corrected[i].angle_rad[row] -= loss_s2 * response[i](static_cast<Eigen::Index>(row));
        }
    }
    return corrected;
}

} // namespace halbench::control
