#include "models/fields/spherical_harmonic_term.h"

#include "control/base/assert.h"

#include <cmath>
#include <complex>

namespace halbench::models {
namespace {

using Coefficients = std::array<double, SphericalHarmonicSeries::MaxDegree + 1>;

/// Coefficients of the m-th derivative of the Legendre polynomial P_l, the lowest one scaled to +-1.
Coefficients legendreCoefficients(int degree, int order) {
    // (l + 1) P_(l+1) = (2 l + 1) x P_l - l P_(l-1)
    Coefficients previous{};
    Coefficients current{};
    previous[0] = 1.0;
    current[1] = 1.0;
    for (int l = 1; l < degree; ++l) {
        Coefficients next{};
        for (std::size_t k = 0; k < next.size(); ++k) {
            const double raised = k > 0 ? current[k - 1] : 0.0;
            next[k] = ((2.0 * l + 1.0) * raised - l * previous[k]) / (l + 1.0);
        }
        previous = current;
        current = next;
    }
    for (int m = 0; m < order; ++m) {
        for (std::size_t k = 0; k + 1 < current.size(); ++k) {
            current[k] = static_cast<double>(k + 1) * current[k + 1];
        }
        current.back() = 0.0;
    }
    const double lowest = std::abs(current[(degree - order) % 2 == 0 ? 0 : 1]);
    for (double& value : current) {
        value /= lowest;
    }
    return current;
}

double integerPower(double base, int exponent) {
    double result = 1.0;
    for (int i = 0; i < exponent; ++i) {
        result *= base;
    }
    return result;
}

std::complex<double> integerPower(std::complex<double> base, int exponent) {
    std::complex<double> result = 1.0;
    for (int i = 0; i < exponent; ++i) {
        // Written out: the library's product checks for infinities, which takes longer than the product.
        result = {result.real() * base.real() - result.imag() * base.imag(),
                  result.real() * base.imag() + result.imag() * base.real()};
    }
    return result;
}

/// Potential of a term at amplitude (l + 1) T in units of the reference radius: V = C(x, y) H(z, s), s = r^2,
///   C = Re[(x + j y)^m],   H = sum g_k z^k s^-p_k,   p_k = (l + m + 1 + k)/2.
struct AxialFactor {
    double value = 0.0;
    double z = 0.0; ///< partial derivatives, by z at fixed s and by s
    double s = 0.0;
    double zz = 0.0;
    double zs = 0.0;
    double ss = 0.0;
};

AxialFactor axialFactor(const SphericalHarmonicTerm& term, const Coefficients& g, double z, double s) {
    const double inverse = 1.0 / std::sqrt(s);
    const int lowest = (term.degree - term.order) % 2;
    double fall = integerPower(inverse, term.degree + term.order + 1 + lowest);
    AxialFactor factor;
    for (int k = lowest; k <= term.degree - term.order; k += 2) {
        const double weight = g[static_cast<std::size_t>(k)] * fall;
        const double p = 0.5 * (term.degree + term.order + 1 + k);
        const double power = integerPower(z, k);
        const double slope = k > 0 ? k * integerPower(z, k - 1) : 0.0;
        const double bend = k > 1 ? k * (k - 1.0) * integerPower(z, k - 2) : 0.0;
        factor.value += weight * power;
        factor.z += weight * slope;
        factor.zz += weight * bend;
        factor.s -= weight * power * p / s;
        factor.zs -= weight * slope * p / s;
        factor.ss += weight * power * p * (p + 1.0) / (s * s);
        fall *= inverse * inverse;
    }
    return factor;
}

struct PlanarFactor {
    double value = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

PlanarFactor planarFactor(int order, double x, double y) {
    PlanarFactor factor;
    if (order == 0) {
        factor.value = 1.0;
        return factor;
    }
    const std::complex<double> lower = integerPower(std::complex<double>(x, y), order - 1);
    factor.value = lower.real() * x - lower.imag() * y;
    factor.gradient = {order * lower.real(), -order * lower.imag(), 0.0};
    return factor;
}

Eigen::Matrix3d planarBend(int order, double x, double y) {
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();
    if (order > 1) {
        const std::complex<double> lower =
            order * (order - 1.0) * integerPower(std::complex<double>(x, y), order - 2);
        bend.topLeftCorner<2, 2>() << lower.real(), -lower.imag(), -lower.imag(), -lower.real();
    }
    return bend;
}

} // namespace

Result<void> checkHarmonicTerm(const SphericalHarmonicTerm& term) {
    if (!std::isfinite(term.amplitude_T)) {
        return failure(ErrorCode::NotFinite, "The amplitude of a spherical harmonic is not a finite number.");
    }
    if (term.degree < 1 || term.degree > SphericalHarmonicSeries::MaxDegree || term.order < 0 ||
        term.order > term.degree) {
        return failure(ErrorCode::OutOfRange,
                       "A spherical harmonic needs a degree of 1 to 16 and an order of "
                       "0 to its degree.");
    }
    return {};
}

std::vector<SphericalHarmonicTerm> harmonicPreset(HarmonicPreset preset) {
    if (preset == HarmonicPreset::H1) {
        return {{4, 2, -3.0e-3}, {6, 2, 1.0e-3}, {6, 6, 1.5e-3}, {10, 10, 0.5e-3}};
    }
    if (preset == HarmonicPreset::H2) {
        return {{4, 2, -111.7e-3}, {6, 2, 18.3e-3}};
    }
    return {};
}

SphericalHarmonicSeries::SphericalHarmonicSeries(const std::vector<SphericalHarmonicTerm>& terms,
                                                 double referenceRadius_m)
    : m_terms(terms), m_referenceRadius_m(referenceRadius_m) {
    HB_ASSERT(referenceRadius_m > 0.0);
    for (const SphericalHarmonicTerm& term : terms) {
        HB_ASSERT(checkHarmonicTerm(term).has_value());
        m_coefficients.push_back(legendreCoefficients(term.degree, term.order));
    }
}

Eigen::Vector3d SphericalHarmonicSeries::unitField(std::size_t term, const Eigen::Vector3d& point_m) const {
    const Eigen::Vector3d p = point_m / m_referenceRadius_m;
    const SphericalHarmonicTerm& shape = m_terms.at(term);
    const AxialFactor axial = axialFactor(shape, m_coefficients[term], p.z(), p.squaredNorm());
    const PlanarFactor planar = planarFactor(shape.order, p.x(), p.y());
    const Eigen::Vector3d slope = axial.z * Eigen::Vector3d::UnitZ() + 2.0 * axial.s * p;
    return -(planar.value * slope + axial.value * planar.gradient) / (shape.degree + 1.0);
}

Eigen::Vector3d SphericalHarmonicSeries::field_T(const Eigen::Vector3d& point_m) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < m_terms.size(); ++i) {
        sum += m_terms[i].amplitude_T * unitField(i, point_m);
    }
    return sum;
}

HarmonicField SphericalHarmonicSeries::fieldAndGradient(const Eigen::Vector3d& point_m) const {
    const Eigen::Vector3d p = point_m / m_referenceRadius_m;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    HarmonicField sum;
    for (std::size_t i = 0; i < m_terms.size(); ++i) {
        const SphericalHarmonicTerm& term = m_terms[i];
        const double scale = -term.amplitude_T / (term.degree + 1.0);
        const AxialFactor axial = axialFactor(term, m_coefficients[i], p.z(), p.squaredNorm());
        const PlanarFactor planar = planarFactor(term.order, p.x(), p.y());
        const Eigen::Vector3d slope = axial.z * up + 2.0 * axial.s * p;
        const Eigen::Matrix3d bend =
            axial.zz * up * up.transpose() + 2.0 * axial.zs * (up * p.transpose() + p * up.transpose()) +
            4.0 * axial.ss * p * p.transpose() + 2.0 * axial.s * Eigen::Matrix3d::Identity();
        sum.field_T += scale * (planar.value * slope + axial.value * planar.gradient);
        sum.gradient_T_per_m +=
            (scale / m_referenceRadius_m) *
            (planar.value * bend + planar.gradient * slope.transpose() + slope * planar.gradient.transpose() +
             axial.value * planarBend(term.order, p.x(), p.y()));
    }
    return sum;
}

} // namespace halbench::models
