#pragma once

#include "models/planar/planar_geometry.h"

#include <complex>

namespace halbench::models {

/// Integral of a plane wave's even part over all turns of a flat coil, per layer, m^2 turns:
///   W(A, B) = lambda integral_0^a dr double integral over the turn at offset r of cos(A u) cos(B v) du dv.
/// The turn at offset r encloses the window p x q grown by r on all sides, with corners of radius r. A and B
/// in rad/m; complex ones give derivatives: Im W(A + i h A', B + i h B')/h. Gauss quadrature over r and over
/// the corners, straight strips in closed form: error below 1e-12 of the window's share up to the ninth
/// order. Source: resources/help/planar-theory.md section 5.3.
std::complex<double> windingShape_m2(const PlanarGeometry& geometry, std::complex<double> A,
                                     std::complex<double> B);

} // namespace halbench::models
