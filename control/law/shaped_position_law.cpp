#include "control/law/shaped_position_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::control {

namespace {

double sign(double value) {
    return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

} // namespace

ShapedPositionLaw::ShapedPositionLaw(ShapedController controller, const PositionLaw& extras,
                                     double currentLimit_A)
    : m_controller(std::move(controller)), m_extras(extras), m_limit_A(currentLimit_A) {}

Result<ShapedPositionLaw> ShapedPositionLaw::make(const ShapedLaw& law, const PositionLaw& extras,
                                                  double period_s, double currentLimit_A) {
    if (!(std::isfinite(currentLimit_A) && currentLimit_A > 0.0)) {
        return failure(ErrorCode::OutOfRange, "the current limit must be positive");
    }
    auto controller = ShapedController::make(law, period_s);
    return controller
               ? Result<ShapedPositionLaw>(ShapedPositionLaw(*std::move(controller), extras, currentLimit_A))
               : failure(controller.error());
}

double ShapedPositionLaw::extras_A(const Reference& reference, double error_rad) const {
    const double speed = std::abs(reference.speed_rad_s);
    const double friction = speed >= m_extras.coulombSpeed_rad_s
                                ? sign(reference.speed_rad_s)
                                : reference.speed_rad_s / m_extras.coulombSpeed_rad_s;
    const bool isHeld =
        speed < m_extras.stictionSpeed_rad_s && std::abs(error_rad) > m_extras.stictionThreshold_rad;
    return m_extras.inertia_A_s2_rad * reference.acceleration_rad_s2 +
           m_extras.viscous_A_s_rad * reference.speed_rad_s + m_extras.coulomb_A * friction +
           (isHeld ? m_extras.stictionCurrent_A * sign(error_rad) : 0.0);
}

double ShapedPositionLaw::step(const Reference& reference, double angle_rad) {
    const double error_rad = reference.angle_rad - angle_rad;
    const double demand_A =
        m_controller.demand_A(reference.angle_rad, angle_rad) + extras_A(reference, error_rad);
    const double current_A = std::clamp(demand_A, -m_limit_A, m_limit_A);
    if (current_A == demand_A || error_rad * demand_A < 0.0) {
        m_controller.integrate(error_rad);
    }
    return current_A;
}

} // namespace halbench::control
