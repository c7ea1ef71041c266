#pragma once

#include "control/base/result.h"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace halbench::control {

/// Samples of a loop that is excited periodically while it turns steadily: whole periods of the excitation,
/// what settles before them left out.
struct ExcitedRows {
    double period_s = 0.01;            ///< of the samples
    std::size_t rowsPerPeriod = 0;     ///< M: one period of the excitation
    std::vector<int> lines;            ///< excited multiples of 1/(M period_s), ascending, below M/2
    double turn_rad_s = 0.0;           ///< base motion, whose harmonics are disturbances; 0: there is none
    std::span<const double> reference; ///< r, where the excitation enters: the instrument
    std::span<const double> input;     ///< u of the plant
    std::span<const double> output;    ///< y of the plant
};

/// The plant at one frequency.
struct PlantPoint {
    double frequency_rad_s = 0.0;
    std::complex<double> value;
    double radius = 0.0; ///< 95 % circle of confidence around `value`, of what scatters between the periods
    double coherence = 0.0; ///< the smaller one of r with u and of r with y
    int averages = 0;
};

/// 1 - alpha quantile of Fisher's F with 2 and nu degrees of freedom: nu/2 (alpha^(-2/nu) - 1).
double fisherQuantileOfTwo(double alpha, double freedom);

/// Indirect (joint input-output) estimate with the excitation as instrument: with the Fourier coefficients
/// R_p, U_p, Y_p of the p-th of P periods
///
///     G = S_yr / S_ur,    S_yr = sum Y_p conj(R_p),    S_ur = sum U_p conj(R_p)
///
/// which the feedback does not bias, because a disturbance has nothing in common with r (Soderstrom and
/// Stoica 1989, section 8.2; Wellstead 1981): Y_p = G U_p + E_p. The radius is that of
///
///     |error|^2 <= F(2, 2 (P-1)) s^2 sum |R_p|^2 / |S_ur|^2,    s^2 = sum |Y_p - G U_p|^2 / (P - 1)
///
/// (Pintelon and Schoukens 2012, section 2.5). Mean, drift and the harmonics of the base motion's turn are
/// fitted beside the lines and taken out first. Help: resources/help/htm-theory.md 7.6.
/// Errors: InvalidInput (lengths, fewer than four periods, lines), NotFinite, Refused (nothing was excited).
Result<std::vector<PlantPoint>> estimatePlant(const ExcitedRows& rows);

} // namespace halbench::control
