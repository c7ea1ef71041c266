#pragma once

#include "control/identify/motion_fit.h"

#include <optional>

namespace halbench::control {

/// Ways in which the torque of a motor departs from phi I; s is the direction of motion.
enum class TorqueDeparture {
    Saturation,      ///< -b k (|I| - I0) above a current I0: the torque grows less from there
    Offset,          ///< -b as soon as a current flows: dead zone, or more friction under current
    GainByDirection, ///< b s I: a torque per ampere for each direction
    GainDrift,       ///< b t I: the torque per ampere changes in the course of the recording
    FrictionDrift,   ///< -b t: friction changes in the course of the recording
    FrictionByLoad,  ///< -b |I|: friction grows with the current; only braking tells it from the torque
    Unnamed,         ///< repeated currents agree better with each other than with the line
};

/// Which directions of motion have it.
enum class DepartureDirection { Both, Forward, Reverse };

struct TorqueLinearity {
    TorqueDeparture departure = TorqueDeparture::Unnamed;
    DepartureDirection direction = DepartureDirection::Both;
    double knee_A = 0.0;      ///< I0 of a saturation
    double value_ratio = 0.0; ///< b over k = phi/J, over the friction, or in ampere (Offset: b/k)
    double probability = 1.0; ///< of a larger departure by chance, for all that were tried together
    /// Change of (a, K_f/J, phi/J) when the departure is part of the model; a does not change.
    Eigen::Vector3d change = Eigen::Vector3d::Zero();
    /// As much change as the data allow at one sigma: `change`, and beyond it the error that it has itself.
    Eigen::Vector3d allowed = Eigen::Vector3d::Zero();
    bool isSignificant = false; ///< chance does not explain it
    bool isNotable = false;     ///< significant, and moves the constants more than their intervals or 2 %
};

/// The most probable departure of the balances from the straight line of `fit`,
///   s (omega' + a omega) = k s I - f_s,    k = phi/J.
/// One departure at a time is one more unknown of that line, with knees between all currents; its error is
/// that of the scatter which then remains, so that a misfit does not hide behind the friction scatter that it
/// makes. All of them count in the probability (Bonferroni, neighbouring knees being nearly one test). Where
/// none of them is significant, balances of repeated currents judge the line by lack of fit. Empty with fewer
/// than three balances more than unknowns. Source: resources/help/identification.md section 5.3.
std::optional<TorqueLinearity> testTorqueLinearity(const MotionFit& motion, const BalanceFit& fit);

} // namespace halbench::control
