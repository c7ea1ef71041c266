#include "models/spherical/additive_model.h"

#include <cmath>

namespace halbench::models {

SphericalReadings additiveReadings_T(const AdditiveModel& model, const OrientationAngles& angles) {
    SphericalReadings readings_T;
    for (int i = 0; i < 3; ++i) {
        const PlacementAngles& placed = model.placement[static_cast<std::size_t>(i)];
        const double a = angles.alpha_rad - placed.alpha_rad;
        const double b = angles.beta_rad - placed.beta_rad;
        const double g = angles.gamma_rad - placed.gamma_rad;
        const double q = model.strength_T;
        const double even = q * std::cos(2.0 * g);
        const double odd = 2.0 * q * std::sin(2.0 * g) * std::cos(b);
        const double tilt = even * std::sin(2.0 * b);
        readings_T.segment<3>(3 * i) << 3.0 * even * std::cos(b) * std::cos(b),
            -tilt * std::cos(a) + odd * std::sin(a), -tilt * std::sin(a) - odd * std::cos(a);
    }
    return readings_T;
}

SphericalReadings additiveReadingsAndJacobian(const AdditiveModel& model, const OrientationAngles& angles,
                                              OrientationJacobian& jacobian) {
    SphericalReadings readings_T;
    for (int i = 0; i < 3; ++i) {
        const PlacementAngles& placed = model.placement[static_cast<std::size_t>(i)];
        const double a = angles.alpha_rad - placed.alpha_rad;
        const double b = angles.beta_rad - placed.beta_rad;
        const double g = angles.gamma_rad - placed.gamma_rad;
        const double q = model.strength_T;
        const double ca = std::cos(a);
        const double sa = std::sin(a);
        const double cb = std::cos(b);
        const double sb = std::sin(b);
        const double c2g = std::cos(2.0 * g);
        const double s2g = std::sin(2.0 * g);
        const double s2b = 2.0 * sb * cb;
        const double c2b = cb * cb - sb * sb;
        const double theta = -q * c2g * s2b * ca + 2.0 * q * s2g * cb * sa;
        const double phi = -q * c2g * s2b * sa - 2.0 * q * s2g * cb * ca;
        readings_T.segment<3>(3 * i) << 3.0 * q * c2g * cb * cb, theta, phi;
        jacobian.middleRows<3>(3 * i) << 0.0, -3.0 * q * c2g * s2b, -6.0 * q * s2g * cb * cb, //
            -phi, -2.0 * q * c2g * c2b * ca - 2.0 * q * s2g * sb * sa,
            2.0 * q * s2g * s2b * ca + 4.0 * q * c2g * cb * sa, //
            theta, -2.0 * q * c2g * c2b * sa + 2.0 * q * s2g * sb * ca,
            2.0 * q * s2g * s2b * sa - 4.0 * q * c2g * cb * ca;
    }
    return readings_T;
}

} // namespace halbench::models
