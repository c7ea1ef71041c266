#include "control/design/optimal_designs.h"

#include "control/design/proven_design.h"
#include "control/lti/discretize.h"
#include "control/lti/riccati.h"

#include <cmath>

namespace halbench::control {

namespace {

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

/// Angle, speed and integral of the error over one period of held current.
struct HeldMotor {
    Eigen::MatrixXd A;
    Eigen::MatrixXd B;
};

HeldMotor heldMotor(const PositionPlant& plant, double period_s, bool hasIntegral) {
    const StateSpace motor{(Eigen::Matrix2d() << 0.0, 1.0, 0.0, -plant.dampingRate_1_s).finished(),
                           Eigen::Vector2d(0.0, plant.accelerationGain_rad_s2_A),
                           Eigen::RowVector2d(1.0, 0.0), Eigen::MatrixXd::Zero(1, 1), TimeBase::continuous()};
    const StateSpace sampled = *discretize(motor, period_s, Hold::Zoh{});
    const Eigen::Index n = hasIntegral ? 3 : 2;
    HeldMotor held{Eigen::MatrixXd::Identity(n, n), Eigen::MatrixXd::Zero(n, 1)};
    held.A.topLeftCorner(2, 2) = sampled.A;
    held.B.topRows(2) = sampled.B;
    if (hasIntegral) {
        held.A(2, 0) = period_s; // of the angle: minus the error
    }
    return held;
}

} // namespace

Result<ProvenDesign> designRegulator(const PositionPlant& plant, const LoopTiming& timing,
                                     const RegulatorTargets& targets, double currentLimit_A) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const bool hasIntegral = targets.integral_rad_s.has_value();
    if (!isPositive(targets.angle_rad) || !isPositive(targets.current_A) ||
        !isPositive(targets.integral_rad_s.value_or(1.0))) {
        return impossibleTargets();
    }
    const HeldMotor motor = heldMotor(plant, timing.period_s, hasIntegral);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(motor.A.rows());
    weight(0) = 1.0 / (targets.angle_rad * targets.angle_rad);
    if (hasIntegral) {
        weight(2) = 1.0 / (*targets.integral_rad_s * *targets.integral_rad_s);
    }
    const Eigen::MatrixXd R = Eigen::MatrixXd::Constant(1, 1, 1.0 / (targets.current_A * targets.current_A));
    const auto gain = regulatorGain(motor.A, motor.B, weight.asDiagonal(), R);
    if (!gain) {
        return failure(gain.error());
    }
    PidGains gains;
    gains.proportional = (*gain)(0, 0);
    gains.derivative = (*gain)(0, 1);
    gains.integral = hasIntegral ? (*gain)(0, 2) : 0.0;
    return provenDesign(plant, gains, timing, currentLimit_A);
}

} // namespace halbench::control
