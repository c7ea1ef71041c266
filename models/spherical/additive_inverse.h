#pragma once

#include "models/spherical/additive_model.h"

namespace halbench::models {

/// Closed-form inverse of the additive model from the main sensor and an auxiliary one at (0, 0, 45 deg), as
/// published for sensor 1. With c = cos 2 gamma, s = sin 2 gamma and (Theta, Phi) pairs T0, T1:
///   gamma = atan2(R1, R0)/2,  U = c T0 + s T1 = -q sin 2b (cos a, sin a),
///   V = c T1 - s T0 = 2 q cos b (-sin a, cos a),
///   alpha = atan2(-V1, V2),  beta = atan2(U.(cos a, sin a)/(-2 q cos b), cos b).
/// Unique for |beta| < 90 degrees; gamma in (-90, 90] degrees. Source: resources/help/spherical-theory.md
/// section 5.3.
OrientationAngles additiveInverse(double strength_T, const SphericalReadings& readings_T);

/// The two other poses at which the main sensor alone reads the same, with chi = atan2(-2 q sin 2g cos b, -q
/// cos 2g sin 2b): (alpha + 2 chi, beta, -gamma) and (alpha + 2 chi - 180 degrees, -beta, gamma), alpha
/// wrapped. Holds for the exact device too. Source: resources/help/spherical-theory.md section 5.6.
std::array<OrientationAngles, 2> sameMainReadings(const OrientationAngles& angles);

/// Least squares of all nine readings over the three angles by Levenberg-Marquardt from `start`, gamma
/// wrapped into (-90, 90] degrees.
struct AdditiveFit {
    bool hasConverged = false;
    OrientationAngles angles;
    double squares_T2 = 0.0; ///< sum of squared residuals
    int iterations = 0;
};
AdditiveFit fitAdditiveModel(const AdditiveModel& model, const SphericalReadings& readings_T,
                             const OrientationAngles& start);
/// The best fit from the closed form and from the fallback starts: readings of another device may have
/// several minima.
AdditiveFit searchAdditiveModel(const AdditiveModel& model, const SphericalReadings& readings_T);

} // namespace halbench::models
