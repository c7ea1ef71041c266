#include "control/base/random.h"
#include "control/base/units.h"
#include "control/lti/polynomial.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

double distanceToNearest(const std::vector<Complex>& set, Complex point) {
    double nearest = HUGE_VAL;
    for (const Complex& candidate : set) {
        nearest = std::min(nearest, std::abs(candidate - point));
    }
    return nearest;
}

/// Second route: eigenvalues of the companion matrix.
std::vector<Complex> companionRoots(const Polynomial& p) {
    const auto n = static_cast<Eigen::Index>(p.size()) - 1;
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        companion(0, i) = -p[static_cast<std::size_t>(i) + 1] / p[0];
        if (i > 0) {
            companion(i, i - 1) = 1.0;
        }
    }
    const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues();
    return {values.data(), values.data() + values.size()};
}

TEST(Polynomial, findsTheRootsItWasMadeFrom) {
    const std::vector<Complex> wanted = {{-1.0, 2.0}, {-1.0, -2.0}, {0.5, 0.0}, {-300.0, 0.0}, {0.0, 0.0}};
    const auto found = roots(fromRoots(wanted));
    ASSERT_EQ(found.size(), wanted.size());
    for (const Complex& root : wanted) {
        // Coefficients of 300 and of one in the same sum: some five digits of sixteen.
        EXPECT_LT(distanceToNearest(found, root), 1e-10 * (1.0 + std::abs(root)));
    }
}

TEST(Polynomial, agreesWithTheCompanionMatrixOnRandomPolynomials) {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        Polynomial p(3 + random.below(6));
        for (double& coefficient : p) {
            coefficient = random.gaussian();
        }
        const auto reference = companionRoots(p);
        const auto found = roots(p);
        ASSERT_EQ(found.size(), reference.size());
        for (const Complex& root : reference) {
            // Both routes lose digits where roots lie close together.
            EXPECT_LT(distanceToNearest(found, root), 1e-6 * (1.0 + std::abs(root)));
        }
    }
}

TEST(Polynomial, rootsAtZeroAreExactAndComplexRootsConjugate) {
    const auto found = roots({1.0, 2.0, 5.0, 0.0, 0.0});
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(std::count(found.begin(), found.end(), Complex(0.0, 0.0)), 2);
    for (const Complex& root : found) {
        EXPECT_NE(std::find(found.begin(), found.end(), std::conj(root)), found.end());
    }
}

TEST(Polynomial, findsADoubleRootToTheSquareRootOfTheRounding) {
    for (const Complex& root : roots({1.0, -4.0, 4.0})) {
        EXPECT_LT(std::abs(root - 2.0), 2e-7); // sqrt(2e-16 x 16)
    }
}

// Three sampled integrators, a computing delay's ringing pole at -1 and a slow plant beside them.
TEST(Polynomial, findsManySampledIntegratorsExactly) {
    const auto found = roots(fromRoots({{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.9998, 0.0}}));
    EXPECT_EQ(std::count(found.begin(), found.end(), Complex(1.0, 0.0)), 3);
    EXPECT_EQ(std::count(found.begin(), found.end(), Complex(-1.0, 0.0)), 1);
    EXPECT_LT(distanceToNearest(found, {0.9998, 0.0}), 1e-9);
}

TEST(Polynomial, findsRootsTwelveDecadesApart) {
    const auto found = roots(fromRoots({{-1e-6, 0.0}, {-1.0, 0.0}, {-1e6, 0.0}}));
    for (const double root : {-1e-6, -1.0, -1e6}) {
        EXPECT_LT(distanceToNearest(found, root), 1e-8 * std::abs(root)); // the middle one keeps fewer
    }
}

// Found as a crash of the root locus: without the root at 1 nothing of the other one is left in doubles.
TEST(Polynomial, findsARootThatIsNothingBesideOne) {
    const auto found = roots({1.0, -1.0, 1e-17});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], 1.0);
    EXPECT_NEAR(std::abs(found[1]), 0.0, 1e-16);
}

TEST(Polynomial, dropsLeadingZerosAndKeepsTheZeroPolynomial) {
    EXPECT_EQ(trimmed({0.0, 0.0, 3.0}), Polynomial{3.0});
    EXPECT_EQ(trimmed({0.0, 0.0}), Polynomial{0.0});
    EXPECT_EQ(add({1.0, 2.0}, {-1.0, 1.0}), Polynomial{3.0});
    EXPECT_TRUE(roots({4.0}).empty());
}

} // namespace
} // namespace halbench::control
