#pragma once

#include <complex>
#include <vector>

namespace halbench::control {

/// Roots of a real polynomial that were found one by one: each is averaged with its conjugate partner, or
/// made real when it is its own nearest partner. Partners stand next to each other.
std::vector<std::complex<double>> inConjugatePairs(const std::vector<std::complex<double>>& points);

} // namespace halbench::control
