#pragma once

#include "control/lti/transfer_function.h"
#include "control/lti/zero_pole_gain.h"

#include <Eigen/Core>
#include <complex>
#include <vector>

// Second routes by matrices: nothing here evaluates a polynomial or scans a grid as the library does.
namespace halbench::control {

/// A chain of sections: no product of polynomials.
StateSpace sectionsOf(const TransferFunction& system);

Eigen::VectorXcd realEigenvalues(const Eigen::MatrixXd& A);

/// A - B C K/(1 + K D): its eigenvalues are the poles of the loop closed over the gain K, complex or not.
Eigen::VectorXcd closedPoles(const StateSpace& loop, std::complex<double> gain);

double distanceTo(const Eigen::VectorXcd& values, std::complex<double> place);

/// Where a pole on the limit of stability lies that turns with this frequency.
std::complex<double> boundaryPoint(const TimeBase& base, double frequency_rad_s);

/// Closed-loop poles on the wrong side.
int unstableCount(const StateSpace& loop, double gain);

/// 1/(1 + L) and L/(1 + L) as matrices.
StateSpace sensitivityOf(const StateSpace& L);
StateSpace complementOf(const StateSpace& L);

/// D + C (x - A)^-1 B by elimination with full pivoting.
std::complex<double> valueAt(const StateSpace& system, std::complex<double> x);

/// Frequencies at which the magnitude of a continuous system is `level`: imaginary eigenvalues of the
/// Hamiltonian matrix, those within `share` of the axis among them.
std::vector<double> levelFrequencies(const StateSpace& system, double level, double share = 1e-7);

/// Largest magnitude over frequency (Boyd, Balakrishnan, Kabamba 1989; Bruinsma, Steinbuch 1990): the middle
/// of a stretch above a level is a better one, with quadratic convergence. A sampled system by way of
/// z = (1 + s)/(1 - s).
double largestMagnitude(const StateSpace& system);

/// What rounding does to a rational value there: how much larger the terms of its polynomials are than their
/// sums. Near z = 1 a sampled loop of n slow poles loses n digits a decade of w T.
double roundingOf(const TransferFunction& system, double frequency_rad_s);

} // namespace halbench::control
