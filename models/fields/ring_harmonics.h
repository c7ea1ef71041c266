#pragma once

#include "models/fields/halbach_ring.h"

#include <complex>
#include <vector>

namespace halbench::models {

/// The radial field on a circle inside a ring, as the rotor turns under one sensor, per turn:
///   B(theta) = mean + sum over n of Re[c_n e^{-j n theta}] = sum a_n cos(n theta) + b_n sin(n theta),
/// c_n = a_n + j b_n, theta = psi - place of the sensor: the same series serves every sensor on the circle.
struct RingHarmonics {
    double mean_T = 0.0;
    std::vector<std::complex<double>> amplitude_T; ///< [n - 1] = c_n, n = 1 ... orders

    double magnitude_T(int order) const;
};

/// Radial field at `samples` equally spaced rotor angles theta_i = 2 pi i/samples, height z above the
/// mid-plane.
std::vector<double> radialFieldPerTurn_T(const HalbachRing& ring, double radius_m, double height_m,
                                         int samples);

/// Fourier series of one period; exact for orders below samples/2.
RingHarmonics harmonicsOf(const std::vector<double>& perTurn_T, int orders);

/// Angle error of two sensors 90 degrees apart that decode by arctangent, rad, its mean removed (the zero of
/// the angle is free), for every rotor angle of `perTurn_T`. The number of samples must be divisible by four.
std::vector<double> arctangentErrors_rad(const std::vector<double>& perTurn_T);

} // namespace halbench::models
