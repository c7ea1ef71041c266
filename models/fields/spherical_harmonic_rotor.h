#pragma once

#include "control/base/result.h"

#include <Eigen/Core>

namespace halbench::models {

/// A ball-filtered four-pole permanent magnet: shell between core and outer radius whose radial magnetisation
/// follows sin^2(theta) cos(2 phi). Outside, its field is the spherical harmonic of degree 2 and order 2.
/// Source: resources/help/spherical-theory.md section 3.1.
struct SphericalRotorMagnet {
    double outerRadius_m = 45.6e-3;
    double coreRadius_m = 26.5e-3;
    double poleAngle_rad = 60.0 * 3.14159265358979323846 / 180.0;
    double remanence_T = 1.0;
    double recoilPermeability_ratio = 1.02;
    double corePermeability_ratio = 1.0;
    double azimuthalCoefficient = 3.1058;
};

/// OutOfRange or NotFinite when the numbers describe no shell of positive thickness.
Result<void> checkSphericalRotorMagnet(const SphericalRotorMagnet& magnet);

/// Strengths of the three components of B at distance r from the centre (rotor frame, theta from the shaft):
///   B_r     = radial r^-4 sin^2(theta) cos(2 phi)
///   B_theta = polar r^-4 sin(2 theta) cos(2 phi)
///   B_phi   = azimuthal r^-4 sin(theta) sin(2 phi)
/// in the ratio 3 : -1 : 2, the only one for which curl and divergence vanish.
struct SphericalFieldStrength {
    double radial_T_m4 = 0.0;
    double polar_T_m4 = 0.0;
    double azimuthal_T_m4 = 0.0;
};
SphericalFieldStrength sphericalFieldStrength(const SphericalRotorMagnet& magnet);

/// q = radial/3 r^-4: eigenvalue of the field tensor at the radius r. 0.0991864782 T for the published rotor
/// at 50 mm.
double tensorStrength_T(const SphericalRotorMagnet& magnet, double radius_m);

/// The field of the degree-2 part as a linear function of the symmetric traceless tensor Q (T, valid at the
/// reference radius): B(r n) = (r_ref/r)^4 [5 (n.Q n) n - 2 Q n]. The rotor has Q = q M diag(1, -1, 0) M^T.
/// All vectors in the frame of Q. The point must not be the centre.
Eigen::Vector3d tensorField_T(const Eigen::Matrix3d& tensor_T, double referenceRadius_m,
                              const Eigen::Vector3d& point_m);

} // namespace halbench::models
