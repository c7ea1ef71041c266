#pragma once

namespace halbench::control {

/// Distribution functions by the regularised incomplete beta and gamma functions (Lentz's continued fraction
/// and the power series; Press et al., Numerical Recipes 3rd ed., 6.2 and 6.4). Quantiles by bisection on
/// them. Relative accuracy about 1e-12. Arguments outside their range are bugs of the caller.

/// I_x(a, b) for a, b > 0 and 0 <= x <= 1.
double incompleteBeta(double a, double b, double x);

/// P(|t| <= value) complement: probability that Student's t with `freedom` > 0 degrees exceeds |value| on
/// either side; with infinite freedom the normal distribution.
double studentTwoSided(double value, double freedom);

/// t with P(T <= t) = probability, 0 < probability < 1; e.g. 0.975 and 11 degrees: 2.201.
double studentQuantile(double probability, double freedom);

/// P(F > value) of Fisher's F.
double fisherTail(double value, double numeratorFreedom, double denominatorFreedom);

/// P(X > value) of chi-square.
double chiSquareTail(double value, double freedom);

/// x with P(X <= x) = probability of chi-square with `freedom` > 0 degrees, which need not be whole.
double chiSquareQuantile(double probability, double freedom);

/// Standard normal distribution function and its inverse.
double normalProbability(double value);
double normalQuantile(double probability);

} // namespace halbench::control
