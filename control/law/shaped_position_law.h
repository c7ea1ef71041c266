#pragma once

#include "control/law/shaped_controller.h"

namespace halbench::control {

/// A shaped law as a controller runs it, once per sample:
///     v = F [ K_P (b r - y) + x + D (c r - y) ]
///         + inertia r'' + viscous r' + coulomb sat(r'/coulombSpeed)
///         + (|r'| < stictionSpeed and |r - y| > stictionThreshold) stictionCurrent sgn(r - y)
///     u = clamp(v);   if (u = v or (r - y) v < 0)  x <- x + T_s K_I (r - y)
/// The filters keep running while u is limited: they are stable by themselves. r' and r'' feed forward only;
/// the derivative sees of the reference what its weight c takes. From rest at zero.
class ShapedPositionLaw {
public:
    struct Reference {
        double angle_rad = 0.0;
        double speed_rad_s = 0.0;
        double acceleration_rad_s2 = 0.0;
    };

    /// `extras` are the parts of the law beside its gains. Errors: of `checkedGains`; OutOfRange (the limit).
    static Result<ShapedPositionLaw> make(const ShapedLaw& law, const PositionLaw& extras, double period_s,
                                          double currentLimit_A);

    /// The current in A, without the computing delay of the loop.
    double step(const Reference& reference, double angle_rad);

private:
    ShapedPositionLaw(ShapedController controller, const PositionLaw& extras, double currentLimit_A);
    double extras_A(const Reference& reference, double error_rad) const;

    ShapedController m_controller;
    PositionLaw m_extras;
    double m_limit_A;
};

} // namespace halbench::control
