#include "control/lti/polynomial.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/lti/conjugate_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// p(x)/p'(x), from the reversed polynomial outside the unit circle so that no power overflows.
Complex newtonStep(const Polynomial& p, Complex x) {
    const std::size_t n = p.size() - 1;
    const bool isOutside = std::abs(x) > 1.0;
    const Complex y = isOutside ? 1.0 / x : x;
    Complex value = 0.0;
    Complex slope = 0.0;
    for (std::size_t i = 0; i <= n; ++i) {
        slope = slope * y + value;
        value = value * y + (isOutside ? p[n - i] : p[i]);
    }
    if (!isOutside) {
        return slope == 0.0 ? Complex(1e-3) : value / slope;
    }
    // q(y) = y^n p(1/y):  p/p' = x / (n - y q'/q)
    if (value == 0.0) {
        return 0.0;
    }
    return x / (static_cast<double>(n) - y * slope / value);
}

/// The value at x is nothing but rounding: x is a root as far as the coefficients tell.
bool isRootToRounding(const Polynomial& p, Complex x) {
    double bound = 0.0;
    const bool isOutside = std::abs(x) > 1.0;
    const Complex y = isOutside ? 1.0 / x : x;
    Complex value = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double coefficient = isOutside ? p[p.size() - 1 - i] : p[i];
        value = value * y + coefficient;
        bound = bound * std::abs(y) + std::abs(coefficient);
    }
    return std::abs(value) <= 2.0 * std::numeric_limits<double>::epsilon() * bound;
}

/// Divides by (x - root) as often as the remainder is nothing but rounding.
void takeOut(Polynomial& p, double root, std::vector<Complex>& found) {
    while (p.size() > 1) {
        double value = 0.0;
        double bound = 0.0;
        Polynomial quotient;
        for (const double coefficient : p) {
            value = value * root + coefficient;
            bound += std::abs(coefficient);
            quotient.push_back(value);
        }
        const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(p.size());
        if (std::abs(value) > rounding * bound) {
            return;
        }
        quotient.pop_back();
        p = std::move(quotient);
        found.emplace_back(root, 0.0);
    }
}

void takeOutZeros(Polynomial& p, std::vector<Complex>& found) {
    while (p.size() > 1 && p.back() == 0.0) {
        p.pop_back();
        found.emplace_back(0.0, 0.0);
    }
}

/// Points on a circle, turned so that none is real and no two are conjugate.
std::vector<Complex> startingPoints(std::size_t count) {
    std::vector<Complex> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double radius = 0.9 + 0.2 * static_cast<double>(i) / static_cast<double>(count);
        points[i] =
            std::polar(radius, 2.0 * Pi * (static_cast<double>(i) + 0.3) / static_cast<double>(count));
    }
    return points;
}

/// One round of Aberth's iteration; returns the largest relative move.
double improve(const Polynomial& p, std::vector<Complex>& points) {
    double largest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isRootToRounding(p, points[i])) {
            continue;
        }
        Complex repulsion = 0.0;
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j != i && points[i] != points[j]) {
                repulsion += 1.0 / (points[i] - points[j]);
            }
        }
        const Complex step = newtonStep(p, points[i]);
        const Complex move = step / (1.0 - step * repulsion);
        if (std::isfinite(move.real()) && std::isfinite(move.imag())) {
            points[i] -= move;
            largest = std::max(largest, std::abs(move) / std::max(std::abs(points[i]), 1e-300));
        }
    }
    return largest;
}

} // namespace

Polynomial trimmed(Polynomial polynomial) {
    const auto first = std::find_if(polynomial.begin(), polynomial.end(), [](double c) { return c != 0.0; });
    polynomial.erase(polynomial.begin(), first);
    if (polynomial.empty()) {
        polynomial.push_back(0.0);
    }
    return polynomial;
}

Polynomial multiply(const Polynomial& first, const Polynomial& second) {
    Polynomial product(first.size() + second.size() - 1, 0.0);
    for (std::size_t i = 0; i < first.size(); ++i) {
        for (std::size_t j = 0; j < second.size(); ++j) {
            product[i + j] += first[i] * second[j];
        }
    }
    return trimmed(std::move(product));
}

Polynomial add(const Polynomial& first, const Polynomial& second) {
    const Polynomial& longer = first.size() >= second.size() ? first : second;
    const Polynomial& shorter = first.size() >= second.size() ? second : first;
    Polynomial sum = longer;
    const std::size_t offset = longer.size() - shorter.size();
    for (std::size_t i = 0; i < shorter.size(); ++i) {
        sum[offset + i] += shorter[i];
    }
    return trimmed(std::move(sum));
}

Polynomial scale(const Polynomial& polynomial, double factor) {
    Polynomial result = polynomial;
    for (double& coefficient : result) {
        coefficient *= factor;
    }
    return trimmed(std::move(result));
}

int degree(const Polynomial& polynomial) {
    return static_cast<int>(trimmed(polynomial).size()) - 1;
}

std::complex<double> evaluate(const Polynomial& polynomial, std::complex<double> x) {
    // Written out: the compiler's complex product checks every factor for infinities, five times the work.
    const double xr = x.real();
    const double xi = x.imag();
    double re = 0.0;
    double im = 0.0;
    for (const double coefficient : polynomial) {
        const double next = re * xr - im * xi + coefficient;
        im = re * xi + im * xr;
        re = next;
    }
    return {re, im};
}

Polynomial fromRoots(const std::vector<std::complex<double>>& roots) {
    std::vector<Complex> product = {1.0};
    for (const Complex& root : roots) {
        product.push_back(0.0);
        for (std::size_t i = product.size() - 1; i > 0; --i) {
            product[i] -= root * product[i - 1];
        }
    }
    Polynomial result;
    for (const Complex& coefficient : product) {
        result.push_back(coefficient.real());
    }
    return result;
}

std::vector<std::complex<double>> roots(const Polynomial& polynomial) {
    Polynomial p = trimmed(polynomial);
    std::vector<Complex> result;
    takeOutZeros(p, result);
    takeOut(p, 1.0, result);
    takeOut(p, -1.0, result);
    takeOutZeros(p, result); // of roots so near to 0 that nothing of them is left beside 1
    const std::size_t n = p.size() - 1;
    if (n == 0) {
        return result;
    }
    // x = radius y makes the product of the roots one: coefficients of similar size, no overflow.
    const double radius = std::exp(std::log(std::abs(p.back() / p.front())) / static_cast<double>(n));
    HB_ASSERT(radius > 0.0 && std::isfinite(radius));
    double power = 1.0;
    for (double& coefficient : p) {
        coefficient /= power;
        power *= radius;
    }
    constexpr int MaxRounds = 500;
    std::vector<Complex> points = startingPoints(n);
    for (int round = 0; round < MaxRounds && improve(p, points) > 1e-16; ++round) {
    }
    for (const Complex& point : inConjugatePairs(points)) {
        result.push_back(radius * point);
    }
    return result;
}

} // namespace halbench::control
