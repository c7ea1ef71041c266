#pragma once

#include "control/lti/state_space.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// The same system with states scaled by powers of two so that rows and columns of [A B; C 0] are of similar
/// size: what rates decades apart need before any matrix algorithm. Exact; poles, zeros and responses stay.
StateSpace prescaled(const StateSpace& system);

/// Without the states that no input reaches or no output shows, by orthogonal staircases (Varga 1981). What
/// is smaller than `tolerance_ratio` of the norm of the prescaled [A B; C 0] counts as nothing.
StateSpace minimalRealization(const StateSpace& system, double tolerance_ratio = 1e-10);

/// Invariant zeros of one path with the gain of its factored form: G(s) = gain prod(s - zero)/prod(s - pole).
struct PathZeros {
    std::vector<std::complex<double>> zeros;
    double gain = 0.0; ///< first Markov parameter that is not zero; 0 for a path that carries nothing
};
/// The output is held at zero state by state with orthogonal transformations until the input acts directly
/// (Emami-Naeini, Van Dooren 1982), then the rest is a generalised eigenvalue problem: zeros at infinity
/// never enter the numbers. Indices must exist.
PathZeros pathZeros(const StateSpace& system, Eigen::Index output = 0, Eigen::Index input = 0);
std::vector<std::complex<double>> zeros(const StateSpace& system, Eigen::Index output = 0,
                                        Eigen::Index input = 0);

} // namespace halbench::control
