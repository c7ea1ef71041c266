#pragma once

#include "control/base/result.h"

#include <span>

namespace halbench::control {

/// What two Hall sensors make of a turning field:
///   a = offset_a + A cos(psi),   b = offset_b + A gain sin(psi + quadrature).
struct HallEllipse {
    double offsetA_T = 0.0;
    double offsetB_T = 0.0;
    double gain_ratio = 1.0;     ///< amplitude of b over a
    double quadrature_rad = 0.0; ///< b sees sin(psi + this)
    double amplitude_T = 0.0;    ///< of a
};

struct HallEllipseFit {
    HallEllipse ellipse;
    HallEllipse error;           ///< 1 sigma of each value, from fits to parts of the record
    double residual_ratio = 0.0; ///< rms distance from the ellipse over its amplitude
    int parts = 0;
};

/// The conic x^2 + p x y + q y^2 + r x + s y + t = 0 by linear least squares, in units of the amplitude, then
///   gain = 1/sqrt(q), sin(quadrature) = -p gain/2, offsets = centre.
/// Noise biases it by (noise/amplitude)^2, 1e-6 here. The record is cut into eight parts of equal length,
/// whose scatter gives the errors; at least four must go round: no 60 degrees of the circle without a
/// reading, and an rms distance of at most 0.2 of the amplitude. With `parts` of them, 95 % lie within
/// Student's t of parts - 1 degrees of freedom. Errors: Refused (fewer than 80 samples, or they do not go
/// round), NotFinite. Source: resources/help/identification.md section 6.
Result<HallEllipseFit> fitHallEllipse(std::span<const double> a_T, std::span<const double> b_T);

/// psi from the two readings under a calibration, (-pi, pi].
double hallAngle_rad(const HallEllipse& calibration, double a_T, double b_T);

/// rms of the once and more per turn angle error that `calibration` makes on what `truth` describes; a
/// constant offset does not count.
double hallAngleError_rad(const HallEllipse& calibration, const HallEllipse& truth);

} // namespace halbench::control
