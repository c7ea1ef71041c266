#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace halbench::models {

/// One further spherical harmonic of a rotor's field, in the rotor's frame (theta from the shaft z):
///   B_r = A (r_ref/r)^(l+2) U(theta) cos(m phi),   B_theta = -A/(l+1) (r_ref/r)^(l+2) U'(theta) cos(m phi),
///   B_phi = A m/(l+1) (r_ref/r)^(l+2) U(theta)/sin(theta) sin(m phi),   l degree, m order.
/// U = sin^m(theta) G(cos theta) is the associated Legendre function scaled so that the lowest coefficient of
/// G is +-1: U22 = s^2, U42 = s^2 (7 c^2 - 1), U62 = s^2 (33 c^4 - 18 c^2 + 1), U66 = s^6.
/// Source: resources/help/spherical-theory.md section 3.4.
struct SphericalHarmonicTerm {
    int degree = 2;
    int order = 2;
    double amplitude_T = 0.0; ///< A, at the reference radius
};

/// Degrees 1 ... 16 with 0 <= order <= degree and finite amplitude; else OutOfRange or NotFinite.
Result<void> checkHarmonicTerm(const SphericalHarmonicTerm& term);

/// Presets of amplitudes at 50 mm: H0 none, H1 imitates a finite-element run, H2 is a stress case.
enum class HarmonicPreset { H0, H1, H2 };
std::vector<SphericalHarmonicTerm> harmonicPreset(HarmonicPreset preset);

/// Field and its gradient at a point of the rotor's frame.
struct HarmonicField {
    Eigen::Vector3d field_T = Eigen::Vector3d::Zero();
    Eigen::Matrix3d gradient_T_per_m = Eigen::Matrix3d::Zero(); ///< (i, j) = d B_i / d x_j; symmetric
};

/// Sum of harmonic terms, prepared once. Works in Cartesian coordinates on the solid harmonics
/// Re[(x + j y)^m] sum g_k z^k r^-(l+m+1+k), so that it is finite and smooth at the poles too. No allocation
/// after construction.
class SphericalHarmonicSeries {
public:
    static constexpr int MaxDegree = 16;

    SphericalHarmonicSeries() = default;
    /// Terms have passed checkHarmonicTerm().
    SphericalHarmonicSeries(const std::vector<SphericalHarmonicTerm>& terms, double referenceRadius_m);

    bool isEmpty() const { return m_terms.empty(); }
    const std::vector<SphericalHarmonicTerm>& terms() const { return m_terms; }
    /// The point must not be the centre.
    Eigen::Vector3d field_T(const Eigen::Vector3d& point_m) const;
    HarmonicField fieldAndGradient(const Eigen::Vector3d& point_m) const;
    /// Field of one term at amplitude 1 T: the series is linear in its amplitudes.
    Eigen::Vector3d unitField(std::size_t term, const Eigen::Vector3d& point_m) const;

private:
    /// g_k of G(c) = sum g_k c^k
    using Coefficients = std::array<double, MaxDegree + 1>;

    std::vector<SphericalHarmonicTerm> m_terms;
    std::vector<Coefficients> m_coefficients;
    double m_referenceRadius_m = 1.0;
};

} // namespace halbench::models
