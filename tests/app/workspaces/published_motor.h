#pragma once

#include "app/procedures/identify/identify_procedure.h"

#include <utility>

namespace halbench::app {

/// The published motor (resources/help/htm-theory.md section 2), known to 2 % as a sweep leaves it.
inline IdentifyResult publishedMotor() {
    const auto known = [](double value, double relative, const char* unit) {
        return control::Estimate{value, std::pair(value * (1.0 - relative), value * (1.0 + relative)),
                                 control::EstimateSource::Identified, unit};
    };
    IdentifyResult motor;
    motor.inertia = {5.5e-4, {}, control::EstimateSource::Given, "kg*m^2"};
    motor.viscousDamping = known(1.23e-3, 0.04, "N*m*s/rad");
    motor.coulombFriction = known(2.05e-2, 0.04, "N*m");
    motor.torqueConstant = known(1.43e-2, 0.02, "N*m/A");
    motor.ratios["c_over_J"] = known(1.23e-3 / 5.5e-4, 0.04, "1/s");
    motor.ratios["phi_over_J"] = known(26.0, 0.02, "rad/s^2/A");
    motor.ratios["Kf_over_phi"] = known(2.05e-2 / 1.43e-2, 0.04, "A");
    const double c = 0.02 * 1.23e-3;
    const double Kf = 0.02 * 2.05e-2;
    const double phi = 0.01 * 1.43e-2;
    motor.covarianceNames = {"viscous_damping", "coulomb_friction", "torque_constant"};
    motor.covariance = {{c * c, -0.88 * c * Kf, 0.0}, {-0.88 * c * Kf, Kf * Kf, 0.0}, {0.0, 0.0, phi * phi}};
    return motor;
}

} // namespace halbench::app
