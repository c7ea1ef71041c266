#pragma once

#include "control/identify/motion_fit.h"
#include "control/identify/motion_projection.h"

namespace halbench::control {

/// What a loss L = 1 s^2 of torque at speed does to the angle of each segment; speeds and torque from a fit
/// that did not know of it, which is right to first order of the loss (resources/help/identification.md 3.1).
/// Where torque and friction are not told apart, what is left of the torque stands for it.
std::vector<Eigen::VectorXd> torqueLossResponse(std::span<const MotionSegment> segments, const MotionFit& fit,
                                                const MotionColumns& columns);

/// The segments as they would have been without the loss.
std::vector<MotionSegment> withoutTorqueLoss(std::span<const MotionSegment> segments,
                                             const std::vector<Eigen::VectorXd>& response, double loss_s2);

} // namespace halbench::control
