#include "models/spherical/current_loop.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::models {

Result<void> checkCurrentLoop(const CurrentLoop& loop) {
    if (!loop.centre_m.allFinite() || !loop.axis.allFinite() || !std::isfinite(loop.radius_m) ||
        !std::isfinite(loop.turns)) {
        return failure(ErrorCode::NotFinite, "A number of the stator coil is not finite.");
    }
    if (loop.radius_m <= 0.0 || loop.turns <= 0.0 || std::abs(loop.axis.norm() - 1.0) > 1e-9) {
        return failure(ErrorCode::OutOfRange,
                       "A stator coil needs a positive radius, turns and an axis of length one.");
    }
    return {};
}

Eigen::Vector3d loopField_T_per_A(const CurrentLoop& loop, const Eigen::Vector3d& point_m) {
    constexpr double Permeability_T_m_per_A = 4e-7 * Pi;
    const Eigen::Vector3d offset = point_m - loop.centre_m;
    const double z = offset.dot(loop.axis);
    const Eigen::Vector3d across = offset - z * loop.axis;
    const double rho = across.norm();
    const double a = loop.radius_m;
    const double outer = (a + rho) * (a + rho) + z * z;
    const double inner = (a - rho) * (a - rho) + z * z;
    const double modulus = std::sqrt(4.0 * a * rho / outer);
    const double first = std::comp_ellint_1(modulus);
    const double second = std::comp_ellint_2(modulus);
    const double scale = Permeability_T_m_per_A * loop.turns / (2.0 * Pi * std::sqrt(outer));
    const double along = scale * (first + (a * a - rho * rho - z * z) / inner * second);
    if (rho < 1e-4 * a) {
        // The bracket of B_rho loses its digits at the axis; there B_rho = -rho/2 dB_z/dz up to rho^3.
        const double square = a * a + z * z;
        const double slope =
            -1.5 * Permeability_T_m_per_A * loop.turns * a * a * z / (square * square * std::sqrt(square));
        return along * loop.axis - 0.5 * slope * across;
    }
    const double radial = scale * z / rho * (-first + (a * a + rho * rho + z * z) / inner * second);
    return along * loop.axis + radial / rho * across;
}

} // namespace halbench::models
