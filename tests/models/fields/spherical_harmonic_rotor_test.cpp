#include "models/fields/spherical_harmonic_rotor.h"
#include "models/fields/spherical_harmonic_term.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace halbench::models {
namespace {

TEST(SphericalHarmonicRotor, strengthsAreThePublishedOnes) {
    const SphericalFieldStrength strength = sphericalFieldStrength({});
    // Constants in T mm^4 with nine digits; relative tolerance 2e-9 is their rounding.
    EXPECT_NEAR(strength.radial_T_m4 * 1e12, 1859746.47, 2e-9 * 1859746.47);
    EXPECT_NEAR(strength.polar_T_m4 * 1e12, -619915.489, 2e-9 * 619915.489);
    EXPECT_NEAR(strength.azimuthal_T_m4 * 1e12, 1239830.98, 4e-9 * 1239830.98);
    EXPECT_NEAR(tensorStrength_T({}, 0.05), 0.0991864782, 1e-9 * 0.0992);
    // The ratio 3 : -1 : 2 makes curl and divergence vanish.
    EXPECT_NEAR(strength.radial_T_m4 / strength.polar_T_m4, -3.0, 1e-14);
    EXPECT_NEAR(strength.azimuthal_T_m4 / strength.polar_T_m4, -2.0, 1e-14);
    // At the rotor's surface 0.430125 T, six digits printed.
    EXPECT_NEAR(3.0 * tensorStrength_T({}, 45.6e-3), 0.430125, 5e-7);
}

TEST(SphericalHarmonicRotor, thinningShellLosesItsField) {
    SphericalRotorMagnet magnet;
    magnet.coreRadius_m = magnet.outerRadius_m * (1.0 - 1e-9);
    // The numerator vanishes linearly with the thickness: 1e-9 of a shell leaves about 1e-8 of the field.
    EXPECT_LT(std::abs(tensorStrength_T(magnet, 0.05)), 1e-8);
    EXPECT_EQ(checkSphericalRotorMagnet(magnet).has_value(), true);
    magnet.coreRadius_m = magnet.outerRadius_m;
    EXPECT_EQ(checkSphericalRotorMagnet(magnet).error().code, ErrorCode::OutOfRange);
    magnet.coreRadius_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(checkSphericalRotorMagnet(magnet).error().code, ErrorCode::NotFinite);
}

TEST(SphericalHarmonicRotor, tensorAndSphericalCoordinatesAgree) {
    const double q = tensorStrength_T({}, 0.05);
    const SphericalFieldStrength k = sphericalFieldStrength({});
    const Eigen::Matrix3d tensor = Eigen::Vector3d(q, -q, 0.0).asDiagonal();
    for (const double radius : {0.047, 0.05, 0.06}) {
        for (double theta = 0.1; theta < 3.1; theta += 0.37) {
            for (double phi = -3.0; phi < 3.1; phi += 0.51) {
                const double st = std::sin(theta);
                const double ct = std::cos(theta);
                const double sp = std::sin(phi);
                const double cp = std::cos(phi);
                const Eigen::Vector3d eR(st * cp, st * sp, ct);
                const Eigen::Vector3d eTheta(ct * cp, ct * sp, -st);
                const Eigen::Vector3d ePhi(-sp, cp, 0.0);
                const double fall = std::pow(radius, -4);
                const Eigen::Vector3d expected =
                    fall * (k.radial_T_m4 * st * st * std::cos(2 * phi) * eR +
                            k.polar_T_m4 * std::sin(2 * theta) * std::cos(2 * phi) * eTheta +
                            k.azimuthal_T_m4 * st * std::sin(2 * phi) * ePhi);
                // Rounding of a dozen operations on 0.4 T.
                EXPECT_LT((tensorField_T(tensor, 0.05, radius * eR) - expected).norm(), 1e-13);
            }
        }
    }
}

/// The printed shapes U and their derivatives, in s and c.
struct Shape {
    int degree;
    int order;
    std::function<double(double, double)> value;
    std::function<double(double, double)> slope;
};

const std::vector<Shape>& shapes() {
    static const std::vector<Shape> list = {
        {2, 2, [](double s, double) { return s * s; }, [](double s, double c) { return 2 * s * c; }},
        {4, 2, [](double s, double c) { return s * s * (7 * c * c - 1); },
         [](double s, double c) { return 2 * s * c * (7 * c * c - 1) - 14 * s * s * s * c; }},
        {6, 2, [](double s, double c) { return s * s * (33 * std::pow(c, 4) - 18 * c * c + 1); },
         [](double s, double c) {
             return 2 * s * c * (33 * std::pow(c, 4) - 18 * c * c + 1) -
                    s * s * s * (132 * c * c * c - 36 * c);
         }},
        {6, 6, [](double s, double) { return std::pow(s, 6); },
         [](double s, double c) { return 6 * std::pow(s, 5) * c; }},
        {10, 10, [](double s, double) { return std::pow(s, 10); },
         [](double s, double c) { return 10 * std::pow(s, 9) * c; }}};
    return list;
}

TEST(SphericalHarmonicTerm, solidHarmonicsFollowThePrintedShapes) {
    for (const Shape& shape : shapes()) {
        const double amplitude = 2e-3;
        const SphericalHarmonicSeries series({{shape.degree, shape.order, amplitude}}, 0.05);
        const double l1 = shape.degree + 1.0;
        for (double theta = 0.05; theta < 3.1; theta += 0.29) {
            const double phi = 0.7 + theta;
            const double radius = 0.05 + 0.003 * theta;
            const double s = std::sin(theta);
            const double c = std::cos(theta);
            const Eigen::Vector3d eR(s * std::cos(phi), s * std::sin(phi), c);
            const Eigen::Vector3d eTheta(c * std::cos(phi), c * std::sin(phi), -s);
            const Eigen::Vector3d ePhi(-std::sin(phi), std::cos(phi), 0.0);
            const double fall = amplitude * std::pow(0.05 / radius, shape.degree + 2);
            const double m = shape.order;
            const Eigen::Vector3d expected =
                fall * (shape.value(s, c) * std::cos(m * phi) * eR -
                        shape.slope(s, c) / l1 * std::cos(m * phi) * eTheta +
                        m / l1 * shape.value(s, c) / s * std::sin(m * phi) * ePhi);
            // Rounding relative to the largest coefficient, 33 times 2 mT.
            EXPECT_LT((series.field_T(radius * eR) - expected).norm(), 1e-15) << shape.degree << shape.order;
        }
    }
}

TEST(SphericalHarmonicTerm, degreeTwoIsTheTensorOfTheRotor) {
    const double q = 0.0991864782;
    const SphericalHarmonicSeries series({{2, 2, 3.0 * q}}, 0.05);
    const Eigen::Matrix3d tensor = Eigen::Vector3d(q, -q, 0.0).asDiagonal();
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0.03, -0.02, 0.04), Eigen::Vector3d(0.0, 0.0, 0.05), Eigen::Vector3d(0, 0.06, 0)}) {
        EXPECT_LT((series.field_T(point) - tensorField_T(tensor, 0.05, point)).norm(), 1e-15);
    }
}

TEST(SphericalHarmonicTerm, fieldHasNoCurlAndNoDivergenceAndTheGradientIsItsDerivative) {
    std::vector<SphericalHarmonicTerm> terms = harmonicPreset(HarmonicPreset::H1);
    terms.push_back({5, 0, 1e-3});
    terms.push_back({3, 1, 1e-3});
    for (const SphericalHarmonicTerm& term : terms) {
        const SphericalHarmonicSeries series({term}, 0.05);
        for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.03, -0.02, 0.04),
                                             Eigen::Vector3d(0.0, 0.0, 0.05), Eigen::Vector3d(0.05, 0, 0)}) {
            const HarmonicField both = series.fieldAndGradient(point);
            EXPECT_LT((both.field_T - series.field_T(point)).norm(), 1e-16);
            // Analytic gradient: trace is the divergence, the skew part the curl; slopes are about 1 T/m.
            EXPECT_LT(std::abs(both.gradient_T_per_m.trace()), 1e-13);
            EXPECT_LT((both.gradient_T_per_m - both.gradient_T_per_m.transpose()).norm(), 1e-13);
            for (int k = 0; k < 3; ++k) {
                const double h = 1e-6; // central differences: error h^2 l^3/r^3 1e-3 T = 1e-8 T/m
                const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
                const Eigen::Vector3d slope =
                    (series.field_T(point + step) - series.field_T(point - step)) / (2 * h);
                EXPECT_LT((slope - both.gradient_T_per_m.col(k)).norm(), 1e-7);
            }
        }
    }
}

TEST(SphericalHarmonicTerm, refusesImpossibleTerms) {
    EXPECT_TRUE(checkHarmonicTerm({10, 10, 1e-3}).has_value());
    EXPECT_EQ(checkHarmonicTerm({2, 3, 1e-3}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(checkHarmonicTerm({17, 2, 1e-3}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(checkHarmonicTerm({4, 2, std::nan("")}).error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::models
