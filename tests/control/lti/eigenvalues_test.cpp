#include "control/lti/eigenvalues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

TEST(Eigenvalues, ofATriangleAreItsDiagonal) {
    const Eigen::Matrix3d A{{-1.0, 1e6, 2.0}, {0.0, -2.0, 1e-3}, {0.0, 0.0, -5.0}};
    auto values = eigenvalues(A);
    std::sort(values.begin(), values.end(), [](auto a, auto b) { return a.real() > b.real(); });
    EXPECT_NEAR(values[0].real(), -1.0, 1e-12);
    EXPECT_NEAR(values[1].real(), -2.0, 1e-12);
    EXPECT_NEAR(values[2].real(), -5.0, 1e-12);
    EXPECT_TRUE(eigenvalues(Eigen::MatrixXd(0, 0)).empty());
}

TEST(Eigenvalues, balancingIsExactAndEvensTheRows) {
    const Eigen::Matrix2d A{{1.0, 1e8}, {1e-8, 2.0}};
    const Eigen::VectorXd scale = balancingScale(A);
    const Eigen::Matrix2d balanced = scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal();
    EXPECT_LT(balanced.cwiseAbs().maxCoeff(), 3.0);
    for (const double factor : scale) {
        EXPECT_EQ(std::exp2(std::round(std::log2(factor))), factor);
    }
}

TEST(Eigenvalues, infiniteOnesOfAPencilAreLeftOut) {
    const Eigen::Matrix2d A{{2.0, 1.0}, {0.0, 1.0}};
    const Eigen::Matrix2d B{{1.0, 0.0}, {0.0, 0.0}};
    const auto values = generalizedEigenvalues(A, B);
    ASSERT_EQ(values.size(), 1u);
    EXPECT_NEAR(std::abs(values[0] - 2.0), 0.0, 1e-14);
}

} // namespace
} // namespace halbench::control
