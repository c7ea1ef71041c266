#include "app/procedures/calibrate/ellipse_shape.h"

#include "control/base/units.h"

#include <Eigen/Dense>
#include <cmath>

namespace halbench::app {

EllipseAxes ellipseAxes(const control::HallEllipse& ellipse) {
    const double gained = ellipse.amplitude_T * ellipse.gain_ratio;
    Eigen::Matrix2d map;
    map << ellipse.amplitude_T, 0.0, gained * std::sin(ellipse.quadrature_rad),
        gained * std::cos(ellipse.quadrature_rad);
    const Eigen::Vector2d radii = Eigen::JacobiSVD<Eigen::Matrix2d>(map).singularValues();
    return {radii(0), radii(1)};
}

EllipseCurve ellipseCurve(const control::HallEllipse& ellipse, std::size_t points) {
    EllipseCurve curve;
    for (std::size_t i = 0; i <= points; ++i) {
        const double psi = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(points);
        curve.a.push_back(ellipse.offsetA_T + ellipse.amplitude_T * std::cos(psi));
        curve.b.push_back(ellipse.offsetB_T +
                          ellipse.amplitude_T * ellipse.gain_ratio * std::sin(psi + ellipse.quadrature_rad));
    }
    return curve;
}

} // namespace halbench::app
