#include "models/fields/spherical_harmonic_rotor.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::models {

Result<void> checkSphericalRotorMagnet(const SphericalRotorMagnet& magnet) {
    for (const double value :
         {magnet.outerRadius_m, magnet.coreRadius_m, magnet.poleAngle_rad, magnet.remanence_T,
          magnet.recoilPermeability_ratio, magnet.corePermeability_ratio, magnet.azimuthalCoefficient}) {
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite, "A number of the spherical rotor is not finite.");
        }
    }
    if (magnet.coreRadius_m < 0.0 || magnet.outerRadius_m <= magnet.coreRadius_m) {
        return failure(ErrorCode::OutOfRange,
                       "The outer radius of the magnet must be larger than the radius of its core.");
    }
    if (magnet.recoilPermeability_ratio < 1.0 || magnet.corePermeability_ratio < 1.0) {
        return failure(ErrorCode::OutOfRange, "Relative permeabilities of the rotor are at least 1.");
    }
    return {};
}

SphericalFieldStrength sphericalFieldStrength(const SphericalRotorMagnet& magnet) {
    const double pole = magnet.poleAngle_rad;
    const double half = std::cos(0.5 * pole);
    // Share of the fundamental in the magnetisation along the shaft; the factor 0.0483 is the source's.
    const double c22 = 0.0483 * (2.0 * half * half * std::sin(pole) + 3.0 * pole + 3.0 * std::sin(pole));
    const double shell = magnet.recoilPermeability_ratio;
    const double core = magnet.corePermeability_ratio;
    const double outer = magnet.outerRadius_m;
    const double inner5 = std::pow(magnet.coreRadius_m, 5);
    const double outer5 = std::pow(outer, 5);
    // Outer coefficient of the potential: continuity of the potential and of the normal B at both radii.
    const double numerator =
        std::pow(outer, 4) * (-5.0 * shell * outer * std::pow(magnet.coreRadius_m, 4) +
                              (3.0 * shell + 2.0 * core) * outer5 + 2.0 * (shell - core) * inner5);
    const double denominator = (3.0 * shell + 2.0 * core) * (3.0 + 2.0 * shell) * outer5 -
                               6.0 * (1.0 - shell) * (core - shell) * inner5;
    const double k = magnet.azimuthalCoefficient * c22 * magnet.remanence_T * numerator / denominator;
    return {2.3184 * k, -0.7728 * k, 1.5456 * k};
}

double tensorStrength_T(const SphericalRotorMagnet& magnet, double radius_m) {
    return sphericalFieldStrength(magnet).radial_T_m4 / (3.0 * std::pow(radius_m, 4));
}

Eigen::Vector3d tensorField_T(const Eigen::Matrix3d& tensor_T, double referenceRadius_m,
                              const Eigen::Vector3d& point_m) {
    const double radius_m = point_m.norm();
    HB_ASSERT(radius_m > 0.0);
    const Eigen::Vector3d n = point_m / radius_m;
    const double fall = referenceRadius_m / radius_m;
    const Eigen::Vector3d flux = tensor_T * n;
    return fall * fall * fall * fall * (5.0 * n.dot(flux) * n - 2.0 * flux);
}

} // namespace halbench::models
