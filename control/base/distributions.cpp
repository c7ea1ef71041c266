#include "control/base/distributions.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::control {
namespace {

constexpr double Tiny = 1e-300;
constexpr double Precision = 1e-16;
constexpr int MostTerms = 10000;

double awayFromZero(double value) {
    return std::fabs(value) < Tiny ? Tiny : value;
}

// Continued fraction of the incomplete beta function, converges fast for x < (a + 1)/(a + b + 2).
double betaFraction(double a, double b, double x) {
    double c = 1.0;
    double d = 1.0 / awayFromZero(1.0 - (a + b) * x / (a + 1.0));
    double fraction = d;
    for (int m = 1; m < MostTerms; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1.0 / awayFromZero(1.0 + even * d);
        c = awayFromZero(1.0 + even / c);
        fraction *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1.0 / awayFromZero(1.0 + odd * d);
        c = awayFromZero(1.0 + odd / c);
        fraction *= d * c;
        if (std::fabs(d * c - 1.0) < Precision) {
            break;
        }
    }
    return fraction;
}

// Upper regularised incomplete gamma function Q(a, x).
double gammaTail(double a, double x) {
    const double scale = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int n = 1; n < MostTerms && term > sum * Precision; ++n) {
            term *= x / (a + n);
            sum += term;
        }
        return 1.0 - sum * scale;
    }
    double b = x + 1.0 - a;
    double c = 1.0 / Tiny;
    double d = 1.0 / b;
    double fraction = d;
    for (int n = 1; n < MostTerms; ++n) {
        const double an = -n * (n - a);
        b += 2.0;
        d = 1.0 / awayFromZero(an * d + b);
        c = awayFromZero(b + an / c);
        fraction *= d * c;
        if (std::fabs(d * c - 1.0) < Precision) {
            break;
        }
    }
    return fraction * scale;
}

// Solves probability(x) = target for an increasing function.
template <typename Function>
double invert(const Function& probability, double target) {
    double low = -1.0;
    double high = 1.0;
    while (probability(low) > target) {
        low *= 2.0;
    }
    while (probability(high) < target) {
        high *= 2.0;
    }
    for (int i = 0; i < 200 && high - low > 4e-16 * (std::fabs(low) + std::fabs(high)); ++i) {
        const double middle = 0.5 * (low + high);
        (probability(middle) < target ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace

double incompleteBeta(double a, double b, double x) {
    HB_ASSERT(a > 0.0 && b > 0.0 && x >= 0.0 && x <= 1.0);
    if (x == 0.0 || x == 1.0) {
        return x;
    }
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(a, b, x) / a
                                         : 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

double studentTwoSided(double value, double freedom) {
    HB_ASSERT(freedom > 0.0);
    if (std::isinf(freedom)) {
        return std::erfc(std::fabs(value) / std::sqrt(2.0));
    }
    return incompleteBeta(0.5 * freedom, 0.5, freedom / (freedom + value * value));
}

double studentQuantile(double probability, double freedom) {
    HB_ASSERT(probability > 0.0 && probability < 1.0 && freedom > 0.0);
    const auto below = [freedom](double t) {
        const double tail = 0.5 * studentTwoSided(t, freedom);
        return t < 0.0 ? tail : 1.0 - tail;
    };
    return probability == 0.5 ? 0.0 : invert(below, probability);
}

double fisherTail(double value, double numeratorFreedom, double denominatorFreedom) {
    HB_ASSERT(numeratorFreedom > 0.0 && denominatorFreedom > 0.0);
    if (!(value > 0.0)) {
        return 1.0;
    }
    return incompleteBeta(0.5 * denominatorFreedom, 0.5 * numeratorFreedom,
                          denominatorFreedom / (denominatorFreedom + numeratorFreedom * value));
}

double chiSquareTail(double value, double freedom) {
    HB_ASSERT(freedom > 0.0);
    return value > 0.0 ? gammaTail(0.5 * freedom, 0.5 * value) : 1.0;
}

double chiSquareQuantile(double probability, double freedom) {
    HB_ASSERT(probability > 0.0 && probability < 1.0 && freedom > 0.0);
    return invert([freedom](double value) { return 1.0 - chiSquareTail(value, freedom); }, probability);
}

double normalProbability(double value) {
    return 0.5 * std::erfc(-value / std::sqrt(2.0));
}

double normalQuantile(double probability) {
    HB_ASSERT(probability > 0.0 && probability < 1.0);
    return probability == 0.5 ? 0.0 : invert(normalProbability, probability);
}

} // namespace halbench::control
