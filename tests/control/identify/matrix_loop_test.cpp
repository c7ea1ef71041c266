#include "control/base/random.h"
#include "control/base/units.h"
#include "control/identify/matrix_loop.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

MatrixPoint exactPoint(double w, const Eigen::MatrixXcd& G) {
    MatrixPoint point;
    point.frequency_rad_s = w;
    point.value = G;
    point.radius = Eigen::MatrixXd::Zero(G.rows(), G.cols());
    point.coherence = Eigen::VectorXd::Ones(G.rows());
    point.scatter = Eigen::MatrixXcd::Zero(G.rows(), G.rows());
    point.inverse = Eigen::MatrixXcd::Identity(G.cols(), G.cols());
    point.averages = 8;
    point.freedom = 42.0;
    return point;
}

MatrixLoopPoint closeOne(const MatrixPoint& point, const Eigen::VectorXcd& controller,
                         const Eigen::VectorXd& scale) {
    const std::vector<MatrixPoint> plant = {point};
    const std::vector<Eigen::VectorXcd> controllers = {controller};
    return closeMatrixLoops(plant, controllers, scale).front();
}

Eigen::Matrix3cd coupled() {
    Eigen::Matrix3cd G;
    G << Complex(-1.2, -0.9), Complex(0.2, 0.1), Complex(-0.1, 0.3),  //
        Complex(0.05, -0.2), Complex(-0.7, -1.1), Complex(0.15, 0.0), //
        Complex(0.3, 0.2), Complex(-0.25, 0.1), Complex(-0.4, -0.6);
    return G;
}

const Eigen::Vector3cd Laws(Complex(0.9, 0.4), Complex(1.1, -0.2), Complex(0.8, 0.6));

TEST(MatrixLoop, axesWithoutCouplingAreTheirOwnLoops) {
    const Eigen::Vector3cd g(Complex(-1.0, -1.0), Complex(0.2, -2.0), Complex(-0.1, -0.3));
    const Eigen::MatrixXcd G = g.asDiagonal();
    const Eigen::Vector3d scale(1.0, 20.0, 1e-3); // nothing of it is seen without coupling
    const MatrixLoopPoint point = closeOne(exactPoint(3.0, G), Laws, scale);
    double largestS = 0.0;
    double largestT = 0.0;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Complex l = g(i) * Laws(i);
        EXPECT_LT(std::abs(point.loops[static_cast<std::size_t>(i)].value - l), 1e-13);
        largestS = std::max(largestS, 1.0 / std::abs(1.0 + l));
        largestT = std::max(largestT, std::abs(l / (1.0 + l)));
    }
    EXPECT_NEAR(point.sensitivity.value.real(), largestS, 1e-13);
    EXPECT_NEAR(point.complementary.value.real(), largestT, 1e-13);
}

// Closing u2, u3 = -C y leaves the Schur complement of the two other loops: another route than 1/S_ii - 1.
TEST(MatrixLoop, theLoopOfOneAxisHasTheOthersClosed) {
    const Eigen::Matrix3cd L = coupled() * Laws.asDiagonal();
    const MatrixLoopPoint point = closeOne(exactPoint(3.0, coupled()), Laws, Eigen::Vector3d::Ones());
    const Eigen::Matrix2cd others = Eigen::Matrix2cd::Identity() + L.bottomRightCorner<2, 2>();
    const Complex expected =
        L(0, 0) - (L.topRightCorner<1, 2>() * others.inverse() * L.bottomLeftCorner<2, 1>())(0, 0);
    EXPECT_LT(std::abs(point.loops[0].value - expected), 1e-13);
    EXPECT_GT(std::abs(point.loops[0].value - L(0, 0)), 0.01); // the coupling counts here
}

TEST(MatrixLoop, lociMultiplyToTheDeterminantOfTheReturnDifference) {
    const MatrixLoopPoint point = closeOne(exactPoint(3.0, coupled()), Laws, Eigen::Vector3d(1.0, 5.0, 0.1));
    Complex product = 1.0;
    for (const LoopFigure& locus : point.loci) {
        product *= 1.0 + locus.value;
    }
    EXPECT_LT(std::abs(product - point.returnDifference), 1e-12);
}

// S + T = I, and the scale is a change of units: with positions of axis i counted in units of scale_i, the
// plant is D^-1 G, the laws are C D, and no scale remains.
TEST(MatrixLoop, theScaleIsAChangeOfUnits) {
    const Eigen::Vector3d scale(1e-3, 2e-3, 5e-3);
    const MatrixLoopPoint scaled = closeOne(exactPoint(3.0, coupled()), Laws, scale);
    const Eigen::MatrixXcd G = scale.cwiseInverse().asDiagonal() * coupled();
    const Eigen::VectorXcd laws = scale.asDiagonal() * Laws;
    const MatrixLoopPoint inUnits = closeOne(exactPoint(3.0, G), laws, Eigen::Vector3d::Ones());
    EXPECT_NEAR(scaled.sensitivity.value.real(), inUnits.sensitivity.value.real(), 1e-12);
    EXPECT_NEAR(scaled.complementary.value.real(), inUnits.complementary.value.real(), 1e-12);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(std::abs(scaled.loops[i].value - inUnits.loops[i].value), 1e-12);
    }
    const Eigen::Matrix3cd L = coupled() * Laws.asDiagonal();
    const Eigen::Matrix3cd S = (Eigen::Matrix3cd::Identity() + L).inverse();
    const Eigen::Matrix3cd T = Eigen::Matrix3cd::Identity() - S;
    const Eigen::Matrix3cd unscaledT = scale.cwiseInverse().asDiagonal() * T * scale.asDiagonal();
    EXPECT_NEAR(scaled.complementary.value.real(),
                Eigen::JacobiSVD<Eigen::MatrixXcd>(unscaledT).singularValues()(0), 1e-12);
}

// Two loci that cross in magnitude between two points keep their places by continuity of ln(lambda).
TEST(MatrixLoop, lociContinueFromPointToPoint) {
    std::vector<MatrixPoint> plant;
    std::vector<Eigen::VectorXcd> laws;
    for (const double w : {1.0, 2.0, 4.0}) {
        const Eigen::Vector2cd g(Complex(0.0, -2.0 / w), Complex(-3.0 / (w * w), 0.0));
        plant.push_back(exactPoint(w, Eigen::MatrixXcd(g.asDiagonal())));
        laws.emplace_back(Eigen::Vector2cd::Ones());
    }
    const auto points = closeMatrixLoops(plant, laws, Eigen::Vector2d::Ones());
    const std::size_t first = std::abs(points[0].loci[0].value - Complex(0.0, -2.0)) < 1e-12 ? 0 : 1;
    EXPECT_LT(std::abs(points[2].loci[first].value - Complex(0.0, -0.5)), 1e-12);
    EXPECT_LT(std::abs(points[2].loci[1 - first].value - Complex(-3.0 / 16.0, 0.0)), 1e-12);
}

// Plants drawn from the scatter that a point tells, small enough for first derivatives. The circle of a
// complex figure holds 95 %; that of a real one, of which the scatter is a diameter's, holds more.
TEST(MatrixLoop, radiiHoldTheFiguresOfPlantsThatScatterAsTold) {
    MatrixPoint told = exactPoint(3.0, coupled());
    told.freedom = 1e6; // a known variance: F(2, inf)
    Eigen::Matrix3cd root;
    root << Complex(2e-3, 0.0), Complex(0.0, 0.0), Complex(0.0, 0.0), //
        Complex(5e-4, 3e-4), Complex(1e-3, 0.0), Complex(0.0, 0.0),   //
        Complex(-2e-4, 8e-4), Complex(3e-4, -1e-4), Complex(1.5e-3, 0.0);
    told.scatter = root * root.adjoint();
    told.inverse << Complex(1.0, 0.2), Complex(0.1, 0.0), Complex(0.0, -0.3), //
        Complex(0.2, 0.1), Complex(0.8, 0.0), Complex(0.1, 0.1),              //
        Complex(0.0, 0.0), Complex(-0.2, 0.1), Complex(1.3, 0.0);
    const Eigen::Vector3d scale(1.0, 2.0, 0.5);
    const MatrixLoopPoint expected = closeOne(told, Laws, scale);
    Random random(11);
    constexpr int Draws = 4000;
    std::array<int, 3> loops{};
    std::array<int, 3> loci{};
    int sensitivity = 0;
    int complementary = 0;
    for (int draw = 0; draw < Draws; ++draw) {
        Eigen::Matrix3cd unit;
        for (Eigen::Index i = 0; i < 9; ++i) { // circular, of variance 1
            unit(i) = Complex(random.gaussian(), random.gaussian()) / std::sqrt(2.0);
        }
        MatrixPoint drawn = told;
        drawn.value += root * unit * told.inverse;
        const std::vector<MatrixPoint> plant = {told, drawn};
        const std::vector<Eigen::VectorXcd> laws = {Laws, Laws};
        const MatrixLoopPoint seen = closeMatrixLoops(plant, laws, scale)[1];
        for (std::size_t i = 0; i < 3; ++i) {
            loops[i] += std::abs(seen.loops[i].value - expected.loops[i].value) <= expected.loops[i].radius;
            loci[i] += std::abs(seen.loci[i].value - expected.loci[i].value) <= expected.loci[i].radius;
        }
        sensitivity +=
            std::abs(seen.sensitivity.value - expected.sensitivity.value) <= expected.sensitivity.radius;
        complementary += std::abs(seen.complementary.value - expected.complementary.value) <=
                         expected.complementary.radius;
    }
    // 0.95 +- 4 sqrt(0.95 0.05/4000), 0.936 ... 0.964; of a real figure sqrt(2 ln 20 ) = 2.45 deviations.
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(loops[i], 0.95 * Draws, 0.014 * Draws);
        EXPECT_NEAR(loci[i], 0.95 * Draws, 0.014 * Draws);
    }
    EXPECT_NEAR(sensitivity, 0.9857 * Draws, 0.01 * Draws);
    EXPECT_NEAR(complementary, 0.9857 * Draws, 0.01 * Draws);
}

} // namespace
} // namespace halbench::control
