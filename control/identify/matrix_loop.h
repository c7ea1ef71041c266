#pragma once

#include "control/identify/matrix_response.h"

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

namespace halbench::control {

/// A number of a loop with the radius of its 95 % circle.
struct LoopFigure {
    std::complex<double> value;
    double radius = 0.0;
};

/// Loops of several axes at one frequency: L = G C with a law of its own on each axis.
struct MatrixLoopPoint {
    double frequency_rad_s = 0.0;
    Eigen::MatrixXcd openLoop;             ///< L, from position to position
    std::vector<LoopFigure> loops;         ///< of each axis while the loops of the others are closed
    std::vector<LoopFigure> loci;          ///< eigenvalues of L, in the order that continues the point before
    LoopFigure sensitivity;                ///< largest singular value of S = (I + L)^-1
    LoopFigure complementary;              ///< largest singular value of T = L (I + L)^-1
    std::complex<double> returnDifference; ///< det(I + L)
};

/// The loops that laws make of a measured plant. With S = (I + L)^-1, the loop of axis i, cut open while the
/// others stay closed, is
///
///     l_i = 1/S_ii - 1
///
/// (Skogestad and Postlethwaite 2005, section 3.7). Positions of different axes have different units: the
/// singular values are those of D^-1 S D and D^-1 T D with D = diag(scale); eigenvalues and l_i do not depend
/// on it. Each radius is the scatter of the plant carried along the first derivative of the figure, of
/// the form left^T dG right. `controllers`: for each point the responses of the laws, the delay included.
/// The matrices must be square. Complexity: n^3 a point.
std::vector<MatrixLoopPoint> closeMatrixLoops(std::span<const MatrixPoint> plant,
                                              std::span<const Eigen::VectorXcd> controllers,
                                              const Eigen::VectorXd& scale);

} // namespace halbench::control
