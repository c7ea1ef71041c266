#pragma once

#include "control/identify/ellipse_fit.h"

#include <vector>

namespace halbench::app {

/// The longest and the shortest radius of the ellipse: singular values of
///   (a, b) = [A, 0; A gain sin(quadrature), A gain cos(quadrature)] (cos psi, sin psi).
struct EllipseAxes {
    double large = 0.0;
    double small = 0.0;
};
EllipseAxes ellipseAxes(const control::HallEllipse& ellipse);

struct EllipseCurve {
    std::vector<double> a;
    std::vector<double> b;
};
/// Closed, in `points` steps of equal angle.
EllipseCurve ellipseCurve(const control::HallEllipse& ellipse, std::size_t points);

} // namespace halbench::app
