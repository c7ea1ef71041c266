#include "control/identify/matrix_loop.h"

#include "control/base/assert.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <limits>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

/// Columns of X in the order in which their values continue `before`.
std::vector<Eigen::Index> continuedOrder(const Eigen::VectorXcd& values,
                                         const std::vector<LoopFigure>& before) {
    std::vector<Eigen::Index> order;
    std::vector<bool> isTaken(static_cast<std::size_t>(values.size()), false);
    for (Eigen::Index place = 0; place < values.size(); ++place) {
        Eigen::Index nearest = place;
        double least = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < values.size(); ++i) {
            const auto index = static_cast<std::size_t>(i);
            // Along a logarithmic axis, where loci of very different size move alike.
            const double away =
                before.empty()
                    ? static_cast<double>(i)
                    : std::abs(std::log(values(i) / before[static_cast<std::size_t>(place)].value));
            if (!isTaken[index] && away < least) {
                least = away;
                nearest = i;
            }
        }
        isTaken[static_cast<std::size_t>(nearest)] = true;
        order.push_back(nearest);
    }
    return order;
}

std::vector<LoopFigure> lociOf(const MatrixPoint& plant, const Eigen::VectorXcd& controller,
                               const Eigen::MatrixXcd& L, const std::vector<LoopFigure>& before) {
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(L);
    const Eigen::MatrixXcd& right = solver.eigenvectors();
    const Eigen::MatrixXcd left = right.inverse(); // rows y^H with y^H x = 1
    std::vector<LoopFigure> loci;
    for (const Eigen::Index i : continuedOrder(solver.eigenvalues(), before)) {
        loci.push_back({solver.eigenvalues()(i), scatterRadius(plant, left.row(i).transpose(),
                                                               controller.asDiagonal() * right.col(i))});
    }
    return loci;
}

/// Largest singular value of D^-1 F D, where dF = -+S dG C S.
LoopFigure largestOf(const Eigen::MatrixXcd& F, const Eigen::MatrixXcd& S, const MatrixPoint& plant,
                     const Eigen::VectorXcd& controller, const Eigen::VectorXd& scale) {
    const Eigen::MatrixXcd scaled = scale.cwiseInverse().asDiagonal() * F * scale.asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(scaled, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::VectorXcd left =
        (svd.matrixU().col(0).adjoint() * scale.cwiseInverse().asDiagonal() * S).transpose();
    const Eigen::VectorXcd right =
        controller.asDiagonal() * (S * (scale.asDiagonal() * svd.matrixV().col(0)));
    return {svd.singularValues()(0), scatterRadius(plant, left, right)};
}

MatrixLoopPoint closed(const MatrixPoint& plant, const Eigen::VectorXcd& controller,
                       const Eigen::VectorXd& scale, const std::vector<LoopFigure>& lociBefore) {
    const Eigen::Index n = plant.value.rows();
    HB_ASSERT(plant.value.cols() == n && controller.size() == n && scale.size() == n);
    MatrixLoopPoint point;
    point.frequency_rad_s = plant.frequency_rad_s;
    point.openLoop = plant.value * controller.asDiagonal();
    const Eigen::MatrixXcd difference = Eigen::MatrixXcd::Identity(n, n) + point.openLoop;
    point.returnDifference = difference.determinant();
    const Eigen::MatrixXcd S = difference.inverse();
    for (Eigen::Index i = 0; i < n; ++i) {
        const Complex own = S(i, i);
        const Eigen::VectorXcd left = S.row(i).transpose() / (own * own);
        const Eigen::VectorXcd right = controller.asDiagonal() * S.col(i);
        point.loops.push_back({1.0 / own - 1.0, scatterRadius(plant, left, right)});
    }
    point.loci = lociOf(plant, controller, point.openLoop, lociBefore);
    point.sensitivity = largestOf(S, S, plant, controller, scale);
    point.complementary = largestOf(point.openLoop * S, S, plant, controller, scale);
    return point;
}

} // namespace

std::vector<MatrixLoopPoint> closeMatrixLoops(std::span<const MatrixPoint> plant,
                                              std::span<const Eigen::VectorXcd> controllers,
                                              const Eigen::VectorXd& scale) {
    HB_ASSERT(plant.size() == controllers.size());
    std::vector<MatrixLoopPoint> points;
    for (std::size_t i = 0; i < plant.size(); ++i) {
        points.push_back(closed(plant[i], controllers[i], scale,
                                points.empty() ? std::vector<LoopFigure>() : points.back().loci));
    }
    return points;
}

} // namespace halbench::control
