#pragma once

#include <complex>
#include <vector>

namespace halbench::control {

/// Real coefficients in descending powers, as books print them: {1, 2, 3} is s^2 + 2 s + 3.
using Polynomial = std::vector<double>;

/// Without leading zeros; the zero polynomial is {0}.
Polynomial trimmed(Polynomial polynomial);
Polynomial multiply(const Polynomial& first, const Polynomial& second);
Polynomial add(const Polynomial& first, const Polynomial& second);
Polynomial scale(const Polynomial& polynomial, double factor);
int degree(const Polynomial& polynomial);

/// Value at a point, by Horner's rule.
std::complex<double> evaluate(const Polynomial& polynomial, std::complex<double> x);

/// prod (x - root); the roots must be real or come in conjugate pairs.
Polynomial fromRoots(const std::vector<std::complex<double>>& roots);

/// All roots, by the simultaneous iteration of Aberth (1973) on the scaled polynomial; roots at zero and, as
/// far as the coefficients tell, at 1 and -1 (sampled integrators, however many) are exact, complex roots
/// come in exact conjugate pairs. A root of multiplicity m is found to about
/// (machine precision)^(1/m). Empty for a constant.
std::vector<std::complex<double>> roots(const Polynomial& polynomial);

} // namespace halbench::control
